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
#if defined(SELVAGE_VECTOR_NEAR_TIES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_NEAR_TIES_INL_H
#undef SELVAGE_VECTOR_NEAR_TIES_INL_H
#else
#define SELVAGE_VECTOR_NEAR_TIES_INL_H
#endif

#include <bit>
#include <cstring>

#include "mapper/boundary.h"
#include "mapper/exact_row.h"
#include "mapper/filter_point.h"
#include "mapper/vector/kernel-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

inline constexpr int kDigitBits = 32;
inline constexpr int kMostDigits = 4;

// The value modulo 2^128, the least digit first.
struct Digits {
  int32_t digit[kMostDigits];
};

[[nodiscard]] HWY_INLINE Digits digits_of(uint128 value) {
  constexpr uint128 kHalf = uint128{0x8000000080000000} << 64 | 0x8000000080000000;
  const uint128 balanced = (value + kHalf) ^ kHalf;
  Digits digits;
  for (int at = 0; at < kMostDigits; ++at) {
    digits.digit[at] = static_cast<int32_t>(balanced >> (at * kDigitBits));
  }
  return digits;
}

// Sums are kept positive by so much, so that carries may be shifted as unsigned numbers.
inline constexpr int kSumBits = 62;
inline constexpr int64_t kBias = int64_t{1} << kSumBits;
inline constexpr int kMostLanesLog2 = 4;
static_assert(1 << kMostLanesLog2 == kMostLanes);
static_assert(kTexelBits - kTexelFraction + kGridBits + 1 + kMostLanesLog2 + kDigitBits < kSumBits,
              "(k j) d' in steps of the grid");

// Which of a vector's pixels are near-ties.
struct NearTies {
  hn::Mask<D32> u, v;
};

// The exact row of a span, once some vector of it holds a near-tie; in units of 2^-bits texel.
class RowOfTies {
 public:
  // A near-tie is no further from the whole number than 2^-spare_bits.
  HWY_INLINE RowOfTies(const ExactMap& map, const Span& span, int bits, int spare_bits)
      : map_(&map), span_(span), bits_(bits), spare_bits_(spare_bits) {}

  HWY_INLINE void go_to(const Span& span) {
    span_ = span;
    is_known_ = false;
    if (map_->is_ruled()) {  // no boundary goes on straight
      u_boundary_ = {};
      v_boundary_ = {};
    }
    u_boundary_.is_row_known = false;
    v_boundary_.is_row_known = false;
  }
  [[nodiscard]] HWY_INLINE const Span& span() const { return span_; }

  // Adds 1 to those of the near-ties' whole numbers that are too low: none is by more. They belong
  // to the pixels from an offset in the span on; what those beyond its end become means nothing.
  HWY_INLINE void decide(int32_t offset_px, const NearTies& near, V32* HWY_RESTRICT s,
                         V32* HWY_RESTRICT t) {
    const NearTies rest{
        u_boundary_.tries == 0 ? near.u : settle(&u_boundary_, &ExactRow::u, offset_px, near.u, s),
        v_boundary_.tries == 0 ? near.v : settle(&v_boundary_, &ExactRow::v, offset_px, near.v, t)};
    if (hn::AllFalse(D32(), hn::Or(rest.u, rest.v))) return;
    if (HWY_UNLIKELY(!is_known_)) find();
    if (varies_) {
      raise_by<true>(offset_px, digits_of(divisor_at(offset_px)), rest, s, t);
    } else {
      raise_by<false>(offset_px, constant_divisor_, rest, s, t);
    }
  }

 private:
  // The one that the near-ties of some vectors in turn lay next to. It is worth finding after so
  // many of them, and not worth asking for where several others came before.
  struct KnownBoundary {
    static constexpr int32_t kWorth = 4, kTries = 3;
    int32_t whole = INT32_MIN;
    int32_t vectors = 0, tries = kTries;
    Boundary line;
    // Of a row.
    bool is_row_known = false;
    Boundary::Sides sides{};
  };

  // Decides near-ties that lie next to one boundary all, the one of those before. Returns what is
  // left: nothing, or all of them.
  HWY_INLINE hn::Mask<D32> settle(KnownBoundary* known, ExactLine ExactRow::*coordinate,
                                  int32_t offset_px, hn::Mask<D32> near,
                                  V32* HWY_RESTRICT low) const {
    const D32 d;
    const V32 at = hn::Iota(d, offset_px), next = hn::Add(*low, hn::Set(d, 1));
    const auto is_pixel =
        hn::And(hn::Gt(at, hn::Set(d, -1)), hn::Lt(at, hn::Set(d, span_.width_px())));
    const auto asked = hn::And(near, is_pixel);
    if (hn::AllFalse(d, asked)) return asked;
    if (!hn::AllFalse(d, hn::And(asked, hn::Ne(next, hn::Set(d, known->whole))))) {
      --known->tries;
      known->whole = hn::GetLane(next);
      known->vectors = 1;
      return asked;
    }
    if (known->vectors < KnownBoundary::kWorth) {
      ++known->vectors;
      return asked;
    }
    if (known->vectors == KnownBoundary::kWorth) {
      if (!is_worth_finding(offset_px)) return asked;
      find(known, coordinate);
    }
    if (!known->is_row_known) find_sides(known);
    const Boundary::Sides sides = known->sides;
    if (sides.left_px < 0) return asked;
    const auto is_left = hn::Lt(at, hn::Set(d, sides.left_px));
    const auto beyond = sides.left_beyond ? hn::And(asked, is_left) : hn::AndNot(is_left, asked);
    *low = hn::IfThenElse(beyond, next, *low);
    return hn::FirstN(d, 0);
  }
  // It serves what is left of this row, and rows below if one map does.
  [[nodiscard]] HWY_INLINE bool is_worth_finding(int32_t offset_px) const {
    return !map_->is_ruled() || span_.width_px() - offset_px >= KnownBoundary::kWorth * kLanes;
  }
  HWY_NOINLINE void find(KnownBoundary* known, ExactLine ExactRow::*coordinate) const {
    known->line = {*map_, coordinate, bits_, known->whole, span_.left_px, span_.row};
    ++known->vectors;
    known->tries = KnownBoundary::kTries;
    known->is_row_known = false;
  }
  HWY_NOINLINE void find_sides(KnownBoundary* known) const {
    known->sides = known->line.sides_of(span_);
    known->is_row_known = true;
  }

  [[nodiscard]] HWY_INLINE uint128 divisor_at(int32_t offset_px) const {
    return d_.start + static_cast<uint128>(int128{offset_px}) * d_.step;
  }

  // Each digit of the start is one of a sum: with its bias, and less the one that is carried to it.
  struct DigitLine {
    int64_t start[kMostDigits];
    Digits step;
  };
  static HWY_INLINE void set(const ExactLine& line, DigitLine* digits) {
    const Digits start = digits_of(line.start);
    for (int at = 0; at < kMostDigits; ++at) {
      digits->start[at] = start.digit[at] + kBias - (at == 0 ? 0 : kBias >> kDigitBits);
    }
    digits->step = digits_of(line.step);
  }
  // |n - k d| <= d / 2^spare_bits, so that 64 or 96 bits tell its sign where all denominators of
  // the span leave them so much room.
  [[nodiscard]] int digits_for(const ExactLine& d) const {
    const uint128 most = HWY_MAX(d.start, d.at(span_.width_px() - 1)) >> spare_bits_;
    int digits = 2;
    while (digits < kMostDigits && most >> (digits * kDigitBits - 2) != 0) ++digits;
    return digits;
  }

  template <bool kVaries>
  HWY_INLINE void raise_by(int32_t offset_px, const Digits& divisor, const NearTies& near,
                           V32* HWY_RESTRICT s, V32* HWY_RESTRICT t) const {
    switch (digits_) {
      case 2:
        return raise<2, kVaries>(offset_px, divisor, near, s, t);
      case 3:
        return raise<3, kVaries>(offset_px, divisor, near, s, t);
      default:
        return raise<kMostDigits, kVaries>(offset_px, divisor, near, s, t);
    }
  }

  template <int kDigits, bool kVaries>
  HWY_INLINE void raise(int32_t offset_px, const Digits& divisor, const NearTies& near,
                        V32* HWY_RESTRICT s, V32* HWY_RESTRICT t) const {
    const D32 d;
    const V32 at = hn::Iota(d, offset_px);
    if (!hn::AllFalse(d, near.u)) *s = raised<kDigits, kVaries>(u_, divisor, at, near.u, *s);
    if (!hn::AllFalse(d, near.v)) *t = raised<kDigits, kVaries>(v_, divisor, at, near.v, *t);
  }

  template <int kDigits, bool kVaries>
  HWY_INLINE V32 raised(const DigitLine& n, const Digits& divisor, V32 at, hn::Mask<D32> near,
                        V32 low) const {
    const D32 d;
    const V32 next = hn::Add(low, hn::Set(d, 1));
    const V32 sign = highest_digit<kDigits, kVaries>(d, n, divisor, at, next);
    return hn::IfThenElse(hn::AndNot(hn::Lt(sign, hn::Zero(d)), near), next, low);
  }

  HWY_NOINLINE void find() {
    const ExactRow row = map_->row_from(span_.left_px, span_.row);
    set(row.u, &u_);
    set(row.v, &v_);
    const ExactLine d = row.finer_d(bits_);
    digits_ = digits_for(d);
    varies_ = d.step != 0;
    if (varies_) {
      d_ = d;
      divisor_step_ = digits_of(d.step);
    } else {
      constant_divisor_ = digits_of(d.start);
    }
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
  int bits_, spare_bits_;
  KnownBoundary u_boundary_, v_boundary_;
  bool is_known_ = false;
  // If known:
  bool varies_;
  int digits_;
  DigitLine u_, v_;
  Digits constant_divisor_;  // or, if d varies:
  ExactLine d_;
  Digits divisor_step_;
};

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
