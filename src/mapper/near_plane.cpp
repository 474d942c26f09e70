#include "mapper/near_plane.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace selvage::mapper {
namespace {

[[nodiscard]] double change(int32_t from, int32_t to) {
  return static_cast<double>(int64_t{to} - from);
}

// Two lines across the polygon, of a quad its diagonals: a plane with their slopes is as far off at
// one end of each as at the other.
struct Across {
  const selvage_vertex &a, &b, &c, &d;  // from a to b, from c to d
  double x1, y1, x2, y2;                // 1/256 px
  double area;                          // 0 where they have one direction

  explicit Across(std::span<const selvage_vertex> vertices)
      : a(vertices[0]),
        b(vertices[vertices.size() / 2]),
        c(vertices[vertices.size() / 4]),
        d(vertices[vertices.size() * 3 / 4]),
        x1(change(a.x, b.x)),
        y1(change(a.y, b.y)),
        x2(change(c.x, d.x)),
        y2(change(c.y, d.y)),
        area(x1 * y2 - x2 * y1) {}
};

// One coordinate of a plane: steps to the next pixel and to the next row.
struct Slopes {
  int64_t x_fx32, y_fx32;
};

[[nodiscard]] std::optional<Slopes> slopes_along(const Across& across,
                                                 int32_t selvage_vertex::*of) {
  constexpr double kMost_fx32 = int64_t{1} << (kLaneFraction + kNearStepBits);
  constexpr double kUnit = int64_t{kSubpixels} << (kLaneFraction - kTexelFraction);
  const double first = change(across.a.*of, across.b.*of);
  const double second = change(across.c.*of, across.d.*of);
  const double per_area = kUnit / across.area;
  const double x = (first * across.y2 - second * across.y1) * per_area;
  const double y = (second * across.x1 - first * across.x2) * per_area;
  if (!(std::abs(x) < kMost_fx32 && std::abs(y) < kMost_fx32)) return std::nullopt;
  return Slopes{static_cast<int64_t>(x), static_cast<int64_t>(y)};
}

// Sets a coordinate of lanes of which the first pixel is set. Returns the margin.
[[nodiscard]] int64_t set_lanes(const Slopes& slopes, const Polygon& polygon,
                                int32_t selvage_vertex::*of, int64_t Lane::*axis,
                                AffineField* lanes) {
  const int64_t x_fx8 = centre_fx8(lanes->first_px), y_fx8 = centre_fx8(lanes->first_row);
  int64_t least = INT64_MAX, most = INT64_MIN;  // of starts that hit a vertex, in 2^-40 texel
  for (const selvage_vertex& vertex : polygon.vertices) {
    const int64_t at_vertex = int64_t{vertex.*of}
                              << (kLaneFraction - kTexelFraction + kSubpixelBits);
    const int64_t start =
        at_vertex - (vertex.x - x_fx8) * slopes.x_fx32 - (vertex.y - y_fx8) * slopes.y_fx32;
    least = std::min(least, start);
    most = std::max(most, start);
  }
  lanes->step_x.*axis = slopes.x_fx32;
  lanes->step_y.*axis = slopes.y_fx32;
  lanes->start.*axis = least >> kSubpixelBits;
  return (most >> kSubpixelBits) - (least >> kSubpixelBits) + kNearTruncation_fx32;
}

// A coordinate's near-ties are as many of a row's pixels, which are no more than the polygon is
// wide, as the margin is of a texel.
[[nodiscard]] int64_t most_margin_fx32(const Polygon& polygon) {
  const int64_t width_px = polygon.right_px - polygon.left_px;
  constexpr int64_t kTexel_fx32 = int64_t{1} << kLaneFraction;
  return std::min(kMostNearMargin_fx32, kTexel_fx32 / (kLeastRowsPerNearTie * width_px));
}

}  // namespace

std::optional<AffineField> near_plane(const Polygon& polygon, const selvage_rect& part) {
  if (!polygon.affine) return std::nullopt;
  const Across across(polygon.vertices);
  if (across.area == 0) return std::nullopt;
  const auto u = slopes_along(across, &selvage_vertex::u);
  const auto v = slopes_along(across, &selvage_vertex::v);
  if (!u || !v) return std::nullopt;
  AffineField lanes{};
  lanes.first_px = part.left;
  lanes.first_row = part.top;
  const int64_t margin =
      std::max(set_lanes(*u, polygon, &selvage_vertex::u, &Lane::u_fx32, &lanes),
               set_lanes(*v, polygon, &selvage_vertex::v, &Lane::v_fx32, &lanes));
  if (margin > most_margin_fx32(polygon)) return std::nullopt;
  lanes.margin_fx32 = static_cast<uint32_t>(margin);
  return lanes;
}

}  // namespace selvage::mapper
