#include "reports/scenes/cost.h"

namespace selvage::reports {

Calls::Calls(const scene::Scene& scene, const scene::Drawing& drawing) : paints_(scene) {
  for (const scene::Piece& piece : drawing.pieces) {
    const scene::ScreenFace& face = drawing.view.faces[piece.face];
    const scene::Plan& plan = drawing.plans[piece.face];
    calls_.push_back({vertices_to_draw(face, plan), paints_.texture(face.paint), piece.clip,
                      plan.options, face.paint.texture.has_value()});
  }
}

// The statuses were looked at when the picture was judged: the same calls.
void Calls::draw(const selvage_image& target, bool textured_only) const {
  for (const Call& call : calls_) {
    if (textured_only && !call.textured) continue;
    static_cast<void>(selvage_draw(&target, &call.clip, call.vertices.data(), call.vertices.size(),
                                   &call.texture, &call.options));
  }
}

}  // namespace selvage::reports
