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

#include "mapper/span_batch.h"
#include "mapper/vector/limbs-inl.h"
#include "mapper/vector/near_ties-inl.h"
#include "mapper/vector/row_walk-inl.h"
#include "mapper/vector/ruled_numbers-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

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
  explicit RuledTies(const RuledMap& map) : numbers_(map) {}

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
    numbers_.set(span_, &u_, &v_, &d_);
    is_known_ = true;
  }

  RuledNumbers<Number> numbers_;
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
