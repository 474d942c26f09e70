// The lanes of a slab's rows by vectors of them: what find_ruled_lanes_scalar() finds, operation by
// operation. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_RULED_ROWS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_RULED_ROWS_INL_H
#undef SELVAGE_VECTOR_RULED_ROWS_INL_H
#else
#define SELVAGE_VECTOR_RULED_ROWS_INL_H
#endif

#include <cstddef>

#include "mapper/affine_slab.h"
#include "mapper/plane_lanes.h"
#include "mapper/vector/entries-inl.h"
#include "mapper/vector/kernel-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

using RowTag = hn::Repartition<double, D32>;
using Rows = hn::Vec<RowTag>;
using RowLaneTag = hn::RebindToSigned<RowTag>;
using RowLanes = hn::Vec<RowLaneTag>;
inline constexpr int32_t kRowsAtOnce = kLanes / 2;

struct EdgeRows {
  Rows x, u, v;

  HWY_INLINE EdgeRows(const AffineEdge& edge, Rows rows_below)
      : x(number(edge.first().x, edge.down().x, rows_below)),
        u(number(edge.first().u, edge.down().u, rows_below)),
        v(number(edge.first().v, edge.down().v, rows_below)) {}

 private:
  static HWY_INLINE Rows number(double first, double down, Rows rows_below) {
    const RowTag d;
    return hn::Add(hn::Set(d, first), hn::Mul(rows_below, hn::Set(d, down)));
  }
};

// Of less than kMostRounded_fx32: lanes, or steps from pixel to pixel.
[[nodiscard]] HWY_INLINE RowLanes floors_fx32(Rows estimates_fx32) {
  const RowTag d;
  const RowLaneTag whole;
  const Rows lowered = hn::Floor(hn::Sub(estimates_fx32, hn::Set(d, kRuledSlack_fx32)));
  const Rows to_whole = hn::Set(d, kRoundToWhole);
  return hn::Sub(hn::BitCast(whole, hn::Add(lowered, to_whole)), hn::BitCast(whole, to_whole));
}
static_assert(kTexelBits - kTexelFraction + 1 + kLaneFraction < 50);

// Where `has` is not, 0.
HWY_INLINE void store_lanes(hn::Mask<RowTag> has, RowLanes u, RowLanes v, Lane* to) {
  static_assert(sizeof(Lane) == sizeof(int64_t[2]) && offsetof(Lane, v_fx32) == sizeof(int64_t));
  const RowLaneTag d;
  const auto kept = hn::RebindMask(d, has);
  hn::StoreInterleaved2(hn::IfThenElseZero(kept, u), hn::IfThenElseZero(kept, v), d, &to->u_fx32);
}

}  // namespace

void find_ruled_lanes(const AffineSlab& slab, const SpanBatch& batch, int32_t first_index,
                      int32_t end_index, RuledRows* rows) {
  constexpr double kUnit_fx32 = 1 << (kLaneFraction - kTexelFraction);
  const RowTag d;
  const hn::Rebind<int32_t, RowTag> pixels;
  const Rows height_a = hn::Set(d, slab.a.height()), height_b = hn::Set(d, slab.b.height());
  Rows most_denominator = hn::Set(d, rows->most_denominator);
  for (int32_t i = first_index; i < end_index; i += kRowsAtOnce) {
    const auto left_px = hn::LoadU(pixels, batch.left_px.data() + i);
    const auto right_px = hn::LoadU(pixels, batch.right_px.data() + i);
    const Rows width_px = hn::PromoteTo(d, hn::Sub(right_px, left_px));
    const auto is_row = hn::Lt(hn::Iota(d, i), hn::Set(d, end_index));
    const auto has_pixels = hn::And(is_row, hn::Gt(width_px, hn::Zero(d)));
    const auto has_step = hn::And(is_row, hn::Gt(width_px, hn::Set(d, 1.0)));

    const Rows below = hn::Iota(d, batch.first_row + i - slab.first_row);
    const EdgeRows a(slab.a, below), b(slab.b, below);
    const Rows centre =
        hn::Add(hn::Mul(hn::PromoteTo(d, left_px), hn::Set(d, kSubpixels)), hn::Set(d, kHalfPixel));
    const Rows weight_a = hn::Sub(b.x, hn::Mul(centre, height_b));
    const Rows weight_b = hn::Sub(hn::Mul(centre, height_a), a.x);
    const Rows width = hn::Add(hn::Mul(weight_a, height_a), hn::Mul(weight_b, height_b));
    const Rows denominator = hn::Mul(hn::Abs(width), hn::Set(d, 1 << kTexelFraction));
    most_denominator =
        hn::Max(most_denominator, hn::IfThenElse(has_pixels, denominator, most_denominator));

    const Rows per_width = hn::Div(hn::Set(d, kUnit_fx32), width);
    const auto mean = [&](Rows of_a, Rows of_b) HWY_ATTR {
      const Rows sum = hn::Add(hn::Mul(of_a, weight_a), hn::Mul(of_b, weight_b));
      return floors_fx32(hn::Mul(sum, per_width));
    };
    const auto row = static_cast<size_t>(i);
    store_lanes(has_pixels, mean(a.u, b.u), mean(a.v, b.v), rows->start.data() + row);
    const Rows per_px = hn::Mul(per_width, hn::Set(d, kSubpixels));
    const auto step = [&](Rows of_a, Rows of_b) HWY_ATTR {
      const Rows rise = hn::Sub(hn::Mul(of_b, height_a), hn::Mul(of_a, height_b));
      return floors_fx32(hn::Mul(rise, per_px));
    };
    store_lanes(has_step, step(a.u, b.u), step(a.v, b.v), rows->step.data() + row);
  }
  rows->most_denominator = hn::GetLane(hn::MaxOfLanes(d, most_denominator));
}

}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
