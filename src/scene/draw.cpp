#include "scene/draw.h"

#include <cstring>

#include "scene/box_work.h"
#include "scene/reach.h"

namespace selvage::scene {
namespace {

[[nodiscard]] selvage_texture texture_of(const Scene& scene, const ScreenFace& face,
                                         const Plan& plan, const selvage_rect& clip,
                                         Paints& paints) {
  if (!face.paint.texture) return paints.texture(face.paint);
  const TextureImage& image = scene.textures[*face.paint.texture];
  return paints.texture(face.paint, reach_texel(image, face, plan),
                        spared_texels(image, vertices_to_draw(face, plan), plan.options, clip));
}

}  // namespace

Drawing compose(const Scene& scene, double time_s, Size size, const Wish& wish, Hidden way) {
  Drawing drawing;
  drawing.view = look(scene, time_s, size);
  for (const ScreenFace& face : drawing.view.faces) {
    drawing.plans.push_back(plan(scene, face, wish));
  }
  drawing.pieces = visible_pieces(way, drawing.view.faces, size);
  return drawing;
}

void clear(const Scene& scene, const selvage_image& target) {
  const Colour& colour = scene.background;
  const uint8_t pixel[] = {colour.red, colour.green, colour.blue, colour.alpha};
  for (int32_t y = 0; y < target.height; ++y) {
    auto* row = static_cast<uint8_t*>(target.pixels) + y * target.pitch;
    for (int32_t x = 0; x < target.width; ++x) std::memcpy(row + x * 4, pixel, sizeof pixel);
  }
}

selvage_status draw(const Scene& scene, const Drawing& drawing, const selvage_image& target) {
  clear(scene, target);
  Paints paints(scene, kLitBytes);
  return draw_pieces(scene, drawing, target, paints);
}

selvage_status draw_pieces(const Scene& scene, const Drawing& drawing, const selvage_image& target,
                           Paints& paints) {
  for (const Piece& piece : drawing.pieces) {
    const ScreenFace& face = drawing.view.faces[piece.face];
    const Plan& plan = drawing.plans[piece.face];
    const std::vector<selvage_vertex> vertices = vertices_to_draw(face, plan);
    const selvage_texture texture = texture_of(scene, face, plan, piece.clip, paints);
    const selvage_status status = selvage_draw(&target, &piece.clip, vertices.data(),
                                               vertices.size(), &texture, &plan.options);
    if (status != SELVAGE_OK) return status;
  }
  return SELVAGE_OK;
}

}  // namespace selvage::scene
