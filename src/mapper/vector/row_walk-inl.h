// A number along a row, by vectors, and from row to row. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_ROW_WALK_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_ROW_WALK_INL_H
#undef SELVAGE_VECTOR_ROW_WALK_INL_H
#else
#define SELVAGE_VECTOR_ROW_WALK_INL_H
#endif

#include "mapper/exact_row.h"
#include "mapper/vector/kernel.h"
#include "mapper/vector/limbs-inl.h"

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
  using Scalar = typename Walk::Scalar;

  HWY_INLINE void set(const Scalar& start, const Scalar& step) {
    start_ = start;
    step_ = step;
    walk_.set_step(step);
  }
  HWY_INLINE void set(const ExactLine& line) {
    set(Walk::scalar(line.start), Walk::scalar(line.step));
  }
  // At a vector of pixels.
  [[nodiscard]] HWY_INLINE auto from(int32_t right_px) const {
    return walk_.from(start_ + times(right_px, step_));
  }

 protected:
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

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
