// What the makers of hard cases share: sizes, outlines, and maps of the texture.
#pragma once

#include <cstdint>

#include "spec/case.h"
#include "spec/generate_shapes.h"
#include "spec/random.h"
#include "spec/shape_families.h"
#include "spec/vertex_units.h"

namespace selvage::spec {

// What the seed itself decides, and a stream for the rest.
struct Draft {
  explicit Draft(uint64_t seed) : random(seed), whole_px(seed % 2 == 0), small(seed / 2 % 2 == 0) {}

  Random random;
  bool whole_px;  // vertices on whole pixels
  bool small;     // a target of at most kSmallTargetPx

  // The grid that vertices lie on.
  [[nodiscard]] int32_t grid_fx8() const { return whole_px ? kPixel_fx8 : 1; }
  // On that grid, from first_px to last_px, both included.
  [[nodiscard]] int32_t place_fx8(int32_t first_px, int32_t last_px);
};

struct TextureSize {
  int32_t width_texel, height_texel;
};

// RGBA8888, clamped, unclipped, no vertex yet.
[[nodiscard]] Case start(Draft& draft, Frame target, TextureSize texture);

// A target for polygons that are seen whole, and a texture of a texel or two to each of its pixels.
[[nodiscard]] Frame screen(Draft& draft);
[[nodiscard]] TextureSize screen_texture(const Draft& draft);

// Vertices at the places of the outline, q = 1.
void set_outline(Case* c, const Outline& outline);

// A convex quadrilateral with a corner in each corner of the frame, on a grid of its own.
[[nodiscard]] Outline quadrilateral(Random& random, Frame frame, int32_t grid_fx8);
// That, or a triangle of three of its corners.
[[nodiscard]] Outline one_of_few_corners(Draft& draft, Frame frame);
// from, from + a, from + a + b, from + b
[[nodiscard]] Outline parallelogram(Point from, Point a, Point b);

[[nodiscard]] inline Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
[[nodiscard]] inline Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
[[nodiscard]] inline Point operator*(int64_t factor, Point a) {
  return {factor * a.x, factor * a.y};
}

// Spreads most of the texture over the outline's box, within the texture: affine in the position
// but for the rounding to 1/65536 texel.
void map_across(Draft& draft, Case* c);
// Likewise, with u along x and v along y.
void map_axes(Draft& draft, Case* c);
// The middle of the target shows the middle of the texture, at most 240/256 texel a pixel: so all
// of the range of positions maps into an int32_t, and a screen stays within a screen's texture.
void map_about_the_middle(Draft& draft, Case* c);
// Each vertex anywhere in the texture.
void map_anywhere(Draft& draft, Case* c);

// A coordinate of (along_x x + along_y y) / under texels at x, y px from a pixel centre.
struct Slope {
  int32_t along_x, along_y, under;
};
// Sets u and v by such slopes, so that they are whole numbers at every centre (of `under` in each
// direction, one), and makes the texture as large as they need. All vertices are multiples of
// under / 256 px away from a centre.
void map_on_boundaries(Case* c, Slope u, Slope v);

// Turns columns into rows, of the target and of the texture.
void swap_axes(Case* c);

// Some pixel of the target is covered.
[[nodiscard]] bool covers_a_pixel(const Case& c);

}  // namespace selvage::spec
