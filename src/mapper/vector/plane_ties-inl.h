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

#include <type_traits>

#include "mapper/exact_slab.h"
#include "mapper/span_batch.h"
#include "mapper/vector/limbs-inl.h"
#include "mapper/vector/near_ties-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// No texel is below 0 with so many more: (n + bias d) - (k + bias) d is n - k d.
inline constexpr int kTexelBiasBits = kTexelBits - kTexelFraction + 1;
inline constexpr int32_t kTexelBias = 1 << kTexelBiasBits;
static_assert(kTexelBiasBits + 1 <= TwoLimbs::kFactorBits);
static_assert(TwoLimbs::kDivisorZeros <= kTexelFraction);
static_assert(kDenominatorBits - kLeastSpareBits < TwoLimbs::kBits - 1, "|n - k d| and its sign");

// A numerator of texels that are kTexelBias more.
[[nodiscard]] HWY_INLINE ExactLine biased(const ExactLine& n, const ExactLine& d) {
  constexpr uint128 kTexels = kTexelBias;
  return {n.start + kTexels * d.start, n.step + kTexels * d.step};
}

// A number along a row.
template <class Walk>
class RowWalk {
 public:
  HWY_INLINE void set(const ExactLine& line) {
    start_ = Walk::scalar(line.start);
    step_ = Walk::scalar(line.step);
    walk_.set_step(step_);
  }
  // At a vector of pixels.
  [[nodiscard]] HWY_INLINE auto from(int32_t right_px) const {
    return walk_.from(start_ + times(right_px, step_));
  }

 protected:
  using Scalar = typename Walk::Scalar;
  Scalar start_;

 private:
  Scalar step_;
  Walk walk_;
};

// A number that is linear over the target.
template <class Walk>
class PlaneWalk : public RowWalk<Walk> {
 public:
  // In some row and in the one below it, from one column on.
  HWY_INLINE PlaneWalk(const ExactLine& row, const ExactLine& below)
      : first_(Walk::scalar(row.start)), down_(Walk::scalar(below.start - row.start)) {
    this->set(row);
  }
  HWY_INLINE void go_to_row(int32_t down_px) { this->start_ = first_ + times(down_px, down_); }

 private:
  typename Walk::Scalar first_, down_;
};

// A number that is the same at all pixels.
template <class Walk>
class ConstantWalk {
 public:
  HWY_INLINE ConstantWalk(const ExactLine& row, const ExactLine& /*below*/)
      : number_(number(row.start)) {}
  HWY_INLINE void go_to_row(int32_t /*down_px*/) {}
  [[nodiscard]] HWY_INLINE const auto& from(int32_t /*right_px*/) const { return number_; }

 private:
  static HWY_INLINE auto number(uint128 value) {
    Walk walk;
    walk.set_step(Walk::scalar(0));
    return walk.from(Walk::scalar(value));
  }
  decltype(number(0)) number_;
};

// Which near-ties of a vector reach the next whole number, by numbers at its pixels.
template <class Number>
struct Decision {
  template <class Numerator, class Divisor>
  static HWY_INLINE void decide(const Numerator& u, const Numerator& v, const Divisor& d,
                                int32_t right_px, const NearTies& near, V32* HWY_RESTRICT s,
                                V32* HWY_RESTRICT t) {
    const auto& divisor = d.from(right_px);
    if (!hn::AllFalse(D32(), near.u)) *s = raised(u.from(right_px), divisor, near.u, *s);
    if (!hn::AllFalse(D32(), near.v)) *t = raised(v.from(right_px), divisor, near.v, *t);
  }

 private:
  template <class Lanes>
  static HWY_INLINE V32 raised(const Lanes& n, const Lanes& divisor, hn::Mask<D32> near, V32 low) {
    const D32 d;
    const V32 next = hn::Add(low, hn::Set(d, 1));
    const V32 sign = Number::signs(n, hn::Add(next, hn::Set(d, kTexelBias)), divisor);
    return hn::IfThenElse(hn::AndNot(hn::Lt(sign, hn::Zero(d)), near), next, low);
  }
};

// As RowOfTies, in units of a texel, of anchored lanes. Divisors are linear or, of affine maps,
// constant.
template <class Number, template <class> class DivisorWalk>
class PlaneTies {
 public:
  // From the rows of the span's first pixel.
  PlaneTies(const ExactRows& rows, const Span& first_span)
      : first_px_(first_span.left_px),
        first_row_(first_span.row),
        span_(first_span),
        u_(biased(rows.row.u, rows.row.d), biased(rows.below.u, rows.below.d)),
        v_(biased(rows.row.v, rows.row.d), biased(rows.below.v, rows.below.d)),
        d_(rows.row.d, rows.below.d) {}

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
    Decision<Number>::decide(u_, v_, d_, span_.left_px - first_px_ + offset_px, near, s, t);
  }

 private:
  int32_t first_px_, first_row_;
  Span span_;
  PlaneWalk<typename Number::Numerator> u_, v_;
  DivisorWalk<typename Number::Divisor> d_;
};

// The same of rows in no plane.
template <class Number>
class RuledTies {
 public:
  explicit RuledTies(const RuledMap& map) : rows_(map) {}

  HWY_INLINE void go_to(const Span& span) {
    span_ = span;
    is_known_ = false;
  }
  // Before the first: of a row that there is not.
  [[nodiscard]] HWY_INLINE const Span& span() const { return span_; }
  HWY_INLINE void decide(int32_t offset_px, const NearTies& near, V32* HWY_RESTRICT s,
                         V32* HWY_RESTRICT t) {
    if (hn::AllFalse(D32(), hn::Or(near.u, near.v))) return;
    if (HWY_UNLIKELY(!is_known_)) find();
    Decision<Number>::decide(u_, v_, d_, offset_px, near, s, t);
  }

 private:
  HWY_NOINLINE void find() {
    const ExactRow row = rows_.row_from(span_.left_px, span_.row);
    u_.set(biased(row.u, row.d));
    v_.set(biased(row.v, row.d));
    d_.set(row.d);
    is_known_ = true;
  }

  std::conditional_t<Number::kBits == OneLimb::kBits, ShortRuledRowFinder, RuledRowFinder> rows_;
  Span span_{INT32_MIN, 0, 0};
  bool is_known_ = false;
  // If known:
  RowWalk<typename Number::Numerator> u_, v_;
  RowWalk<typename Number::Divisor> d_;
};

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
