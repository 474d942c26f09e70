// Lanes: fast one-sided approximations of u and v along a span, in 32.32 texels (fx32).
//
// At every pixel of the span
//
//     lane <= true value < lane + margin,          margin in units of 2^-32 texel.
//
// So floor(lane) is the exact texel unless the lane's fraction is within `margin` of 1; only such
// near-ties are decided by exact integers (exact_row.h). spec/proofs proves it, with the bounds
// below.
#pragma once

#include <cmath>
#include <cstdint>

#include "mapper/span.h"

namespace selvage::mapper {

inline constexpr int kLaneFraction = 32;
static_assert(kTexelBits - kTexelFraction + 1 + kLaneFraction < 63, "a lane fits int64_t");
// A step times an offset is the difference of two lanes, and less than one unit an offset off.
static_assert(kTexelBits - kTexelFraction + 2 + kLaneFraction < 63, "a lane's walk fits int64_t");

// What an affine lane loses at the span's start, and again at each step: the floor's remainder.
inline constexpr uint32_t kAffineErrorPerPixel_fx32 = 1;
// Those floors are first estimated in double, off by at most this.
inline constexpr double kEstimateError_fx32 = 0.25;
static_assert(kEstimateError_fx32 < 1, "one correction by one unit makes the floor");

// A projective lane's error is at most kProjectiveErrorPerRatio times the ratio of the denominators
// at the span's ends; truncating it costs one unit and truncating the ratio another.
inline constexpr double kProjectiveErrorPerRatio_fx32 = 0.2;
inline constexpr int64_t kProjectiveTruncations_fx32 = 2;
static_assert(kProjectiveErrorPerRatio_fx32 <= 1, "the ratio itself serves as a bound");

// Affine spans have at most 2^16 pixels; no ratio is above that of the greatest q to the least.
inline constexpr int64_t kWidestMargin_fx32 =
    2 * ((int64_t{1} << kQBits) + kProjectiveTruncations_fx32);
static_assert(kWidestMargin_fx32 >= int64_t{kAffineErrorPerPixel_fx32} << 16);
static_assert(kWidestMargin_fx32 < int64_t{1} << kLaneFraction, "a near-tie is this texel or next");

struct Lane {
  int64_t u_fx32, v_fx32;
};

// The lanes of all pixels under one affine map: floors of its start and of its steps right and
// down.
struct AffineField {
  int32_t first_px, first_row;  // the pixel of `start`: none lies left of it or above
  Lane start, step_x, step_y;
  uint32_t margin_fx32;  // of the lane furthest from the start

  // Modulo 2^64: a product may leave 64 bits where the sum does not.
  [[nodiscard]] Lane at(int32_t px, int32_t row) const {
    const auto dx = static_cast<uint64_t>(px - first_px);
    const auto dy = static_cast<uint64_t>(row - first_row);
    const auto sum = [&](int64_t from, int64_t right, int64_t down) {
      return static_cast<int64_t>(static_cast<uint64_t>(from) + dx * static_cast<uint64_t>(right) +
                                  dy * static_cast<uint64_t>(down));
    };
    return {sum(start.u_fx32, step_x.u_fx32, step_y.u_fx32),
            sum(start.v_fx32, step_x.v_fx32, step_y.v_fx32)};
  }
};

// Lanes of a span with constant denominator: start and step are floors, so that a lane is low by
// less than a unit for each step since the last exact floor.
class AffineLanes {
 public:
  // Exact floors at the span's first pixel.
  AffineLanes(const SpanMap& map, const Span& span);
  AffineLanes(Lane start, Lane step, uint32_t margin_fx32)
      : start_(start), step_(step), margin_fx32_(margin_fx32) {}

  // The same lanes, of this span alone.
  [[nodiscard]] AffineField field(const Span& span) const {
    return {span.left_px, span.row, start_, step_, {}, margin_fx32_};
  }
  [[nodiscard]] uint32_t margin_fx32() const { return margin_fx32_; }
  [[nodiscard]] Lane step() const { return step_; }
  [[nodiscard]] Lane at(int32_t offset_px) const {
    return Lane{start_.u_fx32 + step_.u_fx32 * offset_px, start_.v_fx32 + step_.v_fx32 * offset_px};
  }

 private:
  Lane start_{}, step_{};
  uint32_t margin_fx32_;
};

// Lanes of a span whose denominator varies: one division a pixel, in double, with a certified
// bound.
class DividedLanes {
 public:
  // value(i) = start + i * step
  struct Linear {
    double start, step;
  };

  DividedLanes(const Linear& u_fx32, const Linear& v_fx32, const Linear& denominator,
               int64_t error_fx32)
      : u_(u_fx32), v_(v_fx32), denominator_(denominator), error_fx32_(error_fx32) {}

  [[nodiscard]] uint32_t margin_fx32() const { return static_cast<uint32_t>(2 * error_fx32_); }
  [[nodiscard]] Lane at(int32_t offset_px) const {
    const double i = offset_px;
    const double w = 1.0 / (denominator_.start + i * denominator_.step);
    return Lane{static_cast<int64_t>((u_.start + i * u_.step) * w) - error_fx32_,
                static_cast<int64_t>((v_.start + i * v_.step) * w) - error_fx32_};
  }

  // u is u_numerator() / denominator(), off by less than error_fx32() however it is rounded.
  [[nodiscard]] const Linear& u_numerator_fx32() const { return u_; }
  [[nodiscard]] const Linear& v_numerator_fx32() const { return v_; }
  [[nodiscard]] const Linear& denominator() const { return denominator_; }
  [[nodiscard]] int64_t error_fx32() const { return error_fx32_; }

 private:
  Linear u_, v_;  // numerators, scaled so that u comes out in fx32
  Linear denominator_;
  int64_t error_fx32_;
};

// The lanes of all pixels under one projective map, or under those between two edges.
struct ProjectiveField {
  // With x = px - first_px and y = row - first_row
  //
  //     value(px, row) = start + x (step_x + y step_xy) + y (step_y + y step_yy),
  //
  // linear along a row; one map for all rows has no step_xy and no step_yy.
  struct Form {
    double start, step_x, step_y;
    double step_xy = 0, step_yy = 0;
  };

  int32_t first_px, first_row;
  Form u_fx32, v_fx32, denominator;
  int64_t error_fx32;  // as of DividedLanes
  // From a pixel to the next: the most that u or v changes by, cancellation left out, and the most
  // that the denominator does, as a share of itself. Infinite where nobody has found out.
  double steepest_fx32 = HUGE_VAL;
  double turn = HUGE_VAL;
  bool is_ruled = false;  // whether there may be a step_xy or a step_yy
  // Where it is ruled: no denominator of the exact map is greater, but for roundings.
  double most_denominator = HUGE_VAL;

  [[nodiscard]] DividedLanes of(const Span& span) const {
    const double dx = span.left_px - first_px, dy = span.row - first_row;
    const auto along = [&](const Form& form) {
      const double step_x = form.step_x + dy * form.step_xy;
      const double step_y = form.step_y + dy * form.step_yy;
      return DividedLanes::Linear{form.start + dy * step_y + dx * step_x, step_x};
    };
    return {along(u_fx32), along(v_fx32), along(denominator), error_fx32};
  }
};

// Those of a span between two edges.
class ProjectiveLanes : public DividedLanes {
 public:
  ProjectiveLanes(const SpanMap& map, const Span& span);

  // The same lanes, of this span alone.
  [[nodiscard]] ProjectiveField field(const Span& span) const;
  // Of the greater denominator at the span's ends to the lesser one.
  [[nodiscard]] double ratio() const { return ratio_; }

 private:
  ProjectiveLanes(const SpanMap& map, const Span& span, double ratio);

  double ratio_;
};

}  // namespace selvage::mapper
