#include "cli/profile_drawing.h"

#include <utility>
#include <vector>

#include "cli/error.h"
#include "scene/paints.h"
#include "spec/profiles.h"

namespace selvage::cli {
namespace {

using Vertices = std::vector<selvage_vertex>;

void expect_ok(selvage_status status) {
  if (status != SELVAGE_OK) throw UserError(selvage_status_text(status));
}

[[nodiscard]] Bitmap blank(scene::Size size) {
  const size_t area = static_cast<size_t>(size.width_px) * static_cast<size_t>(size.height_px);
  return {SELVAGE_RGBA8888, size.width_px, size.height_px, std::vector<uint8_t>(4 * area)};
}

// A face for the profile, or for the exact one where that refuses it.
struct Outlined {
  Vertices vertices;
  selvage_options options;
};

[[nodiscard]] Vertices in_profile(const scene::ScreenFace& face, selvage_profile profile) {
  spec::Case exact;
  exact.vertices = face.vertices;
  return spec::in_profile(exact, profile).vertices;
}

// Where the exact profile, which samples at centres, covers what this one covers at its samples.
void move_to_coverage(const spec::Profile& profile, Vertices& vertices) {
  for (selvage_vertex& v : vertices) {
    v.x = (v.x & ~(SELVAGE_SUBPIXELS - 1)) + SELVAGE_SUBPIXELS / 2 - profile.sample_fx8;
    v.y = (v.y & ~(SELVAGE_SUBPIXELS - 1)) + SELVAGE_SUBPIXELS / 2 - profile.sample_fx8;
  }
}

// Every check of the call is made before it finds that nothing is to be drawn.
[[nodiscard]] bool accepts(const selvage_image& target, const Outlined& outlined,
                           const selvage_texture& texture) {
  const selvage_rect nothing{};
  return selvage_draw(&target, &nothing, outlined.vertices.data(), outlined.vertices.size(),
                      &texture, &outlined.options) == SELVAGE_OK;
}

[[nodiscard]] ProfileDrawing draw_historic(const scene::Scene& scene, scene::Drawing drawing,
                                           scene::Size size, selvage_profile profile) {
  ProfileDrawing drawn{blank(size), drawing.view.faces.size(), 0};
  const selvage_image image = drawn.picture.image();
  scene::Drawing background;
  expect_ok(draw(scene, background, image));
  scene::Paints paints(scene);
  std::vector<Outlined> outlines;
  for (size_t i = 0; i < drawing.view.faces.size(); ++i) {
    scene::ScreenFace& face = drawing.view.faces[i];
    Outlined outlined{in_profile(face, profile), {}};
    outlined.options.profile = profile;
    outlined.options.address = drawing.plans[i].options.address;
    if (accepts(image, outlined, paints.texture(face.paint))) {
      move_to_coverage(spec::profile_of(profile), face.vertices);
    } else {
      ++drawn.refused;
      outlined = {vertices_to_draw(face, drawing.plans[i]), drawing.plans[i].options};
    }
    outlines.push_back(std::move(outlined));
  }
  for (const scene::Piece& piece :
       visible_pieces(scene::Hidden::kScanLine, drawing.view.faces, size)) {
    const Outlined& outlined = outlines[piece.face];
    const selvage_texture texture = paints.texture(drawing.view.faces[piece.face].paint);
    expect_ok(selvage_draw(&image, &piece.clip, outlined.vertices.data(), outlined.vertices.size(),
                           &texture, &outlined.options));
  }
  return drawn;
}

}  // namespace

ProfileDrawing draw_by_profile(const scene::Scene& scene, double time_s, scene::Size size,
                               const scene::Wish& wish, selvage_profile profile) {
  scene::Drawing drawing = compose(scene, time_s, size, wish, scene::Hidden::kScanLine);
  if (profile != SELVAGE_PROFILE_EXACT) {
    return draw_historic(scene, std::move(drawing), size, profile);
  }
  ProfileDrawing drawn{blank(size), drawing.view.faces.size(), 0};
  expect_ok(draw(scene, drawing, drawn.picture.image()));
  return drawn;
}

}  // namespace selvage::cli
