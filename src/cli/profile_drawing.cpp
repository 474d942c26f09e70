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

[[nodiscard]] ProfileDrawing draw_historic(const scene::Scene& scene, scene::Drawing drawing,
                                           scene::Size size, selvage_profile profile,
                                           scene::Paints& paints) {
  std::vector<scene::ScreenFace>& faces = drawing.view.faces;
  ProfileDrawing drawn{blank(size), faces.size()};
  const selvage_image image = drawn.picture.image();
  expect_ok(draw(scene, scene::Drawing{}, image));  // the background
  std::vector<Vertices> outlines;
  for (scene::ScreenFace& face : faces) {
    outlines.push_back(in_profile(face, profile));
    move_to_coverage(spec::profile_of(profile), face.vertices);
  }
  for (const scene::Piece& piece : visible_pieces(scene::Hidden::kScanLine, faces, size)) {
    const Vertices& vertices = outlines[piece.face];
    const selvage_texture texture = paints.texture(faces[piece.face].paint);
    selvage_options options{};
    options.profile = profile;
    options.address = drawing.plans[piece.face].options.address;
    expect_ok(
        selvage_draw(&image, &piece.clip, vertices.data(), vertices.size(), &texture, &options));
  }
  return drawn;
}

}  // namespace

ProfileDrawing draw_by_profile(const scene::Scene& scene, double time_s, scene::Size size,
                               const scene::Wish& wish, selvage_profile profile,
                               scene::Paints& paints) {
  scene::Drawing drawing = compose(scene, time_s, size, wish, scene::Hidden::kScanLine);
  if (profile != SELVAGE_PROFILE_EXACT) {
    return draw_historic(scene, std::move(drawing), size, profile, paints);
  }
  ProfileDrawing drawn{blank(size), drawing.view.faces.size()};
  const selvage_image image = drawn.picture.image();
  clear(scene, image);
  expect_ok(draw_pieces(scene, drawing, image, paints));
  return drawn;
}

ProfileDrawing draw_by_profile(const scene::Scene& scene, double time_s, scene::Size size,
                               const scene::Wish& wish, selvage_profile profile) {
  scene::Paints paints(scene, scene::kLitBytes);
  return draw_by_profile(scene, time_s, size, wish, profile, paints);
}

}  // namespace selvage::cli
