// Law SPLIT: a cut along a chord changes nothing.
#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <optional>
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

// A polygon and its two parts, as the subject can draw them.
struct Cut {
  Case whole, one, other;
  std::string text;  // "cut from (0, 0) to (2, 1)"
};

[[nodiscard]] std::optional<Cut> choose_cut(const Subject& subject, const Case& c) {
  Choices choices(c.choice);
  const int32_t grid_fx8 = mapped_step_fx8(profile_of(c), subject.claims);
  Capabilities on_grid = subject.claims;
  on_grid.position_step_fx8 = grid_fx8;
  const std::vector<selvage_vertex> hull = convex_hull(acceptable(on_grid, c).vertices);
  std::optional<Chord> chord = choose_chord(hull, grid_fx8, choices);
  if (!chord) return std::nullopt;
  std::vector<selvage_vertex>& outline = chord->outline;
  map_affinely(&outline, std::max(subject.claims.coordinate_step_fx16 / grid_fx8, 1), choices);
  const auto middle = outline.begin() + static_cast<ptrdiff_t>(chord->end);
  std::vector<selvage_vertex> one(outline.begin(), middle + 1), other(middle, outline.end());
  other.push_back(outline.front());
  const bool is_too_much = outline.size() > static_cast<size_t>(subject.claims.most_vertices);
  const auto of = [&](const std::vector<selvage_vertex>& vertices) {
    return visible(subject, with_vertices(subject.claims, c, vertices));
  };
  return Cut{of(is_too_much ? corners_of(outline) : outline), of(one), of(other),
             "cut from " + place_px(outline.front()) + " to " + place_px(*middle)};
}

// Parts meet within an accuracy of the coverage, too, but on the outline of the whole; where a part
// goes too far, it may show any texel.
[[nodiscard]] Judgement judge_parts(const Subject& subject, const Cut& cut, const Picture& one,
                                    const Picture& other) {
  const Picture whole = draw(subject, cut.whole);
  Picture parts = one;
  for (size_t i = 0; i < parts.pixels.size(); ++i) {
    if (other.pixels[i]) parts.pixels[i] = other.pixels[i];
  }
  OtherDrawing uncut = drawing_of(subject, "the whole polygon shows it");
  uncut.judges_texels = uncut.judges_texels && cut.whole.profile == SELVAGE_PROFILE_EXACT;
  const int32_t accuracy_fx16 = subject.claims.coverage_accuracy_fx16;
  return compare("SPLIT", "two parts of a polygon, " + cut.text + ", draw what the whole draws",
                 cut.whole, parts, uncut, [&](int32_t x, int32_t y) {
                   const bool is_any_texel = whole.at(x, y) && parts.at(x, y) &&
                                             (is_in_doubt(accuracy_fx16, cut.one, {x, y}) ||
                                              is_in_doubt(accuracy_fx16, cut.other, {x, y}));
                   return must_be(is_any_texel ? parts.at(x, y) : whole.at(x, y));
                 });
}

[[nodiscard]] Judgement judge_overlap(const Subject& subject, const Cut& cut, const Picture& one,
                                      const Picture& other) {
  const int32_t accuracy_fx16 = subject.claims.coverage_accuracy_fx16;
  return compare("SPLIT", "a pixel lies in one part only of a polygon, " + cut.text, cut.other,
                 other, {"the other part has drawn it"}, [&](int32_t x, int32_t y) {
                   const bool is_both = one.at(x, y) && other.at(x, y);
                   if (is_both && is_in_doubt(accuracy_fx16, cut.whole, {x, y})) return unjudged();
                   return one.at(x, y) ? must_be(std::nullopt) : unjudged();
                 });
}

}  // namespace

Judgement check_split(const Subject& subject, const Case& c) {
  const std::optional<Cut> cut = choose_cut(subject, c);
  if (!cut) return {};
  const Picture one = draw(subject, cut->one), other = draw(subject, cut->other);
  Judgement judgement = judge_parts(subject, *cut, one, other);
  if (!judgement.violation) add(&judgement, judge_overlap(subject, *cut, one, other));
  return judgement;
}

}  // namespace selvage::spec
