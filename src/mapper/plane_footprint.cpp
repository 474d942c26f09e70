#include "mapper/plane_footprint.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "mapper/projective_plane.h"
#include "mapper/wide.h"

namespace selvage::mapper {
namespace {

// |n| < 2^115 with at most three roundings.
[[nodiscard]] double to_double(int128 n) {
  constexpr int kLowBits = 52;
  const auto low = static_cast<int64_t>(n) & ((int64_t{1} << kLowBits) - 1);
  return static_cast<double>(static_cast<int64_t>(n >> kLowBits)) * 0x1p52 +
         static_cast<double>(low);
}

[[nodiscard]] int64_t times_q(const selvage_vertex& vertex, int32_t selvage_vertex::*of) {
  return int64_t{vertex.*of} * vertex.q;
}

// ceil((|A| + |B|) / D): both are below 2^57.
[[nodiscard]] int32_t affine_side(const PlaneFrame::Gradient<int64_t>& gradient, int64_t area) {
  const int64_t sum = std::abs(gradient.along_x) + std::abs(gradient.along_y);
  return static_cast<int32_t>(
      std::clamp<int64_t>((sum + area - 1) / area, kLeastSide_fx8, kMostSide_fx8));
}

}  // namespace

BoxSides affine_sides(const PlaneFrame& frame) {
  const auto side = [&](int32_t selvage_vertex::*of) {
    const int64_t value = frame.origin().*of;
    return affine_side(
        frame.gradient<int64_t>(frame.second().*of - value, frame.third().*of - value),
        frame.doubled_area());
  };
  return {side(&selvage_vertex::u), side(&selvage_vertex::v)};
}

PlaneFootprint::Terms PlaneFootprint::terms(const PlaneFrame& frame, int32_t selvage_vertex::*of) {
  const int64_t q = frame.origin().q, uq = times_q(frame.origin(), of);
  const int64_t q_second = frame.second().q - q, q_third = frame.third().q - q;
  const int64_t uq_second = times_q(frame.second(), of) - uq;
  const int64_t uq_third = times_q(frame.third(), of) - uq;
  const auto a = frame.gradient<int128>(uq_second, uq_third);
  const auto b = frame.gradient<int64_t>(q_second, q_third);
  return {a.along_x * q - int128{uq} * b.along_x, a.along_y * q - int128{uq} * b.along_y,
          int128{uq_second} * q_third - int128{uq_third} * q_second};
}

// The bound, e = 2^-53. With Q = D q_least d, d the lanes' denominator, a side is (|J_x| + |J_y|)
// unit / d^2 with unit = 1 / (D q_least^2). Let M be the most that |J_x| + |J_y| can be over the
// rectangle, terms without their signs. Each J is a start and a product, rounded as the terms of
// ProjectivePlane are, times a unit rounded twice; so is M. d >= 1 is off by less than
// kPlaneRoundings e R with the reach R >= d, and by its own unit's roundings; its reciprocal
// squared by twice so much. With all that a kernel makes of them, a side is off by less than
//
//     kSideRoundings (R + 2) e M <= kSideRoundings (error_fx32 + 1) e M
//
// over d^2 (spec/proofs/plane_footprint.g).
PlaneFootprint::Line PlaneFootprint::line(const Terms& terms, double unit) const {
  const int64_t x = centre_fx8(lanes_.first_px) - int64_t{frame_.origin().x};
  const int64_t y = centre_fx8(lanes_.first_row) - int64_t{frame_.origin().y};
  Line line{to_double(terms.across_start + y * terms.gradient) * unit,
            to_double(terms.down_start - x * terms.gradient) * unit,
            to_double(terms.gradient) * (unit * kSubpixels), 0};
  const double most = std::abs(line.across_start) + std::abs(line.down_start) +
                      (columns_ + rows_) * std::abs(line.step);
  line.slack = kSideRoundings * static_cast<double>(lanes_.error_fx32 + 1) * 0x1p-53 * most;
  return line;
}

PlaneFootprint::PlaneFootprint(const Polygon& polygon, const selvage_rect& visible,
                               const ProjectiveField& lanes)
    : frame_(PlaneFrame::of(polygon.vertices)),
      lanes_(lanes),
      columns_(std::min(visible.right, polygon.right_px) - lanes.first_px),
      rows_(std::min(visible.bottom, polygon.bottom_row) - lanes.first_row),
      u_terms_(terms(frame_, &selvage_vertex::u)),
      v_terms_(terms(frame_, &selvage_vertex::v)) {
  const double least_q = polygon.least_q;
  const double unit = 1 / (static_cast<double>(frame_.doubled_area()) * (least_q * least_q));
  u_ = line(u_terms_, unit);
  v_ = line(v_terms_, unit);
}

FootprintLine PlaneFootprint::of_span(const Line& line, const Span& span) const {
  return {std::abs(line.across_start + (span.row - lanes_.first_row) * line.step),
          line.down_start - (span.left_px - lanes_.first_px) * line.step, -line.step, line.slack};
}

FootprintRow PlaneFootprint::row(const Span& span) const {
  return {of_span(u_, span), of_span(v_, span), lanes_.of(span).denominator()};
}

// |J_y| and the denominator are greatest and least at the ends.
bool FootprintRow::is_least(int32_t count) const {
  const int32_t last = count - 1;
  const double weight =
      1 / std::min(denominator.start, denominator.start + last * denominator.step);
  const auto most = [&](const FootprintLine& line) {
    const double end = line.down_start + last * line.down_step;
    return (line.across + std::max(std::abs(line.down_start), std::abs(end)) + line.slack) *
           weight * weight;
  };
  return most(u) <= kLeastSide_fx8 && most(v) <= kLeastSide_fx8;
}

// The denominator is 1 at least.
bool PlaneFootprint::is_least(const Line& line) const {
  const auto most = [](double start, double change) {
    return std::max(std::abs(start), std::abs(start + change));
  };
  return most(line.across_start, rows_ * line.step) + most(line.down_start, -columns_ * line.step) +
             line.slack <=
         kLeastSide_fx8;
}

// D (|J_x| + |J_y|)
Wide PlaneFootprint::changes(const Terms& terms, int64_t x, int64_t y) const {
  return product(magnitude(terms.across_start + y * terms.gradient) +
                     magnitude(terms.down_start - x * terms.gradient),
                 static_cast<uint128>(frame_.doubled_area()));
}

BoxSides PlaneFootprint::exact(int32_t px, int32_t row, BoxSides least, BoxSides most) const {
  const int64_t x = centre_fx8(px) - int64_t{frame_.origin().x};
  const int64_t y = centre_fx8(row) - int64_t{frame_.origin().y};
  const int64_t q = frame_.origin().q;
  const auto gradient = frame_.gradient<int64_t>(frame_.second().q - q, frame_.third().q - q);
  const auto denominator =
      static_cast<uint128>(int128{q} * frame_.doubled_area() + int128{gradient.along_x} * x +
                           int128{gradient.along_y} * y);
  return {least_side(changes(u_terms_, x, y), denominator, least.u_fx8, most.u_fx8),
          least_side(changes(v_terms_, x, y), denominator, least.v_fx8, most.v_fx8)};
}

}  // namespace selvage::mapper
