// Measures of a case, for the tests of the hard families.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <optional>
#include <set>
#include <vector>

#include "spec/exact.h"
#include "spec/geometry.h"
#include "spec/picture.h"

namespace selvage::spec {

inline constexpr int64_t kPixel = SELVAGE_SUBPIXELS;
inline constexpr double kTexel = SELVAGE_SUBTEXELS;

struct Edge {
  Point from, to;
  [[nodiscard]] int64_t dx() const { return std::abs(to.x - from.x); }
  [[nodiscard]] int64_t dy() const { return std::abs(to.y - from.y); }
};

[[nodiscard]] inline std::vector<Edge> edges(const Case& c) {
  std::vector<Edge> all;
  for (size_t k = 0; k < c.vertices.size(); ++k) {
    all.push_back({position(c.vertices[k]), position(c.vertices[(k + 1) % c.vertices.size()])});
  }
  return all;
}

[[nodiscard]] inline int64_t count_edges(const Case& c,
                                         const std::function<bool(const Edge&)>& is) {
  return std::ranges::count_if(edges(c), is);
}

struct Range {
  int64_t least, greatest;
  [[nodiscard]] int64_t extent() const { return greatest - least; }
  // Pixels whose centres lie in [least, greatest).
  [[nodiscard]] int64_t centres() const { return ((greatest + 127) >> 8) - ((least + 127) >> 8); }
};

[[nodiscard]] inline Range range(const Case& c, int32_t selvage_vertex::*axis) {
  const auto [least, greatest] = std::ranges::minmax(c.vertices, {}, axis);
  return {least.*axis, greatest.*axis};
}
[[nodiscard]] inline Range xs(const Case& c) { return range(c, &selvage_vertex::x); }
[[nodiscard]] inline Range ys(const Case& c) { return range(c, &selvage_vertex::y); }

template <typename Visit>
void for_each_pixel(const Case& c, Visit visit) {
  for (int32_t y = 0; y < c.target_height_px; ++y) {
    for (int32_t x = 0; x < c.target_width_px; ++x) visit(x, y);
  }
}

[[nodiscard]] inline int64_t covered_px(const Case& c) {
  int64_t count = 0;
  for_each_pixel(c, [&](int32_t x, int32_t y) {
    count += winding_number(pixel_centre(x, y), c.vertices) != 0 ? 1 : 0;
  });
  return count;
}

[[nodiscard]] inline int64_t centres_on(const Case& c, const Edge& edge) {
  int64_t count = 0;
  for_each_pixel(c, [&](int32_t x, int32_t y) {
    count += on_segment(pixel_centre(x, y), edge.from, edge.to) ? 1 : 0;
  });
  return count;
}

[[nodiscard]] inline int64_t centres_on_outline(const Case& c) {
  int64_t count = 0;
  for_each_pixel(c, [&](int32_t x, int32_t y) {
    count += on_outline(pixel_centre(x, y), c.vertices) ? 1 : 0;
  });
  return count;
}

// Of the covered pixels, those whose exact coordinates are as asked.
[[nodiscard]] inline double share(const Case& c, const std::function<bool(const Sample&)>& is) {
  int64_t count = 0, all = 0;
  for (int32_t y = 0; y < c.target_height_px; ++y) {
    const std::optional<ScanLine> line = scan_line(c.vertices, y);
    for (int32_t x = 0; line && x < c.target_width_px; ++x) {
      const std::optional<Sample> point = sample(*line, x);
      if (!point) continue;
      ++all;
      count += is(*point) ? 1 : 0;
    }
  }
  return all == 0 ? 0 : static_cast<double>(count) / static_cast<double>(all);
}

[[nodiscard]] inline bool is_whole(const Rational& number) { return number.get_den() == 1; }

[[nodiscard]] inline std::set<uint32_t> texels_shown(const Case& c) {
  std::set<uint32_t> texels;
  for (const auto& pixel : expected(c).pixels) {
    if (pixel) texels.insert(*pixel);
  }
  return texels;
}

// Of the covered pixels, those that would show another texel if all q were equal.
[[nodiscard]] inline double share_in_perspective(const Case& c) {
  Case affine = c;
  for (selvage_vertex& v : affine.vertices) v.q = 1;
  const Picture picture = expected(c), flat = expected(affine);
  const auto count = [](auto begin, auto end) {
    return static_cast<double>(std::count(begin, end, true));
  };
  std::vector<bool> covered, other;
  for (size_t i = 0; i < picture.pixels.size(); ++i) {
    covered.push_back(picture.pixels[i].has_value());
    other.push_back(picture.pixels[i] != flat.pixels[i]);
  }
  return count(other.begin(), other.end()) / count(covered.begin(), covered.end());
}

[[nodiscard]] inline bool has_q_ratio(const Case& c, int64_t ratio) {
  const Range q = range(c, &selvage_vertex::q);
  return q.greatest == q.least * ratio;
}

[[nodiscard]] inline bool in_perspective(const Case& c, int64_t ratio) {
  return has_q_ratio(c, ratio) && texels_shown(c).size() >= 8 && share_in_perspective(c) > 0.5;
}

[[nodiscard]] inline bool is_strictly_convex(const Case& c) {
  const std::vector<Edge> all = edges(c);
  const int64_t turn = doubled_area(all[0].from, all[0].to, all[1].to);
  for (size_t k = 0; k < all.size(); ++k) {
    const Point next = all[(k + 1) % all.size()].to;
    const int64_t other = doubled_area(all[k].from, all[k].to, next);
    if (other == 0 || (other < 0) != (turn < 0)) return false;
  }
  return true;
}

// How far, in texels, u is off the affine map of the first three vertices.
[[nodiscard]] inline double off_affine_texel(const Case& c) {
  const auto& v = c.vertices;
  const Point a = position(v[0]), b = position(v[1]), d = position(v[2]);
  double worst = 0;
  for (const selvage_vertex& p : v) {
    const Point at = position(p);
    const double u = static_cast<double>(doubled_area(at, b, d)) * v[0].u +
                     static_cast<double>(doubled_area(a, at, d)) * v[1].u +
                     static_cast<double>(doubled_area(a, b, at)) * v[2].u;
    worst = std::max(worst, std::abs(u / static_cast<double>(doubled_area(a, b, d)) - p.u));
  }
  return worst / kTexel;
}

[[nodiscard]] inline double row_width_px(const Case& c, int32_t y_px) {
  const std::optional<ScanLine> line = scan_line(c.vertices, y_px);
  if (!line) return 0;
  return Rational(line->right.x - line->left.x).get_d();
}

[[nodiscard]] inline int64_t doubled_area_fx8(const Case& c) {
  return std::abs(
      doubled_area(position(c.vertices[0]), position(c.vertices[1]), position(c.vertices[2])));
}

}  // namespace selvage::spec
