// Laws of the mapping: VERT, MAP, GAMUT, IDENTITY.
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "spec/geometry.h"
#include "spec/law_list.h"
#include "spec/law_tools.h"
#include "spec/reach.h"

namespace selvage::spec {
namespace {

[[nodiscard]] uint32_t texel_value(const Case& c, const Sample& point) {
  Rational rounding(profile_of(c).rounding_fx16, SELVAGE_SUBTEXELS);
  rounding.canonicalize();
  return addressed_value(c, {floor(point.u + rounding), floor(point.v + rounding)});
}

// (u, v) of a point on the segment a b, from its two ends alone.
[[nodiscard]] Sample sample_on_edge(Point p, const selvage_vertex& a, const selvage_vertex& b) {
  Rational t = a.y != b.y ? Rational(p.y - a.y, int64_t{b.y} - a.y)
                          : Rational(p.x - a.x, int64_t{b.x} - a.x);
  t.canonicalize();
  const Rational q = a.q + t * (b.q - a.q);
  const auto mix = [&](int32_t from, int32_t to) {
    const Rational from_q = Rational(from) * a.q, to_q = Rational(to) * b.q;
    return Rational((from_q + t * (to_q - from_q)) / q / SELVAGE_SUBTEXELS);
  };
  return {mix(a.u, b.u), mix(a.v, b.v)};
}

// Judges the drawn pixels of a triangle whose sample points lie on one of its edges or vertices;
// on edges only where the profile's arithmetic is exact there.
[[nodiscard]] Judgement judge_outline(const Subject& subject, const Case& triangle) {
  const Picture picture = draw(subject, triangle);
  const auto& v = triangle.vertices;
  const bool edges_too = triangle.profile == SELVAGE_PROFILE_EXACT;
  return compare("VERT", "a pixel on an edge or vertex shows what the edge's two ends say",
                 triangle, picture, [&](int32_t x, int32_t y) {
                   if (!picture.at(x, y)) return unjudged();
                   const Point p = sample_point(triangle, {x, y});
                   for (size_t k = 0; k < 3; ++k) {
                     const selvage_vertex &a = v[k], &b = v[(k + 1) % 3];
                     if (position(a) == position(b) || !on_segment(p, position(a), position(b)))
                       continue;
                     if (!edges_too && p != position(a) && p != position(b)) continue;
                     return must_be(texel_value(triangle, sample_on_edge(p, a, b)));
                   }
                   return unjudged();
                 });
}

// The triangle turned by `quarters` quarter turns about its first vertex.
[[nodiscard]] std::optional<std::vector<selvage_vertex>> turned(
    const std::array<selvage_vertex, 3>& triangle, int quarters) {
  std::vector<selvage_vertex> result(triangle.begin(), triangle.end());
  for (selvage_vertex& v : result) {
    int64_t dx = int64_t{v.x} - triangle[0].x, dy = int64_t{v.y} - triangle[0].y;
    for (int i = 0; i < quarters; ++i) dx = std::exchange(dy, dx) * -1;
    const int64_t x = triangle[0].x + dx, y = triangle[0].y + dy;
    if (std::min(x, y) < SELVAGE_X_MIN || std::max(x, y) >= SELVAGE_X_END) return std::nullopt;
    v.x = static_cast<int32_t>(x);
    v.y = static_cast<int32_t>(y);
  }
  return result;
}

// The triangle on the other side of the edge from vertex 0 to vertex 1: what it shows on that edge
// must not depend on which of the two owns a pixel, nor on the third corner.
[[nodiscard]] std::optional<std::array<selvage_vertex, 3>> twin_across_edge(
    const std::array<selvage_vertex, 3>& triangle) {
  const auto& [a, b, c] = triangle;
  const int64_t x = int64_t{a.x} + b.x - c.x, y = int64_t{a.y} + b.y - c.y;
  if (std::min(x, y) < SELVAGE_X_MIN || std::max(x, y) >= SELVAGE_X_END) return std::nullopt;
  return std::array{
      a, b, selvage_vertex{static_cast<int32_t>(x), static_cast<int32_t>(y), c.v, c.u, c.q}};
}

}  // namespace

// A corner with its neighbours, moved so that the corner lies on a sample point of the target, and
// its twin, in four quarter turns, so that every side of a corner and of an edge is drawn in one.
Judgement check_vert(const Subject& subject, const Case& any) {
  const Case c = with_nearest(any);
  const size_t count = c.vertices.size();
  if (count < 3) return {};
  Choices choices(c.choice);
  Judgement judgement;
  const auto k = static_cast<size_t>(choices.pick(0, static_cast<int32_t>(count)));
  const Point place = sample_point(c, choose_pixel(c, choices));
  const selvage_vertex& corner = c.vertices[k];
  const std::array corners = {corner, c.vertices[(k + 1) % count],
                              c.vertices[(k + count - 1) % count]};
  const auto placed = moved(corners, place.x - corner.x, place.y - corner.y);
  if (!placed) return judgement;
  const std::array<selvage_vertex, 3> triangle = {(*placed)[0], (*placed)[1], (*placed)[2]};
  for (const auto& side : {std::optional(triangle), twin_across_edge(triangle)}) {
    for (int quarters = 0; side && quarters < 4; ++quarters) {
      const auto outline = turned(*side, quarters);
      if (!outline) continue;
      Case shown = with_vertices(c, *outline);
      make_visible(profile_of(c), subject.claims, &shown.vertices);
      if (add(&judgement, judge_outline(subject, shown))) return judgement;
    }
  }
  return judgement;
}

namespace {

[[nodiscard]] Judgement judge_exactly(std::string_view law, std::string_view what,
                                      const Subject& subject, const Case& c) {
  const Picture model = expected(c);
  const Picture drawn = draw(subject, c);
  return compare(law, what, c, drawn, [&](int32_t x, int32_t y) {
    if (!model.at(x, y) || !drawn.at(x, y)) return unjudged();
    return must_be(model.at(x, y));
  });
}

// The texels along one axis that lie within reach of an exact coordinate.
[[nodiscard]] TexelRange range_of(const Rational& exact, const Rational& below,
                                  const Rational& above, const Case& c, int32_t size_texel) {
  Rational rounding(profile_of(c).rounding_fx16, SELVAGE_SUBTEXELS);
  rounding.canonicalize();
  return {floor(exact - below + rounding), floor(exact + above + rounding), size_texel, c.address};
}

[[nodiscard]] std::optional<Margin> margin_of(const Reach& point, Texel texel, const Case& c) {
  Rational rounding(profile_of(c).rounding_fx16, SELVAGE_SUBTEXELS);
  rounding.canonicalize();
  std::optional<Margin> nearest = margin_along({point.u + rounding, point.u_below, point.u_above},
                                               texel.s, c.texture_width_texel, c.address);
  add(&nearest, margin_along({point.v + rounding, point.v_below, point.v_above}, texel.t,
                             c.texture_height_texel, c.address));
  return nearest;
}

[[nodiscard]] Judgement judge_within_reach(const Subject& subject, const Case& c) {
  const Picture drawn = draw(subject, c);
  Judgement judgement;
  for (int32_t y = 0; y < c.target_height_px; ++y) {
    const std::optional<HistoricLine> line = historic_line(c.profile, c.vertices, y);
    for (int32_t x = 0; line && x < c.target_width_px; ++x) {
      const std::optional<uint32_t>& pixel = drawn.at(x, y);
      const std::optional<Reach> point = pixel ? reach(*line, x) : std::nullopt;
      if (!point) continue;
      const Texel texel = texel_of(*pixel);
      ++judgement.judged_px;
      const TexelRange s =
          range_of(point->u, point->u_below, point->u_above, c, c.texture_width_texel);
      const TexelRange t =
          range_of(point->v, point->v_below, point->v_above, c, c.texture_height_texel);
      if (s.holds(texel.s) && t.holds(texel.t)) {
        add(&judgement.margin, margin_of(*point, texel, c));
        continue;
      }
      judgement.violation =
          violation_at("MAP", "a texel lies within the derived bound of its exact (u, v)", c, x, y,
                       "columns " + s.text() + ", rows " + t.text() + ", addressed", pixel);
      return judgement;
    }
  }
  return judgement;
}

}  // namespace

Judgement check_map(const Subject& subject, const Case& any) {
  const Case c = with_nearest(any);
  if (!is_valid(c)) return {};
  if (c.profile != SELVAGE_PROFILE_EXACT) return judge_within_reach(subject, c);
  return judge_exactly("MAP", "a drawn pixel shows the texel that holds its exact (u, v)", subject,
                       c);
}

Judgement check_dda(const Subject& subject, const Case& any) {
  const Case c = with_nearest(any);
  if (!is_valid(c) || c.profile == SELVAGE_PROFILE_EXACT) return {};
  return judge_exactly("DDA", "a drawn pixel shows the texel of the profile's own arithmetic",
                       subject, c);
}

namespace {

[[nodiscard]] TexelRange gamut_of(const Case& c, int32_t selvage_vertex::*axis, int32_t size) {
  const auto [least, greatest] = std::ranges::minmax(c.vertices, {}, axis);
  const int64_t rounding = profile_of(c).rounding_fx16;
  return {static_cast<int32_t>((least.*axis + rounding) >> 16),
          static_cast<int32_t>((greatest.*axis + rounding) >> 16), size, c.address};
}

}  // namespace

Judgement check_gamut(const Subject& subject, const Case& any) {
  const Case c = with_nearest(any);
  if (!is_valid(c)) return {};
  const TexelRange s = gamut_of(c, &selvage_vertex::u, c.texture_width_texel);
  const TexelRange t = gamut_of(c, &selvage_vertex::v, c.texture_height_texel);
  const Picture drawn = draw(subject, c);
  Judgement judgement;
  for (int32_t y = 0; y < c.target_height_px; ++y) {
    for (int32_t x = 0; x < c.target_width_px; ++x) {
      const std::optional<uint32_t>& pixel = drawn.at(x, y);
      if (!pixel) continue;
      const Texel texel = texel_of(*pixel);
      ++judgement.judged_px;
      if (s.holds(texel.s) && t.holds(texel.t)) continue;
      judgement.violation =
          violation_at("GAMUT", "a texel lies within the range of the polygon's own coordinates", c,
                       x, y, "columns " + s.text() + ", rows " + t.text() + ", addressed", pixel);
      return judgement;
    }
  }
  return judgement;
}

}  // namespace selvage::spec
