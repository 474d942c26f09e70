// Near-ties by vectors: the sign of n - k d for each pixel, exactly. Included once for each SIMD
// target.
//
// n and d are linear along the row, so that from its i-th pixel on, at the j-th one of a vector,
//
//     n - k d = n_0 + (i + j) n' - k d_i - (k j) d'
//
// is a sum of products of 32-bit numbers by wide ones. Those are split into balanced digits
// [-2^31, 2^31) to the base 2^32; sums of one digit stay below 2^60, and only their carries run
// from digit to digit.
#if defined(SELVAGE_VECTOR_NEAR_TIES_KERNEL_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_NEAR_TIES_KERNEL_INL_H
#undef SELVAGE_VECTOR_NEAR_TIES_KERNEL_INL_H
#else
#define SELVAGE_VECTOR_NEAR_TIES_KERNEL_INL_H
#endif

#include <hwy/highway.h>

#include <bit>
#include <cstring>

#include "mapper/exact_row.h"
#include "mapper/filter_point.h"
#include "mapper/vector_kernel.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

inline constexpr int kDigitBits = 32;
inline constexpr int kMostDigits = 4;

// The value modulo 2^128, the least digit first.
struct Digits {
  int32_t digit[kMostDigits];
};

[[nodiscard]] HWY_INLINE Digits digits_of(uint128 value) {
  constexpr uint128 kHalf = uint128{0x8000000080000000} << 64 | 0x8000000080000000;
  static_assert(std::endian::native == std::endian::little);
  const uint128 balanced = (value + kHalf) ^ kHalf;
  Digits digits;
  std::memcpy(&digits, &balanced, sizeof digits);
  return digits;
}

// Sums are kept positive by so much, so that carries may be shifted as unsigned numbers.
inline constexpr int kSumBits = 62;
inline constexpr int64_t kBias = int64_t{1} << kSumBits;
inline constexpr int kMostLanesLog2 = 4;
static_assert(1 << kMostLanesLog2 == kMostLanes);
static_assert(kTexelBits - kTexelFraction + kGridBits + 1 + kMostLanesLog2 + kDigitBits < kSumBits,
              "(k j) d' in steps of the grid");

// The exact row of a span, once some vector of it holds a near-tie; in units of 2^-bits texel.
class RowOfTies {
 public:
  HWY_INLINE RowOfTies(const ExactMap& map, const Span& span, int bits)
      : map_(&map), span_(span), bits_(bits) {}

  HWY_INLINE void go_to(const Span& span) {
    span_ = span;
    is_known_ = false;
  }

  // Adds 1 to those of the whole numbers that are too low: none is by more. They belong to the
  // pixels from an offset in the span on; what those beyond its end become means nothing.
  template <class D>
  HWY_INLINE void decide(D d, int32_t offset_px, bool any_u, bool any_v, hn::Vec<D>* HWY_RESTRICT s,
                         hn::Vec<D>* HWY_RESTRICT t) {
    if (HWY_UNLIKELY(!is_known_)) find();
    switch (form_) {
      case Form::kShort:
        return raise<2, false>(d, offset_px, constant_divisor_, any_u, any_v, s, t);
      case Form::kMiddle:
        return raise<3, false>(d, offset_px, constant_divisor_, any_u, any_v, s, t);
      case Form::kLong:
        return raise<kMostDigits, false>(d, offset_px, constant_divisor_, any_u, any_v, s, t);
      case Form::kVarying:
        return raise<kMostDigits, true>(d, offset_px, digits_of(d_.at(offset_px)), any_u, any_v, s,
                                        t);
    }
  }

 private:
  // Each digit of the start is one of a sum: with its bias, and less the one that is carried to it.
  struct DigitLine {
    int64_t start[kMostDigits];
    Digits step;
  };
  [[nodiscard]] static DigitLine line_of(const ExactLine& line) {
    const Digits start = digits_of(line.start);
    DigitLine digits{{}, digits_of(line.step)};
    for (int at = 0; at < kMostDigits; ++at) {
      digits.start[at] = start.digit[at] + kBias - (at == 0 ? 0 : kBias >> kDigitBits);
    }
    return digits;
  }
  // Of denominators d. |n - k d| <= d, so that 64 or 96 bits tell its sign where d has fewer.
  enum class Form { kShort, kMiddle, kLong, kVarying };
  [[nodiscard]] static Form form_of(const ExactLine& d) {
    if (d.step != 0) return Form::kVarying;
    if (d.start >> (2 * kDigitBits - 2) == 0) return Form::kShort;
    return d.start >> (3 * kDigitBits - 2) == 0 ? Form::kMiddle : Form::kLong;
  }

  template <int kDigits, bool kVaries, class D>
  HWY_INLINE void raise(D d, int32_t offset_px, const Digits& divisor, bool any_u, bool any_v,
                        hn::Vec<D>* HWY_RESTRICT s, hn::Vec<D>* HWY_RESTRICT t) const {
    const hn::Vec<D> at = hn::Iota(d, offset_px);
    if (any_u) *s = raised<kDigits, kVaries>(d, u_, divisor, at, *s);
    if (any_v) *t = raised<kDigits, kVaries>(d, v_, divisor, at, *t);
  }

  template <int kDigits, bool kVaries, class D>
  HWY_INLINE hn::Vec<D> raised(D d, const DigitLine& n, const Digits& divisor, hn::Vec<D> at,
                               hn::Vec<D> low) const {
    const hn::Vec<D> next = hn::Add(low, hn::Set(d, 1));
    const hn::Vec<D> sign = highest_digit<kDigits, kVaries>(d, n, divisor, at, next);
    return hn::IfThenElse(hn::Lt(sign, hn::Zero(d)), low, next);
  }

  HWY_NOINLINE void find() {
    const ExactRow row = map_->row_from(span_.left_px, span_.row).finer(bits_);
    u_ = line_of(row.u);
    v_ = line_of(row.v);
    d_ = row.d;
    constant_divisor_ = digits_of(row.d.start);
    divisor_step_ = digits_of(row.d.step);
    form_ = form_of(row.d);
    is_known_ = true;
  }

  // Of the difference, modulo 2^(32 kDigits), the highest digit: it has the sign.
  template <int kDigits, bool kVaries, class D>
  HWY_INLINE hn::Vec<D> highest_digit(D d, const DigitLine& n, const Digits& divisor, hn::Vec<D> i,
                                      hn::Vec<D> k) const {
    constexpr int kTop = kDigits - 1;
    const hn::Vec<D> kj = kVaries ? hn::Mul(k, hn::Iota(d, 0)) : k;
    const auto even = sum_below<kTop, kVaries>(d, n, divisor, i, k, kj);
    const auto odd = sum_below<kTop, kVaries>(d, n, divisor, odd_of(d, i), odd_of(d, k),
                                              kVaries ? odd_of(d, kj) : k);
    const auto carry =
        hn::OddEven(hn::BitCast(d, odd), hn::BitCast(d, hn::ShiftRight<kDigitBits>(even)));
    hn::Vec<D> digit = hn::Add(carry, hn::Set(d, static_cast<int32_t>(n.start[kTop])));
    digit = hn::Add(digit, hn::Mul(i, hn::Set(d, n.step.digit[kTop])));
    digit = hn::Sub(digit, hn::Mul(k, hn::Set(d, divisor.digit[kTop])));
    if constexpr (kVaries)
      digit = hn::Sub(digit, hn::Mul(kj, hn::Set(d, divisor_step_.digit[kTop])));
    return digit;
  }

  // The odd lanes in the even ones' places.
  template <class D>
  static HWY_INLINE hn::Vec<D> odd_of(D d, hn::Vec<D> v) {
    return hn::BitCast(d, hn::ShiftRight<kDigitBits>(hn::BitCast(hn::RepartitionToWide<D>(), v)));
  }

  // The digits below kTop, for the even lanes: the upper halves carry into the next one.
  template <int kTop, bool kVaries, class D>
  HWY_INLINE hn::Vec<hn::RepartitionToWide<D>> sum_below(D d, const DigitLine& n,
                                                         const Digits& divisor, hn::Vec<D> i,
                                                         hn::Vec<D> k, hn::Vec<D> kj) const {
    const hn::RepartitionToWide<D> wide;
    auto sum = hn::Set(wide, n.start[0]);
    for (int at = 0; at < kTop; ++at) {
      if (at > 0) {
        const auto carry =
            hn::ShiftRight<kDigitBits>(hn::BitCast(hn::RebindToUnsigned<decltype(wide)>(), sum));
        sum = hn::Add(hn::BitCast(wide, carry), hn::Set(wide, n.start[at]));
      }
      sum = hn::Add(sum, hn::MulEven(i, hn::Set(d, n.step.digit[at])));
      sum = hn::Sub(sum, hn::MulEven(k, hn::Set(d, divisor.digit[at])));
      if constexpr (kVaries)
        sum = hn::Sub(sum, hn::MulEven(kj, hn::Set(d, divisor_step_.digit[at])));
    }
    return sum;
  }

  const ExactMap* map_;
  Span span_;
  int bits_;
  bool is_known_ = false;
  Form form_;  // and all that follows, if known
  DigitLine u_, v_;
  ExactLine d_;
  Digits constant_divisor_, divisor_step_;
};

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
