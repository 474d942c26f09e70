// How u and v bend along a row in perspective.
//
// With numerators n, denominators d and their steps n', d' along a row, u' = K / d^2 where
//
//     K = n' d - n d'        the same at every pixel,         |u''| = 2 |K d'| / d^3
//
// (spec/README.md, 8.9). Under one map of the whole polygon K is linear from row to row: the terms
// in x cancel.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "mapper/lanes.h"
#include "mapper/span.h"

namespace selvage::mapper {

// A slope is off by less than this share of its terms without their signs
// (spec/proofs/chord_bound.g).
inline constexpr double kSlopeError = 0x1p-49;

// Of a row; of u or of v, whichever bends more.
struct RowBend {
  double slope_fx32;         // |K|, not below the true one
  double turn;               // |d'|
  double least_denominator;  // at the row's ends
};

class Slope {
 public:
  using Form = ProjectiveField::Form;

  // Of rows 0 to `rows` of a field.
  Slope(const Form& n, const Form& d, double rows)
      : first_(n.step_x * d.start - n.start * d.step_x),
        down_(n.step_x * d.step_y - n.step_y * d.step_x),
        error_(kSlopeError *
               (std::abs(n.step_x) * (std::abs(d.start) + rows * std::abs(d.step_y)) +
                std::abs(d.step_x) * (std::abs(n.start) + rows * std::abs(n.step_y)))) {}

  [[nodiscard]] double at(double row) const { return std::abs(first_ + row * down_) + error_; }
  // Of rows 0 to `rows`.
  [[nodiscard]] double least(double rows) const {
    const double last = first_ + rows * down_;
    const bool passes_zero = std::signbit(first_) != std::signbit(last);
    return (passes_zero ? 0 : std::min(std::abs(first_), std::abs(last))) + error_;
  }

 private:
  double first_, down_, error_;
};

// Of the rows of a field under one map.
class PlaneBend {
 public:
  PlaneBend(const ProjectiveField& field, int32_t rows)
      : field_(field),
        rows_(rows),
        u_(field.u_fx32, field.denominator, rows),
        v_(field.v_fx32, field.denominator, rows) {}

  [[nodiscard]] RowBend of(const Span& row) const {
    const ProjectiveField::Form& d = field_.denominator;
    const double dy = row.row - field_.first_row;
    const double left = d.start + dy * d.step_y + (row.left_px - field_.first_px) * d.step_x;
    const double right = left + (row.width_px() - 1) * d.step_x;
    return {std::max(u_.at(dy), v_.at(dy)), std::abs(d.step_x), std::min(left, right)};
  }
  // No row whose least denominator is at most so much bends less.
  [[nodiscard]] RowBend least(double most_denominator) const {
    return {std::max(u_.least(rows_), v_.least(rows_)), std::abs(field_.denominator.step_x),
            most_denominator};
  }

 private:
  const ProjectiveField& field_;
  double rows_;
  Slope u_, v_;
};

// Of a row with lanes of its own.
[[nodiscard]] inline RowBend bend_of(const DividedLanes& lanes, int32_t width_px) {
  const DividedLanes::Linear& d = lanes.denominator();
  const auto slope_fx32 = [&](const DividedLanes::Linear& n) {
    const double a = n.step * d.start, b = n.start * d.step;
    return std::abs(a - b) + kSlopeError * (std::abs(a) + std::abs(b));
  };
  return {std::max(slope_fx32(lanes.u_numerator_fx32()), slope_fx32(lanes.v_numerator_fx32())),
          std::abs(d.step), std::min(d.start, d.start + (width_px - 1) * d.step)};
}

}  // namespace selvage::mapper
