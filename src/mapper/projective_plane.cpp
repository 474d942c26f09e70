#include "mapper/projective_plane.h"

#include <algorithm>
#include <cmath>

#include "mapper/to_double.h"

namespace selvage::mapper {
namespace {

inline constexpr double kLaneUnit = 4294967296.0;  // 2^kLaneFraction
inline constexpr double kMostTexel_fx32 = kLaneUnit * (1 << (kTexelBits - kTexelFraction));

// How far a line may get from 0 in so many columns and rows.
[[nodiscard]] double most(const ProjectiveField::Form& line, double columns, double rows) {
  return std::abs(line.start) + columns * std::abs(line.step_x) + rows * std::abs(line.step_y);
}

[[nodiscard]] int64_t times_q(int32_t texel_fx16, int32_t q) { return int64_t{texel_fx16} * q; }

}  // namespace

template <class Integer, class Of>
ProjectivePlane::Quantity<Integer> ProjectivePlane::quantity(const PlaneFrame& frame,
                                                             const Of& of) {
  const int64_t value = of(frame.origin());
  const auto gradient =
      frame.gradient<Integer>(of(frame.second()) - value, of(frame.third()) - value);
  return {value, gradient.along_x, gradient.along_y};
}

ProjectivePlane::ProjectivePlane(const PlaneFrame& frame)
    : x_fx8_(frame.origin().x),
      y_fx8_(frame.origin().y),
      doubled_area_(frame.doubled_area()),
      uq_(quantity<int128>(frame, [](const selvage_vertex& v) { return times_q(v.u, v.q); })),
      vq_(quantity<int128>(frame, [](const selvage_vertex& v) { return times_q(v.v, v.q); })),
      q_(quantity<int64_t>(frame, [](const selvage_vertex& v) { return int64_t{v.q}; })) {}

bool ProjectivePlane::passes_through(const selvage_vertex& vertex) const {
  const int64_t x = int64_t{vertex.x} - x_fx8_, y = int64_t{vertex.y} - y_fx8_;
  const auto lies_on = [&](const auto& quantity, int64_t value) {
    return int128{value - quantity.at_origin} * doubled_area_ ==
           int128{quantity.along_x} * x + int128{quantity.along_y} * y;
  };
  return lies_on(q_, vertex.q) && lies_on(uq_, times_q(vertex.u, vertex.q)) &&
         lies_on(vq_, times_q(vertex.v, vertex.q));
}

bool ProjectivePlane::is_of(std::span<const selvage_vertex> vertices) const {
  if (doubled_area_ == 0) return false;
  const auto is_on = [&](const selvage_vertex& vertex) { return passes_through(vertex); };
  return vertices.size() == 3 || std::ranges::all_of(vertices, is_on);
}

template <class Integer>
ProjectiveField::Form ProjectivePlane::line(const Quantity<Integer>& quantity, double unit) const {
  const double step = unit * kSubpixels;
  return {to_double(at(quantity, lanes_.first_px, lanes_.first_row)) * unit,
          to_double(quantity.along_x) * step, to_double(quantity.along_y) * step};
}

// The bound. Let S be the most that a numerator can be in the rectangle, the sum of its terms
// without their signs, T the same of the denominator, least the least denominator, and U = 2^15 >=
// |u|. A value added up is off by kPlaneRoundings 2^-53 S, or T. With the reach (S / U + T) /
// least, which is at least 1, and with the roundings of the reciprocal and its product, u is off by
// less than
//
//     2^-53 (2 kPlaneRoundings + 2) U reach <= kPlaneErrorPerReach_fx32 reach
//
// in units of 2^-32 texel (spec/proofs/projective_plane.g).
bool ProjectivePlane::set_lanes(const Polygon& polygon, const selvage_rect& visible) {
  lanes_.first_px = std::max(visible.left, polygon.left_px);
  lanes_.first_row = std::max(visible.top, polygon.top_row);
  const double columns =
      std::max<int32_t>(std::min(visible.right, polygon.right_px) - lanes_.first_px, 0);
  const double rows =
      std::max<int32_t>(std::min(visible.bottom, polygon.bottom_row) - lanes_.first_row, 0);

  // Denominators are in units of the least one.
  const double unit = 1 / (static_cast<double>(doubled_area_) * polygon.least_q);
  constexpr double kTexelsPerUnit = kLaneUnit / (1 << kTexelFraction);
  lanes_.u_fx32 = line(uq_, unit * kTexelsPerUnit);
  lanes_.v_fx32 = line(vq_, unit * kTexelsPerUnit);
  lanes_.denominator = line(q_, unit);
  const double numerator =
      std::max(most(lanes_.u_fx32, columns, rows), most(lanes_.v_fx32, columns, rows));
  const double reach = numerator / kMostTexel_fx32 + most(lanes_.denominator, columns, rows);
  if (!(reach <= kMostReach)) return false;
  lanes_.error_fx32 = static_cast<int64_t>(reach) + kProjectiveTruncations_fx32;
  // u' = (N' - u D') / D, and D is at least a unit.
  lanes_.turn = std::abs(lanes_.denominator.step_x);
  lanes_.steepest_fx32 =
      std::max(std::abs(lanes_.u_fx32.step_x), std::abs(lanes_.v_fx32.step_x)) +
      static_cast<double>(polygon.texels.furthest_fx16()) * kTexelsPerUnit * lanes_.turn;
  return true;
}

std::optional<ProjectivePlane> ProjectivePlane::by(const PlaneFrame& frame, const Polygon& polygon,
                                                   const selvage_rect& visible) {
  std::optional<ProjectivePlane> plane(std::in_place, frame);
  if (!plane->is_of(polygon.vertices) || !plane->set_lanes(polygon, visible)) plane.reset();
  return plane;
}

std::optional<ProjectivePlane> ProjectivePlane::of(const Polygon& polygon,
                                                   const selvage_rect& visible) {
  return by(PlaneFrame::of(polygon.vertices), polygon, visible);
}

std::optional<ProjectivePlane> ProjectivePlane::of_all(const Polygon& polygon) {
  return by(PlaneFrame::canonical(polygon.vertices), polygon,
            {polygon.left_px, polygon.top_row, polygon.right_px, polygon.bottom_row});
}

}  // namespace selvage::mapper
