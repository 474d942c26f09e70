// Near-ties of a batch by vectors, where 64 bits tell them. Included once for each SIMD target.
//
// n and d are linear in both directions of the target, or the batch is one row. The sign of n - k d
// is wanted, and where |n - k d| < 2^63 it is that of the same number modulo 2^64, however large n
// and k d are.
#if defined(SELVAGE_VECTOR_PLANE_TIES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_PLANE_TIES_INL_H
#undef SELVAGE_VECTOR_PLANE_TIES_INL_H
#else
#define SELVAGE_VECTOR_PLANE_TIES_INL_H
#endif

#include "mapper/near_tie_bits.h"
#include "mapper/span_batch.h"
#include "mapper/vector_near_ties-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

using D64 = hn::Repartition<uint64_t, D32>;
using V64 = hn::Vec<D64>;

// Of the even lanes of 32 bits and of the odd ones.
struct WideLanes {
  V64 even, odd;
};

// A number along a span, modulo 2^64.
class WideLine {
 public:
  HWY_INLINE WideLine(uint64_t here, uint64_t right, uint64_t below)
      : start_(here), right_(right), down_(below - here), row_start_(here) {
    const D64 d;
    const V64 steps = hn::Iota(d, 0), right_by = hn::Set(d, right);
    const V64 even = hn::Mul(hn::Add(steps, steps), right_by);
    hn::Store(even, d, even_);
    hn::Store(hn::Add(even, right_by), d, odd_);
  }

  HWY_INLINE void go_to(int64_t right_px, int64_t down_px) {
    row_start_ =
        start_ + static_cast<uint64_t>(right_px) * right_ + static_cast<uint64_t>(down_px) * down_;
  }
  [[nodiscard]] HWY_INLINE WideLanes from(int64_t offset_px) const {
    const D64 d;
    const V64 first = hn::Set(d, row_start_ + static_cast<uint64_t>(offset_px) * right_);
    return {hn::Add(first, hn::Load(d, even_)), hn::Add(first, hn::Load(d, odd_))};
  }

 private:
  uint64_t start_, right_, down_, row_start_;
  HWY_ALIGN uint64_t even_[kLanes / 2], odd_[kLanes / 2];  // on the way from a vector's first lane
};

// As RowOfTies, in units of a texel.
class PlaneTies {
 public:
  HWY_INLINE PlaneTies(const ExactMap& map, const SpanBatch& batch)
      : PlaneTies(map.row_from(batch.left_px[0], batch.first_row),
                  map.row_from(batch.left_px[0], batch.first_row + 1), batch) {}

  // Whether they tell near-ties that are no further from the whole number than 2^-spare_bits.
  [[nodiscard]] HWY_INLINE bool are_enough(int spare_bits) const {
    return are_64_enough(most_d_, spare_bits);
  }

  HWY_INLINE void go_to(const Span& span) {
    span_ = span;
    const int64_t right_px = span.left_px - first_px_, down_px = span.row - first_row_;
    u_.go_to(right_px, down_px);
    v_.go_to(right_px, down_px);
    d_.go_to(right_px, down_px);
  }
  [[nodiscard]] HWY_INLINE const Span& span() const { return span_; }

  HWY_INLINE void decide(int32_t offset_px, const NearTies& near, V32* HWY_RESTRICT s,
                         V32* HWY_RESTRICT t) const {
    const WideLanes divisor = d_.from(offset_px);
    if (!hn::AllFalse(D32(), near.u)) *s = raised(u_.from(offset_px), divisor, near.u, *s);
    if (!hn::AllFalse(D32(), near.v)) *t = raised(v_.from(offset_px), divisor, near.v, *t);
  }

 private:
  // No texel is below 0 with so many more: (n + bias d) - (k + bias) d is n - k d.
  static constexpr int32_t kTexelBias = 1 << (kTexelBits - kTexelFraction + 1);

  HWY_INLINE PlaneTies(const ExactRow& here, const ExactRow& below, const SpanBatch& batch)
      : first_px_(batch.left_px[0]),
        first_row_(batch.first_row),
        span_(batch.span(0)),
        u_(biased(here.u, here.d, below.u, below.d)),
        v_(biased(here.v, here.d, below.v, below.d)),
        d_(low(here.d.start), low(here.d.step), low(below.d.start)),
        most_d_(most_in_box(here.d, below.d.start - here.d.start, batch)) {}

  static HWY_INLINE uint64_t low(uint128 a) { return static_cast<uint64_t>(a); }
  static HWY_INLINE WideLine biased(const ExactLine& n, const ExactLine& d,
                                    const ExactLine& n_below, const ExactLine& d_below) {
    constexpr auto kBias = static_cast<uint64_t>(kTexelBias);
    return {low(n.start) + kBias * low(d.start), low(n.step) + kBias * low(d.step),
            low(n_below.start) + kBias * low(d_below.start)};
  }

  // Modulo 2^64, by the lower halves of k.
  static HWY_INLINE V64 product(V64 k, V64 divisor) {
    const hn::Repartition<uint32_t, D64> d;
    const V64 low = hn::MulEven(hn::BitCast(d, k), hn::BitCast(d, divisor));
    const V64 high = hn::MulEven(hn::BitCast(d, k), hn::BitCast(d, hn::ShiftRight<32>(divisor)));
    return hn::Add(low, hn::ShiftLeft<32>(high));
  }
  static HWY_INLINE V32 raised(const WideLanes& n, const WideLanes& divisor, hn::Mask<D32> near,
                               V32 low) {
    const D32 d;
    const V32 next = hn::Add(low, hn::Set(d, 1));
    const V64 k = hn::BitCast(D64(), hn::Add(next, hn::Set(d, kTexelBias)));
    const V64 even = hn::Sub(n.even, product(k, divisor.even));
    const V64 odd = hn::Sub(n.odd, product(hn::ShiftRight<32>(k), divisor.odd));
    const V32 sign = hn::OddEven(hn::BitCast(d, odd), hn::BitCast(d, hn::ShiftRight<32>(even)));
    return hn::IfThenElse(hn::AndNot(hn::Lt(sign, hn::Zero(d)), near), next, low);
  }

  int32_t first_px_, first_row_;
  Span span_;
  WideLine u_, v_, d_;
  int128 most_d_;
};

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
