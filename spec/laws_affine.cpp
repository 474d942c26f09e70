// Law AFFINE: what q means and what it must not change.
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "spec/law_list.h"
#include "spec/law_tools.h"

namespace selvage::spec {
namespace {

inline constexpr int32_t kFineTexture_texel = 256;

[[nodiscard]] Judgement judge_equal_q(const Subject& subject, const Case& c, Choices& choices) {
  Case one = c, other = c;
  const int32_t q = choices.pick(0, 3) == 0 ? SELVAGE_Q_MAX : choices.pick(2, SELVAGE_Q_MAX);
  for (selvage_vertex& v : one.vertices) v.q = 1;
  for (selvage_vertex& v : other.vertices) v.q = q;
  const Picture affine = draw(subject, one);
  return compare("AFFINE", "q that are all equal change nothing", other, draw(subject, other),
                 drawing_of(subject, "q = 1 shows it"),
                 [&](int32_t x, int32_t y) { return must_be(affine.at(x, y)); });
}

// A closed interval of integers; products of at most four texel differences fit int64_t.
struct Interval {
  int64_t least, greatest;

  friend Interval operator-(Interval a, Interval b) {
    return {a.least - b.greatest, a.greatest - b.least};
  }
  friend Interval operator*(Interval a, Interval b) {
    const auto [low, high] = std::minmax(
        {a.least * b.least, a.least * b.greatest, a.greatest * b.least, a.greatest * b.greatest});
    return {low, high};
  }
  [[nodiscard]] bool holds_zero() const { return least <= 0 && 0 <= greatest; }
};

// Four points on a line keep the cross-ratio (p0 - p2)(p1 - p3) : (p0 - p3)(p1 - p2) of their
// places. Texel s says that u is in [s, s + 1]: some choice of four such u must have the pixels'
// ratio.
[[nodiscard]] bool can_keep_cross_ratio(const std::array<int32_t, 4>& at_px,
                                        const std::array<int32_t, 4>& texels) {
  std::array<Interval, 4> u{}, x{};
  for (size_t i = 0; i < 4; ++i) {
    u[i] = {texels[i], int64_t{texels[i]} + 1};
    x[i] = {at_px[i], at_px[i]};
  }
  const Interval left = (u[0] - u[2]) * (u[1] - u[3]) * ((x[0] - x[3]) * (x[1] - x[2]));
  const Interval right = (u[0] - u[3]) * (u[1] - u[2]) * ((x[0] - x[2]) * (x[1] - x[3]));
  return (left - right).holds_zero();
}

// Judges the drawn pixels of one row or column, first, last, and two between them.
[[nodiscard]] Judgement judge_line(const Case& shown, const Picture& picture,
                                   const std::vector<Pixel>& line) {
  if (line.size() < 4) return {};
  std::array<int32_t, 4> at_px{}, s{}, t{};
  for (size_t i = 0; i < 4; ++i) {
    const Pixel p = line[(line.size() - 1) * i / 3];
    const Texel texel = texel_of(*picture.at(p.x_px, p.y_px));
    at_px[i] = p.x_px + p.y_px;  // one of them is constant along the line
    s[i] = texel.s;
    t[i] = texel.t;
  }
  Judgement judgement = {.judged_px = 4};
  if (can_keep_cross_ratio(at_px, s) && can_keep_cross_ratio(at_px, t)) return judgement;
  const Pixel last = line.back();
  judgement.violation = violation_at(
      "AFFINE", "four pixels on a line keep their cross-ratio", shown, last.x_px, last.y_px,
      "texels with the pixels' cross-ratio", picture.at(last.x_px, last.y_px));
  return judgement;
}

// A triangle with the case's positions and q, on a texture so fine that texels tell u well.
[[nodiscard]] Case on_fine_texture(const Capabilities& claims, const Case& c) {
  Case fine = with_vertices(claims, with_nearest(c), {c.vertices[0], c.vertices[1], c.vertices[2]});
  fine.format = SELVAGE_RGBA8888;
  fine.has_clip = false;
  fine.texture_width_texel = fine.texture_height_texel = kFineTexture_texel;
  for (selvage_vertex& v : fine.vertices) {
    v.u &= kFineTexture_texel * SELVAGE_SUBTEXELS - 1;
    v.v &= kFineTexture_texel * SELVAGE_SUBTEXELS - 1;
  }
  return fine;
}

[[nodiscard]] Judgement judge_cross_ratio(const Subject& subject, const Case& c) {
  Case fine = on_fine_texture(subject.claims, c);
  make_visible(profile_of(c), subject.claims, &fine.vertices);
  const Picture picture = draw(subject, fine);
  std::vector<std::vector<Pixel>> rows(static_cast<size_t>(fine.target_height_px));
  std::vector<std::vector<Pixel>> columns(static_cast<size_t>(fine.target_width_px));
  for (int32_t y = 0; y < fine.target_height_px; ++y) {
    for (int32_t x = 0; x < fine.target_width_px; ++x) {
      if (!picture.at(x, y)) continue;
      if (is_in_doubt(subject.claims.coverage_accuracy_fx16, fine, {x, y})) continue;
      rows[static_cast<size_t>(y)].push_back({x, y});
      columns[static_cast<size_t>(x)].push_back({x, y});
    }
  }
  Judgement judgement;
  for (const auto& lines : {rows, columns}) {
    for (const auto& line : lines) {
      if (add(&judgement, judge_line(fine, picture, line))) return judgement;
    }
  }
  return judgement;
}

}  // namespace

Judgement check_affine(const Subject& subject, const Case& c) {
  if (!is_valid(c)) return {};
  Choices choices(c.choice);
  Judgement judgement = judge_equal_q(subject, c, choices);
  const bool tells_texels = shows_exact_texels(subject.claims) && !profile_of(c).whole_px;
  const bool has_fine_texture = holds(subject.claims.formats, SELVAGE_RGBA8888) &&
                                subject.claims.longest_side_texel >= kFineTexture_texel;
  if (judgement.violation || !tells_texels || !has_fine_texture) return judgement;
  add(&judgement, judge_cross_ratio(subject, c));
  return judgement;
}

}  // namespace selvage::spec
