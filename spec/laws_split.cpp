// Law SPLIT: a cut along a chord changes nothing.
#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "spec/geometry.h"
#include "spec/law_list.h"
#include "spec/law_tools.h"

namespace selvage::spec {
namespace {

// u and v become integer functions a x + b y of the position: an affine map without rounding.
// Factors are multiples of one, a power of two.
void map_affinely(std::vector<selvage_vertex>* vertices, int32_t factor_step, Choices& choices) {
  int32_t reach_fx8 = 1;
  for (const selvage_vertex& v : *vertices) {
    reach_fx8 = std::max({reach_fx8, std::abs(v.x), std::abs(v.y)});
  }
  const int32_t limit = std::min((1 << 29) / reach_fx8, 2048) / factor_step;
  int32_t factors[4];
  for (int32_t& factor : factors) factor = choices.pick(-limit, limit + 1) * factor_step;
  for (selvage_vertex& v : *vertices) {
    v.u = factors[0] * v.x + factors[1] * v.y;
    v.v = factors[2] * v.x + factors[3] * v.y;
    v.q = 1;
  }
}

// A convex outline with a chord between vertices 0 and `end`, both parts with an area.
struct Chord {
  std::vector<selvage_vertex> outline;
  size_t end;
};

// A triangle has no chord between its corners: one is put on the side opposite to corner 0, on the
// grid of the vertices.
[[nodiscard]] std::optional<Chord> choose_chord(std::vector<selvage_vertex> hull, int32_t grid_fx8,
                                                Choices& choices) {
  if (hull.size() < 3) return std::nullopt;
  const auto first = choices.pick(0, static_cast<int32_t>(hull.size()));
  std::rotate(hull.begin(), hull.begin() + first, hull.end());
  if (hull.size() > 3) {
    return Chord{hull, static_cast<size_t>(choices.pick(2, static_cast<int32_t>(hull.size()) - 1))};
  }
  const int32_t dx = hull[2].x - hull[1].x, dy = hull[2].y - hull[1].y;
  const int32_t steps = std::gcd(dx, dy) / grid_fx8;
  if (steps < 2) return std::nullopt;
  const int32_t step = choices.pick(1, steps);
  selvage_vertex between = hull[1];
  between.x += dx / steps * step;
  between.y += dy / steps * step;
  hull.insert(hull.begin() + 2, between);
  return Chord{hull, 2};
}

[[nodiscard]] std::string place_px(const selvage_vertex& v) {
  std::ostringstream text;
  text << '(' << v.x / double{SELVAGE_SUBPIXELS} << ", " << v.y / double{SELVAGE_SUBPIXELS} << ')';
  return text.str();
}

// Without the vertex that was put between corners 1 and 2, if there is one.
[[nodiscard]] std::vector<selvage_vertex> corners_of(const std::vector<selvage_vertex>& outline) {
  if (outline.size() != 4) return outline;
  return {outline[0], outline[1], outline[3]};
}

}  // namespace

Judgement check_split(const Subject& subject, const Case& c) {
  Choices choices(c.choice);
  const int32_t grid_fx8 = mapped_step_fx8(profile_of(c), subject.claims);
  Capabilities on_grid = subject.claims;
  on_grid.position_step_fx8 = grid_fx8;
  const std::vector<selvage_vertex> hull = convex_hull(acceptable(on_grid, c).vertices);
  std::optional<Chord> chord = choose_chord(hull, grid_fx8, choices);
  if (!chord) return {};
  std::vector<selvage_vertex>& outline = chord->outline;
  map_affinely(&outline, std::max(subject.claims.coordinate_step_fx16 / grid_fx8, 1), choices);
  const std::vector<selvage_vertex> triangle = corners_of(outline);
  const auto middle = outline.begin() + static_cast<ptrdiff_t>(chord->end);
  std::vector<selvage_vertex> one(outline.begin(), middle + 1), other(middle, outline.end());
  other.push_back(outline.front());

  const bool is_too_much = outline.size() > static_cast<size_t>(subject.claims.most_vertices);
  const Case whole_case =
      visible(subject, with_vertices(subject.claims, c, is_too_much ? triangle : outline));
  const Picture whole = draw(subject, whole_case);
  const Case one_case = visible(subject, with_vertices(subject.claims, c, one));
  const Picture a = draw(subject, one_case);
  const Case rest_case = visible(subject, with_vertices(subject.claims, c, other));
  const Picture b = draw(subject, rest_case);
  Picture parts = a;
  for (size_t i = 0; i < parts.pixels.size(); ++i) {
    if (b.pixels[i]) parts.pixels[i] = b.pixels[i];
  }
  OtherDrawing uncut = drawing_of(subject, "the whole polygon shows it");
  uncut.judges_texels = uncut.judges_texels && c.profile == SELVAGE_PROFILE_EXACT;
  const std::string cut = "cut from " + place_px(outline.front()) + " to " + place_px(*middle);
  // Parts meet within an accuracy of the coverage, too, but on the outline of the whole; where a
  // part goes too far, it may show any texel.
  const int32_t accuracy_fx16 = subject.claims.coverage_accuracy_fx16;
  const auto wanted = [&](int32_t x, int32_t y) {
    const bool is_any_texel = whole.at(x, y) && parts.at(x, y) &&
                              (is_in_doubt(accuracy_fx16, one_case, {x, y}) ||
                               is_in_doubt(accuracy_fx16, rest_case, {x, y}));
    return must_be(is_any_texel ? parts.at(x, y) : whole.at(x, y));
  };
  Judgement judgement =
      compare("SPLIT", "two parts of a polygon, " + cut + ", draw what the whole draws", whole_case,
              parts, uncut, wanted);
  if (judgement.violation) return judgement;
  add(&judgement, compare("SPLIT", "a pixel lies in one part only of a polygon, " + cut, rest_case,
                          b, {"the other part has drawn it"}, [&](int32_t x, int32_t y) {
                            const bool is_first = a.at(x, y) && b.at(x, y) &&
                                                  is_in_doubt(accuracy_fx16, whole_case, {x, y});
                            return a.at(x, y) && !is_first ? must_be(std::nullopt) : unjudged();
                          }));
  return judgement;
}

}  // namespace selvage::spec
