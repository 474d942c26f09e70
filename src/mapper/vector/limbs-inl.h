// Wide numbers of kLanes pixels, one limb of 64 bits each or two. Included once for each SIMD
// target.
#if defined(SELVAGE_VECTOR_LIMBS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_LIMBS_INL_H
#undef SELVAGE_VECTOR_LIMBS_INL_H
#else
#define SELVAGE_VECTOR_LIMBS_INL_H
#endif

#include "mapper/vector/kernel-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

using D64 = hn::Repartition<uint64_t, D32>;
using V64 = hn::Vec<D64>;

// Of the even lanes of 32 bits and of the odd ones.
template <class Number>
struct ByParity {
  Number even, odd;
};

// The step times 0, 1, 2, ..., for the pixels of a vector, modulo 2^64. AVX-512 has a product of 64
// bits, others would make it of several.
[[nodiscard]] HWY_INLINE ByParity<V64> multiples_of(uint64_t step) {
  const D64 d;
  const V64 even_pixel = hn::Add(hn::Iota(d, 0), hn::Iota(d, 0));
  const V64 once = hn::Set(d, step);
#if HWY_TARGET == HWY_AVX3
  const V64 even = hn::Mul(once, even_pixel);
#else
  V64 even = hn::Zero(d), times_bit = once;
#pragma GCC unroll 4
  for (uint64_t bit = 2; bit < kLanes; bit *= 2) {
    times_bit = hn::Add(times_bit, times_bit);
    even = hn::Add(even, hn::IfThenElseZero(hn::TestBit(even_pixel, hn::Set(d, bit)), times_bit));
  }
#endif
  return {even, hn::Add(even, once)};
}

// The lower half of each lane and, in its place, the upper one.
[[nodiscard]] HWY_INLINE ByParity<V64> words_of(V32 v) {
  const V64 both = hn::BitCast(D64(), v);
  return {both, hn::ShiftRight<32>(both)};
}

// Of the lower halves.
[[nodiscard]] HWY_INLINE V64 word_product(V64 a, V64 b) {
  const hn::Repartition<uint32_t, D64> words;
  return hn::MulEven(hn::BitCast(words, a), hn::BitCast(words, b));
}
// The upper halves, each in its lane.
[[nodiscard]] HWY_INLINE V32 upper_halves(const ByParity<V64>& v) {
  const D32 d;
  return hn::OddEven(hn::BitCast(d, v.odd), hn::BitCast(d, hn::ShiftRight<32>(v.even)));
}
// Those of a - k b, modulo 2^64.
[[nodiscard]] HWY_INLINE V32 upper_halves_of_difference(const ByParity<V64>& a, V32 k,
                                                        const ByParity<V64>& b) {
  const ByParity<V64> by = words_of(k);
  const V32 carried = upper_halves({hn::Sub(a.even, word_product(by.even, b.even)),
                                    hn::Sub(a.odd, word_product(by.odd, b.odd))});
  return hn::Sub(carried, hn::Mul(k, upper_halves(b)));
}

// Modulo 2^64, and modulo 2^128.
[[nodiscard]] HWY_INLINE uint64_t times(int64_t n, uint64_t a) {
  return static_cast<uint64_t>(n) * a;
}
[[nodiscard]] HWY_INLINE uint128 times(int64_t n, uint128 a) {
  return static_cast<uint128>(int128{n}) * a;
}

HWY_INLINE void add(const uint64_t* HWY_RESTRICT more, uint64_t* HWY_RESTRICT to) {
  const D64 d;
  hn::Store(hn::Add(hn::Load(d, to), hn::Load(d, more)), d, to);
}

// Modulo 2^64.
struct OneLimb {
  static constexpr int kBits = 64;

  // A number at kLanes pixels in turn.
  class Walk {
   public:
    using Scalar = uint64_t;
    static HWY_INLINE Scalar scalar(uint128 a) { return static_cast<uint64_t>(a); }
    static HWY_INLINE Scalar sum(Scalar a, Scalar b) { return a + b; }
    HWY_INLINE void set_step(Scalar step) {
      const D64 d;
      const ByParity<V64> by = multiples_of(step);
      hn::Store(by.even, d, even_);
      hn::Store(by.odd, d, odd_);
    }
    // By another's, more.
    HWY_INLINE void add_step(const Walk& more) {
      add(more.even_, even_);
      add(more.odd_, odd_);
    }
    [[nodiscard]] HWY_INLINE ByParity<V64> from(Scalar start) const {
      const D64 d;
      const V64 first = hn::Set(d, start);
      return {hn::Add(first, hn::Load(d, even_)), hn::Add(first, hn::Load(d, odd_))};
    }

   private:
    HWY_ALIGN uint64_t even_[kLanes / 2], odd_[kLanes / 2];
  };
  using Numerator = Walk;
  using Divisor = Walk;

  // A vector that is negative where n is,
  static HWY_INLINE V32 signs(const ByParity<V64>& n) { return upper_halves(n); }
  // or where n - k d is.
  static HWY_INLINE V32 signs(const ByParity<V64>& n, V32 k, const ByParity<V64>& divisor) {
    return upper_halves_of_difference(n, k, divisor);
  }
};

// low + 2^n high, of which the low part is n bits at first, and carries nothing.
struct LoosePair {
  uint64_t low, high;
  friend constexpr LoosePair operator+(const LoosePair& a, const LoosePair& b) {
    return {a.low + b.low, a.high + b.high};
  }
  friend HWY_INLINE LoosePair times(int64_t n, const LoosePair& a) {
    return {mapper::HWY_NAMESPACE::times(n, a.low), mapper::HWY_NAMESPACE::times(n, a.high)};
  }
};

// Modulo 2^80, of which a limb holds the upper 64 bits: divisors are multiples of 2^16, so that n -
// k d has the sign that it has without n's lower ones.
struct UpperLimb {
  static constexpr int kZeros = kTexelFraction, kBits = 64 + kZeros;

  class Divisor : public OneLimb::Walk {
   public:
    static HWY_INLINE uint64_t scalar(uint128 a) { return static_cast<uint64_t>(a >> kZeros); }
  };
  class Numerator {
   public:
    using Scalar = LoosePair;  // low + 2^16 high
    static HWY_INLINE Scalar scalar(uint128 a) {
      return {static_cast<uint64_t>(a) & ((uint64_t{1} << kZeros) - 1), Divisor::scalar(a)};
    }
    HWY_INLINE void set_step(const Scalar& step) {
      upper_.set_step(step.high);
      lower_.set_step(step.low);
    }
    // Walked left, the lower part is negative: with a bias it is not.
    [[nodiscard]] HWY_INLINE ByParity<V64> from(const Scalar& start) const {
      constexpr int kBiasBits = 62;
      const ByParity<V64> upper = upper_.from(start.high - (uint64_t{1} << (kBiasBits - kZeros)));
      const ByParity<V64> lower = lower_.from(start.low + (uint64_t{1} << kBiasBits));
      return {hn::Add(upper.even, hn::ShiftRight<kZeros>(lower.even)),
              hn::Add(upper.odd, hn::ShiftRight<kZeros>(lower.odd))};
    }

   private:
    OneLimb::Walk upper_, lower_;
  };

  static HWY_INLINE V32 signs(const ByParity<V64>& n, V32 k, const ByParity<V64>& divisor) {
    return OneLimb::signs(n, k, divisor);
  }
};

// low + 2^n high.
struct LowAndHigh {
  V64 low, high;
};
// The high limb and what the low one, which is not below 0, carries to it.
template <int kLowBits>
[[nodiscard]] HWY_INLINE V64 carried(const LowAndHigh& n) {
  return hn::Add(n.high, hn::ShiftRight<kLowBits>(n.low));
}

// Modulo 2^109: low + 2^45 high. Divisors are multiples of 2^15, so that 30 bits are left of a low
// limb, and factors below 3/4 2^17: one product by k 2^15 is the low limb's.
struct TwoLimbs {
  using Limbs = LowAndHigh;
  static constexpr int kLowBits = 45, kBits = kLowBits + 64;
  static constexpr int kDivisorZeros = 15, kFactorBits = 17;
  static_assert(kFactorBits + kDivisorZeros <= 32 && kLowBits + 1 - kDivisorZeros <= 32);

  // A number at kLanes pixels in turn: its low limb without so many bits, and with a bias.
  template <int kDropped, uint64_t kBias>
  class Walk {
   public:
    using Scalar = uint128;
    static HWY_INLINE Scalar scalar(uint128 a) { return a; }
    HWY_INLINE void set_step(uint128 step) {
      const ByParity<V64> low = multiples_of(low_of(step)), high = multiples_of(high_of(step));
      store({low.even, high.even}, even_low_, even_high_);
      store({low.odd, high.odd}, odd_low_, odd_high_);
    }
    [[nodiscard]] HWY_INLINE ByParity<Limbs> from(uint128 start) const {
      const D64 d;
      const V64 low = hn::Set(d, (low_of(start) >> kDropped) + kBias);
      const V64 high = hn::Set(d, high_of(start) - (kBias >> kLowBits));
      return {{hn::Add(low, hn::Load(d, even_low_)), hn::Add(high, hn::Load(d, even_high_))},
              {hn::Add(low, hn::Load(d, odd_low_)), hn::Add(high, hn::Load(d, odd_high_))}};
    }

   private:
    static constexpr uint64_t kLow = (uint64_t{1} << kLowBits) - 1;
    static HWY_INLINE uint64_t low_of(uint128 a) { return static_cast<uint64_t>(a) & kLow; }
    static HWY_INLINE uint64_t high_of(uint128 a) { return static_cast<uint64_t>(a >> kLowBits); }
    // The low limb's carry is still in it.
    static HWY_INLINE void store(const Limbs& by, uint64_t* HWY_RESTRICT to_low,
                                 uint64_t* HWY_RESTRICT to_high) {
      const D64 d;
      hn::Store(hn::ShiftRight<kDropped>(hn::And(by.low, hn::Set(d, kLow))), d, to_low);
      hn::Store(hn::Add(by.high, hn::ShiftRight<kLowBits>(by.low)), d, to_high);
    }

    HWY_ALIGN uint64_t even_low_[kLanes / 2], even_high_[kLanes / 2];
    HWY_ALIGN uint64_t odd_low_[kLanes / 2], odd_high_[kLanes / 2];
  };
  // A divisor's low limb is below 2^46, so that no difference of low limbs is below 0 with so much
  // more.
  using Numerator = Walk<0, uint64_t{1} << 63>;
  using Divisor = Walk<kDivisorZeros, 0>;

  static HWY_INLINE V32 signs(const ByParity<Limbs>& n, V32 k, const ByParity<Limbs>& divisor) {
    const ByParity<V64> by_low = words_of(hn::ShiftLeft<kDivisorZeros>(k));
    return upper_halves_of_difference({carried<kLowBits>(less(n.even, by_low.even, divisor.even)),
                                       carried<kLowBits>(less(n.odd, by_low.odd, divisor.odd))},
                                      k, {divisor.even.high, divisor.odd.high});
  }

 private:
  static HWY_INLINE Limbs less(const Limbs& n, V64 k_low, const Limbs& divisor) {
    return {hn::Sub(n.low, word_product(k_low, divisor.low)), n.high};
  }
};

// Modulo 2^109, for numbers alone: low limbs of 45 bits carry nothing before the end, so that a
// number may be a sum of others times factors whose magnitudes are below 2^17 together.
struct LooseLimbs {
  static constexpr int kLowBits = 45, kBits = kLowBits + 64;
  static constexpr int kFactorBits = 17;

  class Walk {
   public:
    using Scalar = LoosePair;  // low + 2^45 high
    static HWY_INLINE Scalar scalar(uint128 a) {
      return {static_cast<uint64_t>(a) & kLow, static_cast<uint64_t>(a >> kLowBits)};
    }
    // One number again, of two.
    static HWY_INLINE Scalar sum(const Scalar& a, const Scalar& b) {
      const Scalar loose = a + b;
      return {loose.low & kLow, loose.high + (loose.low >> kLowBits)};
    }
    HWY_INLINE void set_step(const Scalar& step) {
      low_.set_step(step.low);
      high_.set_step(step.high);
    }
    HWY_INLINE void add_step(const Walk& more) {
      low_.add_step(more.low_);
      high_.add_step(more.high_);
    }
    // Low limbs are not below 0 with so much more.
    [[nodiscard]] HWY_INLINE ByParity<LowAndHigh> from(const Scalar& start) const {
      constexpr uint64_t kMore = uint64_t{1} << 63;
      static_assert(kLowBits + kFactorBits < 63);
      const ByParity<V64> low = low_.from(start.low + kMore);
      const ByParity<V64> high = high_.from(start.high - (kMore >> kLowBits));
      return {{low.even, high.even}, {low.odd, high.odd}};
    }

   private:
    static constexpr uint64_t kLow = (uint64_t{1} << kLowBits) - 1;
    OneLimb::Walk low_, high_;
  };

  static HWY_INLINE V32 signs(const ByParity<LowAndHigh>& n) {
    return upper_halves({carried<kLowBits>(n.even), carried<kLowBits>(n.odd)});
  }
};

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
