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

// (u, v) of a point on the segment a b, from its two ends alone.
[[nodiscard]] Sample sample_on_edge(Point p, const selvage_vertex& a, const selvage_vertex& b) {
  const Rational t = a.y != b.y ? rational(p.y - a.y) / rational(int64_t{b.y} - a.y)
                                : rational(p.x - a.x) / rational(int64_t{b.x} - a.x);
  const Rational q = a.q + t * (b.q - a.q);
  const auto mix = [&](int32_t from, int32_t to) {
    const Rational from_q = Rational(from) * a.q, to_q = Rational(to) * b.q;
    return Rational((from_q + t * (to_q - from_q)) / q / SELVAGE_SUBTEXELS);
  };
  return {mix(a.u, b.u), mix(a.v, b.v)};
}

// At a point on one of a triangle's edges or vertices; on edges only where the profile's arithmetic
// is exact there.
[[nodiscard]] std::optional<Sample> sample_on_outline(Point p, const Case& triangle) {
  const bool edges_too = triangle.profile == SELVAGE_PROFILE_EXACT;
  const auto& v = triangle.vertices;
  for (size_t k = 0; k < 3; ++k) {
    const selvage_vertex &a = v[k], &b = v[(k + 1) % 3];
    if (position(a) == position(b) || !on_segment(p, position(a), position(b))) continue;
    if (!edges_too && p != position(a) && p != position(b)) continue;
    return sample_on_edge(p, a, b);
  }
  return std::nullopt;
}

// A pixel that is drawn, but is not covered, by a subject that may do so: it may show any texel.
[[nodiscard]] bool is_extra(const Subject& subject, const Case& triangle, Pixel at) {
  return is_in_doubt(subject.claims.coverage_accuracy_fx16, triangle, at) &&
         !ModelRow(triangle, at.y_px).coordinates(at.x_px);
}

// Judges the drawn pixels of a triangle whose sample points lie there.
[[nodiscard]] Judgement judge_outline(const Subject& subject, const Case& triangle) {
  const Picture picture = draw(subject, triangle);
  const Rational accuracy = accuracy_of(subject);
  const TexelLaw law{"VERT", "a pixel on an edge or vertex shows what the edge's two ends say",
                     triangle};
  Judgement judgement;
  for (int32_t y = 0; y < triangle.target_height_px; ++y) {
    for (int32_t x = 0; x < triangle.target_width_px; ++x) {
      const MaybePixel& pixel = picture.at(x, y);
      if (!pixel) continue;
      const auto exact = sample_on_outline(sample_point(triangle, {x, y}), triangle);
      if (!exact || is_extra(subject, triangle, {x, y})) continue;
      if (!law.judge({x, y}, reach_around(*exact, accuracy), *pixel, &judgement)) return judgement;
    }
  }
  return judgement;
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
      Case shown = with_vertices(subject.claims, c, *outline);
      take_into_guard_band(subject.claims, &shown);
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

// The drawn pixels of which reach_at(line, x) tells how far off a texel may be there.
template <class LineOf, class ReachAt>
[[nodiscard]] Judgement judge_within_reach(const Subject& subject, const TexelLaw& law,
                                           const LineOf& line_of, const ReachAt& reach_at) {
  const Case& c = law.shown;
  const Picture drawn = draw(subject, c);
  Judgement judgement;
  for (int32_t y = 0; y < c.target_height_px; ++y) {
    const auto line = line_of(y);
    for (int32_t x = 0; line && x < c.target_width_px; ++x) {
      const MaybePixel& pixel = drawn.at(x, y);
      const std::optional<Reach> reach = pixel ? reach_at(*line, x) : std::nullopt;
      if (reach && !law.judge({x, y}, *reach, *pixel, &judgement)) return judgement;
    }
  }
  return judgement;
}

[[nodiscard]] Judgement judge_within_bound(const Subject& subject, const Case& c) {
  return judge_within_reach(
      subject, {"MAP", "a texel lies within the derived bound of its exact (u, v)", c},
      [&](int32_t y) { return historic_line(c.profile, c.vertices, y); },
      [](const HistoricLine& line, int32_t x) { return reach(line, x); });
}

[[nodiscard]] Judgement judge_within_accuracy(const Subject& subject, const Case& c) {
  const Rational accuracy = accuracy_of(subject);
  const std::string what = "a texel lies within the claimed accuracy, " + accuracy.get_str() +
                           " texel, of its exact (u, v)";
  return judge_within_reach(
      subject, {"MAP", what, c}, [&](int32_t y) { return scan_line(c.vertices, y); },
      [&](const ScanLine& line, int32_t x) -> std::optional<Reach> {
        const std::optional<Sample> exact = sample(line, x);
        if (!exact) return std::nullopt;
        return reach_around(*exact, accuracy);
      });
}

}  // namespace

Judgement check_map(const Subject& subject, const Case& any) {
  const Case c = with_nearest(any);
  if (!is_valid(c)) return {};
  if (c.profile != SELVAGE_PROFILE_EXACT) return judge_within_bound(subject, c);
  if (!shows_exact_texels(subject.claims)) return judge_within_accuracy(subject, c);
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

[[nodiscard]] TexelRange gamut_of(const Case& c, int32_t selvage_vertex::*axis, int32_t size,
                                  int64_t accuracy_fx16) {
  const auto [least, greatest] = std::ranges::minmax(c.vertices, {}, axis);
  const int64_t rounding = profile_of(c).rounding_fx16;
  return {static_cast<int32_t>((least.*axis + rounding - accuracy_fx16) >> 16),
          static_cast<int32_t>((greatest.*axis + rounding + accuracy_fx16) >> 16), size, c.address};
}

}  // namespace

Judgement check_gamut(const Subject& subject, const Case& any) {
  const Case c = with_nearest(any);
  if (!is_valid(c)) return {};
  const int64_t accuracy = subject.claims.accuracy_fx16;
  const TexelRange s = gamut_of(c, &selvage_vertex::u, c.texture_width_texel, accuracy);
  const TexelRange t = gamut_of(c, &selvage_vertex::v, c.texture_height_texel, accuracy);
  const Picture drawn = draw(subject, c);
  Judgement judgement;
  for (int32_t y = 0; y < c.target_height_px; ++y) {
    for (int32_t x = 0; x < c.target_width_px; ++x) {
      const std::optional<uint32_t>& pixel = drawn.at(x, y);
      if (!pixel) continue;
      const Texel texel = texel_of(*pixel);
      ++judgement.judged_px;
      if (s.holds(texel.s) && t.holds(texel.t)) continue;
      const bool is_a_texel = texel.s < c.texture_width_texel && texel.t < c.texture_height_texel;
      if (is_a_texel && is_in_doubt(subject.claims.coverage_accuracy_fx16, c, {x, y})) continue;
      judgement.violation =
          violation_at("GAMUT", "a texel lies within the range of the polygon's own coordinates", c,
                       x, y, "columns " + s.text() + ", rows " + t.text(), pixel);
      return judgement;
    }
  }
  return judgement;
}

}  // namespace selvage::spec
