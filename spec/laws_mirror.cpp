// Law MIRROR: flips and quarter turns, ties apart.
#include <algorithm>
#include <functional>
#include <vector>

#include "spec/geometry.h"
#include "spec/law_list.h"
#include "spec/law_tools.h"

namespace selvage::spec {
namespace {

// A rigid motion of the plane that takes sample points to sample points, and the target with it.
struct Motion {
  std::string what;
  bool swaps_axes, flips_x, flips_y;  // swaps first

  // The pixel that moves to another one of the moved target.
  [[nodiscard]] Pixel origin(Pixel p, const Case& to) const {
    if (flips_x) p.x_px = to.target_width_px - 1 - p.x_px;
    if (flips_y) p.y_px = to.target_height_px - 1 - p.y_px;
    if (swaps_axes) std::swap(p.x_px, p.y_px);
    return p;
  }
};

[[nodiscard]] selvage_rect moved_rect(const selvage_rect& r, const Motion& motion, const Case& to) {
  selvage_rect m = motion.swaps_axes ? selvage_rect{r.top, r.left, r.bottom, r.right} : r;
  const int32_t w = to.target_width_px, h = to.target_height_px;
  if (motion.flips_x) m = {w - m.right, m.top, w - m.left, m.bottom};
  if (motion.flips_y) m = {m.left, h - m.bottom, m.right, h - m.top};
  return m;
}

// Empty if a vertex would leave the accepted range.
[[nodiscard]] std::optional<Case> moved_case(const Capabilities& claims, const Case& c,
                                             const Motion& motion) {
  Case to = c;
  // The last sample point takes the first one's place.
  const Point ends =
      sample_point(to, motion.swaps_axes ? Pixel{c.target_height_px - 1, c.target_width_px - 1}
                                         : Pixel{c.target_width_px - 1, c.target_height_px - 1});
  const Point begin = sample_point(to, {0, 0});
  if (motion.swaps_axes) std::swap(to.target_width_px, to.target_height_px);
  to.clip = moved_rect(c.clip, motion, to);
  for (selvage_vertex& v : to.vertices) {
    if (motion.swaps_axes) std::swap(v.x, v.y);
    const int64_t x = motion.flips_x ? begin.x + ends.x - v.x : v.x;
    const int64_t y = motion.flips_y ? begin.y + ends.y - v.y : v.y;
    if (std::min(x, y) < SELVAGE_X_MIN || std::max(x, y) >= SELVAGE_X_END) return std::nullopt;
    v.x = static_cast<int32_t>(x);
    v.y = static_cast<int32_t>(y);
  }
  make_visible(profile_of(c), claims, &to.vertices);
  return to;
}

// Where the half-open rule makes a difference: a centre on the outline, or a line through a vertex,
// where the edge above and the edge below may carry different coordinates.
[[nodiscard]] bool is_tie(const Case& c, Pixel pixel, bool columns_too) {
  const Point p = sample_point(c, pixel);
  for (const selvage_vertex& v : c.vertices) {
    if (v.y == p.y || (columns_too && v.x == p.x)) return true;
  }
  return on_outline(p, c.vertices);
}

[[nodiscard]] Judgement judge_motion(const Subject& subject, const Case& c, const Motion& motion) {
  const std::optional<Case> to = moved_case(subject.claims, c, motion);
  if (!to) return {};
  const Picture before = draw(subject, c);
  const Picture after = draw(subject, *to);
  // Turned by a quarter, only a triangle keeps its map: its spans lie elsewhere, its map does not.
  const bool keeps_texels = !motion.swaps_axes || c.vertices.size() == 3;
  OtherDrawing other = drawing_of(subject, "the polygon where it was shows it");
  other.judges_texels = other.judges_texels && keeps_texels;
  return compare("MIRROR", motion.what, *to, after, other, [&](int32_t x, int32_t y) {
    const Pixel from = motion.origin({x, y}, *to);
    if (is_tie(c, from, motion.swaps_axes)) return unjudged();
    return must_be(before.at(from.x_px, from.y_px));
  });
}

// Where texels are floored u becomes width - u, where they are rounded width - 1 - u, and likewise
// v; texel s then is texel width - 1 - s.
[[nodiscard]] Judgement judge_texture_flip(const Subject& subject, const Case& any) {
  const Case c = with_nearest(any);
  Case flipped = c;
  const int64_t ends_fx16 = 2 * profile_of(c).rounding_fx16;
  for (selvage_vertex& v : flipped.vertices) {
    const int64_t u = int64_t{c.texture_width_texel} * SELVAGE_SUBTEXELS - ends_fx16 - v.u;
    const int64_t w = int64_t{c.texture_height_texel} * SELVAGE_SUBTEXELS - ends_fx16 - v.v;
    if (u != static_cast<int32_t>(u) || w != static_cast<int32_t>(w)) return {};
    v.u = static_cast<int32_t>(u);
    v.v = static_cast<int32_t>(w);
  }
  const Picture before = draw(subject, c);
  return compare("MIRROR", "flipped (u, v) show flipped texels", flipped, draw(subject, flipped),
                 drawing_of(subject, "the unflipped (u, v) show it, flipped"),
                 [&](int32_t x, int32_t y) {
                   const MaybePixel& pixel = before.at(x, y);
                   const std::optional<Sample> point = ModelRow(c, y).coordinates(x);
                   if (!pixel || !point) return unjudged();
                   if (point->u.get_den() == 1 || point->v.get_den() == 1) return unjudged();
                   const Texel texel = texel_of(*pixel);
                   return must_be(coordinate_texel(c.texture_width_texel - 1 - texel.s,
                                                   c.texture_height_texel - 1 - texel.t));
                 });
}

}  // namespace

Judgement check_mirror(const Subject& subject, const Case& c) {
  if (!is_valid(c)) return {};
  Judgement judgement = judge_texture_flip(subject, c);
  const Motion flips[] = {
      {"a polygon flipped left to right draws the flipped picture", false, true, false},
      {"a polygon flipped top to bottom draws the flipped picture", false, false, true}};
  for (const Motion& motion : flips) {
    if (judgement.violation || add(&judgement, judge_motion(subject, c, motion))) return judgement;
  }
  const std::vector<selvage_vertex> hull = convex_hull(c.vertices);
  if (hull.size() < 3) return judgement;
  add(&judgement,
      judge_motion(subject, visible(subject, with_vertices(subject.claims, c, hull)),
                   {"a polygon turned by a quarter draws the turned picture", true, true, false}));
  return judgement;
}

}  // namespace selvage::spec
