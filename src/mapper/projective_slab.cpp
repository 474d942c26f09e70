#include "mapper/projective_slab.h"

#include <algorithm>
#include <cmath>

#include "mapper/exact_slab.h"
#include "mapper/to_double.h"

namespace selvage::mapper {
namespace {

inline constexpr double kLaneUnit = 4294967296.0;  // 2^kLaneFraction
inline constexpr double kMostTexel_fx32 = kLaneUnit * (1 << (kTexelBits - kTexelFraction));

// n(y) = start + y down + y (y - 1) / 2 bend, and the steps. Twice a coefficient is whole.
[[nodiscard]] ProjectiveField::Form form_of(const ExactSlab::Line& line, double unit) {
  const auto times = [](uint128 n, double by) { return to_double(static_cast<int128>(n)) * by; };
  const double half = unit / 2;
  return {times(line.start, unit), times(line.step, unit), times(2 * line.down - line.bend, half),
          times(line.turn, unit), times(line.bend, half)};
}

// How far it may get from 0 in so many columns and rows, and so its change from a pixel to the next
// one right of it.
[[nodiscard]] double most_step(const ProjectiveField::Form& form, double rows) {
  return std::abs(form.step_x) + rows * std::abs(form.step_xy);
}
[[nodiscard]] double most(const ProjectiveField::Form& form, double columns, double rows) {
  return std::abs(form.start) + columns * most_step(form, rows) +
         rows * (std::abs(form.step_y) + rows * std::abs(form.step_yy));
}

// What the outline's vertices have at most and, of q, at least.
struct Extremes {
  double texel_fx16;
  int32_t least_q = 1, most_q = 1;  // of an affine one, as Slab::at() has it

  explicit Extremes(const Polygon& outline)
      : texel_fx16(static_cast<double>(outline.texels.furthest_fx16())) {
    if (outline.affine) return;
    least_q = outline.least_q;
    for (const selvage_vertex& vertex : outline.vertices) most_q = std::max(most_q, vertex.q);
  }
};

[[nodiscard]] double height_fx8(const Edge& edge) {
  return static_cast<double>(edge.bottom().y) - edge.top().y;
}

// In `part` both weights of a pixel are distances of no more than the outline's width, and a sum of
// a few numbers of up to so many bits is one of 128.
[[nodiscard]] bool fit_128_bits(const Slab& slab, const Polygon& outline,
                                const Extremes& extremes) {
  constexpr double kMostNumerator = 0x1p122;
  const double heights = height_fx8(slab.a) * height_fx8(slab.b);
  const double width_fx8 = (outline.right_px - outline.left_px + 1.0) * kSubpixels;
  const double most_u = std::max(extremes.texel_fx16, 1.0 * (1 << kTexelFraction));
  return most_u * extremes.most_q * heights * 2 * width_fx8 < kMostNumerator;
}

// How far the edges are from each other, times both heights: linear in the row.
struct Widths {
  double least, most;

  Widths(const Slab& slab, int32_t first_row, int32_t last_row) {
    const double first = width(slab, first_row), last = width(slab, last_row);
    least = std::min(first, last);
    most = std::max(first, last);
  }

 private:
  [[nodiscard]] static double width(const Slab& slab, int32_t row) {
    const EdgePoint left = slab.a.at(row), right = slab.b.at(row);
    return to_double(int128{right.x} * left.height - int128{left.x} * right.height);
  }
};

}  // namespace

// The bound is derived as that of ProjectivePlane::set_lanes (spec/proofs/projective_plane.g).
std::optional<ProjectiveField> ruled_field(const Slab& any, const Polygon& outline,
                                           const selvage_rect& part) {
  const std::optional<Slab> sided = from_left_to_right(any);
  if (!sided) return std::nullopt;
  const Slab& slab = *sided;
  const Extremes extremes(outline);
  const double rows = part.bottom - part.top, columns = part.right - part.left;
  if (rows < kLeastFieldRows || !fit_128_bits(slab, outline, extremes)) return std::nullopt;

  const ExactSlab at({slab.a, slab.b, part.top, part.bottom}, part.left);
  // Denominators are in units of the least one, or of a little less.
  constexpr double kRoundedDown = 1 - 0x1p-50, kPerQ = 1 << kTexelFraction;
  const Widths widths(slab, part.top, part.bottom - 1);
  if (widths.least == 0) return std::nullopt;  // the edges touch
  const double unit = 1 / (widths.least * extremes.least_q * kPerQ * kRoundedDown);
  ProjectiveField field{part.left,
                        part.top,
                        form_of(at.u(), unit * kLaneUnit),
                        form_of(at.v(), unit * kLaneUnit),
                        form_of(at.d(), unit),
                        0};
  const double numerator =
      std::max(most(field.u_fx32, columns, rows), most(field.v_fx32, columns, rows));
  const double reach = numerator / kMostTexel_fx32 + most(field.denominator, columns, rows);
  if (!(reach <= kMostReach)) return std::nullopt;
  field.error_fx32 = static_cast<int64_t>(reach) + kProjectiveTruncations_fx32;
  field.turn = most_step(field.denominator, rows);
  field.steepest_fx32 = std::max(most_step(field.u_fx32, rows), most_step(field.v_fx32, rows)) +
                        extremes.texel_fx16 * (1 << (kLaneFraction - kTexelFraction)) * field.turn;
  field.is_ruled = true;
  field.most_denominator = widths.most * extremes.most_q * kPerQ;
  return field;
}

}  // namespace selvage::mapper
