// Affine spans without lanes that lack something: exact quotients along the rows, so that no pixel
// is in doubt. They cost more than lanes, and less than deciding near-ties where those are many.
// Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_AFFINE_EXACT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_AFFINE_EXACT_INL_H
#undef SELVAGE_VECTOR_AFFINE_EXACT_INL_H
#else
#define SELVAGE_VECTOR_AFFINE_EXACT_INL_H
#endif

#include "mapper/vector/affine_lanes-inl.h"
#include "mapper/vector/left-inl.h"
#include "mapper/vector/quotients-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// Whether the denominator fits the remainders. That of a plane always does.
[[nodiscard]] HWY_INLINE bool has_quotients(const AffineSpans& spans) {
  return spans.exact.row_from(spans.field.first_px, spans.batch.first_row).d.start >> 64 == 0;
}

// A coordinate over the rows of a batch: n / d texels, n linear.
class ExactCoordinate {
 public:
  // From the numerators at some pixel and at the one below it. Lanes' steps are those of n over d,
  // in 2^-32 texel, rounded down, or lowered by some units: they may fall where n rises.
  HWY_INLINE ExactCoordinate(const ExactLine& n, uint128 below, uint64_t divisor, int64_t step_fx32)
      : n_(n),
        down_(below - n.start),
        divisor_(divisor),
        step_(quotient_from(n.step, divisor, floor_texel(step_fx32))),
        walk_(walk_by(&step_, divisor)),
        by_vector_(step_, divisor),
        least_lane_(static_cast<int128>(n.step) < 0 ? kLanes - 1 : 0) {}

  // A vector of pixels from so many right of the first one and below it on. The lane of its first
  // pixel is less than a texel low, and its texel fits 32 bits.
  [[nodiscard]] HWY_INLINE Quotients from(int32_t right_px, int32_t down_px,
                                          int64_t lane_fx32) const {
    const uint128 n = n_.at(right_px) + static_cast<uint128>(int128{down_px}) * down_;
    return QuotientSum(quotient_from(n, divisor_, floor_texel(lane_fx32)), divisor_).of(walk_);
  }
  // From a row to the one below it, by the lanes' step.
  [[nodiscard]] HWY_INLINE QuotientSum step_down(int64_t step_fx32) const {
    return {quotient_from(down_, divisor_, floor_texel(step_fx32)), divisor_};
  }
  [[nodiscard]] HWY_INLINE Quotients next_vector(const Quotients& at) const {
    return by_vector_.of(at);
  }
  [[nodiscard]] HWY_INLINE int32_t least_texel(const Quotients& at) const {
    HWY_ALIGN int32_t texel[kLanes];
    hn::Store(at.whole, D32(), texel);
    return texel[least_lane_];
  }

 private:
  ExactLine n_;
  uint128 down_;
  uint64_t divisor_;
  Quotient step_;  // of a vector
  Quotients walk_;
  QuotientSum by_vector_;
  int32_t least_lane_;
};

// The rows from an index in the batch on, by windows of so many rows, or, where there are none, by
// loads. There must be quotients.
template <class Pixel, class Address>
HWY_NOINLINE void draw_exactly(const AffineSpans& spans, const Surface& surface,
                               int32_t first_index, int32_t window_rows) {
  const AffineField field = spans.field;
  const int32_t first_row = spans.batch.first_row + first_index;
  const auto [first, below] = spans.exact.rows_from(field.first_px, first_row);
  const auto divisor = static_cast<uint64_t>(first.d.start);
  const ExactCoordinate exact_u(first.u, below.u.start, divisor, field.step_x.u_fx32);
  const ExactCoordinate exact_v(first.v, below.v.start, divisor, field.step_x.v_fx32);
  const TexelDraw<Address> draw(surface);
  for (int32_t i = first_index; i < spans.batch.rows; ++i) {
    Span rest = spans.batch.span(i);
    const Lane lane = field.at(rest.left_px, rest.row);
    const int32_t right_px = rest.left_px - field.first_px, down_px = i - first_index;
    Quotients u = exact_u.from(right_px, down_px, lane.u_fx32);
    Quotients v = exact_v.from(right_px, down_px, lane.v_fx32);
    for (; !rest.empty(); rest.left_px += kLanes) {
      draw.template draw<Pixel>(rest, {u.whole, v.whole},
                                {exact_u.least_texel(u), exact_v.least_texel(v), window_rows});
      u = exact_u.next_vector(u);
      v = exact_v.next_vector(v);
    }
  }
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
