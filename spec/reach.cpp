#include "spec/reach.h"

#include <algorithm>

#include "spec/dda_bounds.h"

namespace selvage::spec {
namespace {

// What is the same for u and for v at a pixel.
struct SpanPoint {
  Rational left_x, width;  // px; width between the edges, of either sign where they share a column
  Rational x;              // the sample point, moved onto the span where it lies beside it
  Rational rounding;       // texels
  Rational e_below, e_above;  // px: the position error lies in [-e_below, e_above]
};

struct AxisReach {
  Rational exact, below, above;
};

[[nodiscard]] Rational halves(int numerator) { return Rational(numerator) / 2; }

[[nodiscard]] Rational rounding_of(const HistoricLine& line, int32_t x_px) {
  if (line.profile == SELVAGE_PROFILE_DKIT) return halves(kDkitRoundingHalves);
  const int rows = std::max(line.left.rows, line.right.rows);
  const int pixels = x_px - line.left.column_px;
  const int presteps = line.profile == SELVAGE_PROFILE_ABRASH57 ? 2 * kUlpsPerPrestep : 0;
  return Rational(rows * kUlpsPerRow + pixels * kUlpsPerPixel + presteps) / SELVAGE_SUBTEXELS;
}

[[nodiscard]] SpanPoint span_point(const HistoricLine& line, int32_t x_px) {
  const auto [least, greatest] = std::minmax(line.left.x, line.right.x);
  const WholeColumnError e = whole_column_error(line.profile);
  return {.left_x = line.left.x,
          .width = line.right.x - line.left.x,
          .x = std::clamp<Rational>(Rational(x_px), least, greatest),
          .rounding = rounding_of(line, x_px),
          .e_below = halves(e.below_halves),
          .e_above = halves(e.above_halves)};
}

[[nodiscard]] AxisReach reach_along(const SpanPoint& point, const Rational& left,
                                    const Rational& right) {
  const Rational change = right - left;
  AxisReach reached{left, point.rounding, point.rounding};
  if (point.width == 0) return reached;  // one column, one end
  reached.exact += (point.x - point.left_x) / point.width * change;
  const Rational slope = change / point.width, most = abs(change);
  const Rational steepness = abs(slope);
  const bool rises = slope > 0;
  const Rational back =
      std::min<Rational>((rises ? point.e_below : point.e_above) * steepness, most);
  const Rational forth =
      std::min<Rational>((rises ? point.e_above : point.e_below) * steepness, most);
  reached.below += back;
  reached.above += forth;
  return reached;
}

}  // namespace

std::optional<Reach> reach(const HistoricLine& line, int32_t x_px) {
  if (!line.covers(x_px)) return std::nullopt;
  const SpanPoint point = span_point(line, x_px);
  const AxisReach u = reach_along(point, line.left.u, line.right.u);
  const AxisReach v = reach_along(point, line.left.v, line.right.v);
  return Reach{u.exact, v.exact, u.below, u.above, v.below, v.above};
}

std::optional<Reach> reach(const Case& c, int32_t x_px, int32_t y_px) {
  const std::optional<HistoricLine> line = historic_line(c.profile, c.vertices, y_px);
  return line ? reach(*line, x_px) : std::nullopt;
}

}  // namespace selvage::spec
