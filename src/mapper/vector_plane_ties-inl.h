// Near-ties of a batch by vectors. Included once for each SIMD target.
//
// n and d are linear in both directions of the target, or each row is by itself. The sign of n - k
// d is wanted, and where |n - k d| < 2^(bits - 1) it is that of the same number modulo 2^bits,
// however large n and k d are.
#if defined(SELVAGE_VECTOR_PLANE_TIES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_PLANE_TIES_INL_H
#undef SELVAGE_VECTOR_PLANE_TIES_INL_H
#else
#define SELVAGE_VECTOR_PLANE_TIES_INL_H
#endif

#include <optional>

#include "mapper/near_tie_bits.h"
#include "mapper/span_batch.h"
#include "mapper/vector_limbs-inl.h"
#include "mapper/vector_near_ties-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// No texel is below 0 with so many more: (n + bias d) - (k + bias) d is n - k d.
inline constexpr int kTexelBiasBits = kTexelBits - kTexelFraction + 1;
inline constexpr int32_t kTexelBias = 1 << kTexelBiasBits;
static_assert(kTexelBiasBits + 1 <= TwoLimbs::kFactorBits);
static_assert(TwoLimbs::kDivisorZeros <= kTexelFraction);
static_assert(kDenominatorBits - kLeastSpareBits < TwoLimbs::kBits - 1, "|n - k d| and its sign");

// A batch's exact rows: the first one from its first pixel on, and the one below from there.
struct BatchRows {
  ExactRow first, below;

  HWY_INLINE BatchRows(const ExactMap& map, const Span& first_span)
      : first(map.row_from(first_span.left_px, first_span.row)),
        below(map.row_below(first_span.left_px, first_span.row)) {}
  // Of one row.
  HWY_INLINE explicit BatchRows(const ExactRow& row) : first(row), below(row) {}

  // Whether one limb tells near-ties that are no further from the whole number than 2^-spare_bits.
  [[nodiscard]] HWY_INLINE bool are_short(const SpanBatch& batch, int spare_bits) const {
    const uint128 down = below.d.start - first.d.start;
    return are_64_enough(most_in_box(first.d, down, batch), spare_bits);
  }
};

// A number that is linear over the target.
template <class Walk, class Scalar>
class PlaneWalk {
 public:
  // At some pixel, and how much more it is right of it and below it.
  HWY_INLINE PlaneWalk(Scalar here, Scalar right, Scalar down)
      : start_(here), right_(right), down_(down), row_start_(here), walk_(right) {}

  HWY_INLINE void go_to_row(int32_t down_px) { row_start_ = start_ + times(down_px, down_); }
  [[nodiscard]] HWY_INLINE auto from(int32_t right_px) const {
    return walk_.from(row_start_ + times(right_px, right_));
  }

 private:
  static HWY_INLINE Scalar times(int32_t steps, Scalar by) {
    return static_cast<Scalar>(int128{steps}) * by;
  }

  Scalar start_, right_, down_, row_start_;
  Walk walk_;
};

// As RowOfTies, in units of a texel, of anchored lanes.
template <class Number>
class PlaneTies {
 public:
  HWY_INLINE PlaneTies(const BatchRows& rows, const Span& first_span)
      : first_px_(first_span.left_px),
        first_row_(first_span.row),
        span_(first_span),
        u_(biased(rows.first.u, rows.below.u, rows)),
        v_(biased(rows.first.v, rows.below.v, rows)),
        d_(plane<typename Number::Divisor>(rows.first.d, rows.below.d.start)) {}

  HWY_INLINE void go_to(const Span& span) {
    span_ = span;
    const int32_t down_px = span.row - first_row_;
    u_.go_to_row(down_px);
    v_.go_to_row(down_px);
    d_.go_to_row(down_px);
  }
  [[nodiscard]] HWY_INLINE const Span& span() const { return span_; }

  HWY_INLINE void decide(int32_t offset_px, const NearTies& near, V32* HWY_RESTRICT s,
                         V32* HWY_RESTRICT t) const {
    const int32_t right_px = span_.left_px - first_px_ + offset_px;
    const auto divisor = d_.from(right_px);
    if (!hn::AllFalse(D32(), near.u)) *s = raised(u_.from(right_px), divisor, near.u, *s);
    if (!hn::AllFalse(D32(), near.v)) *t = raised(v_.from(right_px), divisor, near.v, *t);
  }

 private:
  using Scalar = typename Number::Scalar;
  template <class Walk>
  static HWY_INLINE PlaneWalk<Walk, Scalar> plane(const ExactLine& line, uint128 below) {
    return {static_cast<Scalar>(line.start), static_cast<Scalar>(line.step),
            static_cast<Scalar>(below - line.start)};
  }
  static HWY_INLINE auto biased(const ExactLine& n, const ExactLine& n_below,
                                const BatchRows& rows) {
    constexpr uint128 kTexels = kTexelBias;
    const ExactLine line{n.start + kTexels * rows.first.d.start,
                         n.step + kTexels * rows.first.d.step};
    return plane<typename Number::Numerator>(line, n_below.start + kTexels * rows.below.d.start);
  }

  template <class Lanes>
  static HWY_INLINE V32 raised(const Lanes& n, const Lanes& divisor, hn::Mask<D32> near, V32 low) {
    const D32 d;
    const V32 next = hn::Add(low, hn::Set(d, 1));
    const V32 sign = Number::signs(n, hn::Add(next, hn::Set(d, kTexelBias)), divisor);
    return hn::IfThenElse(hn::AndNot(hn::Lt(sign, hn::Zero(d)), near), next, low);
  }

  int32_t first_px_, first_row_;
  Span span_;
  PlaneWalk<typename Number::Numerator, Scalar> u_, v_;
  PlaneWalk<typename Number::Divisor, Scalar> d_;
};

// The same of rows in no plane: each is found where it is gone to.
template <class Number>
class RuledTies {
 public:
  HWY_INLINE explicit RuledTies(const ExactMap& map) : map_(&map) {}

  HWY_NOINLINE void go_to(const Span& span) {
    span_ = span;
    ties_ = PlaneTies<Number>(BatchRows(map_->row_from(span.left_px, span.row)), span);
  }
  // Before the first: of a row that there is not.
  [[nodiscard]] HWY_INLINE const Span& span() const { return span_; }
  HWY_INLINE void decide(int32_t offset_px, const NearTies& near, V32* HWY_RESTRICT s,
                         V32* HWY_RESTRICT t) const {
    ties_->decide(offset_px, near, s, t);
  }

 private:
  const ExactMap* map_;
  Span span_{INT32_MIN, 0, 0};
  std::optional<PlaneTies<Number>> ties_;
};

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
