// Numbers of a slab at a pixel of each of kLanes rows: a lane is a row, a step goes to the right.
// Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_NUMBER_COLUMNS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_NUMBER_COLUMNS_INL_H
#undef SELVAGE_VECTOR_NUMBER_COLUMNS_INL_H
#else
#define SELVAGE_VECTOR_NUMBER_COLUMNS_INL_H
#endif

#include "mapper/exact_slab.h"
#include "mapper/vector/limbs-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// Half of kLanes rows, counted from a slab's: how many are above, how many pairs of them, and how
// far their pixels are right of its column, modulo 2^64.
struct SlabPixels {
  V64 rows, pairs, right;

  HWY_INLINE SlabPixels(V64 rows_above, V64 right_px)
      : rows(rows_above),
        pairs(hn::ShiftRight<1>(hn::Mul(rows, hn::Sub(rows, hn::Set(D64(), 1))))),
        right(right_px) {}

  // sum + factor by, modulo 2^64.
  static HWY_INLINE V64 plus(V64 sum, V64 factor, uint64_t by) {
    return hn::Add(sum, hn::Mul(factor, hn::Set(D64(), by)));
  }
  // A line's step in these rows, and its number at the column.
  HWY_INLINE V64 step(uint64_t first, uint64_t turn) const {
    return plus(hn::Set(D64(), first), rows, turn);
  }
  HWY_INLINE V64 at_column(uint64_t start, uint64_t down, uint64_t bend) const {
    return plus(plus(hn::Set(D64(), start), rows, down), pairs, bend);
  }
};

[[nodiscard]] HWY_INLINE ByParity<SlabPixels> slab_pixels(V32 right_px) {
  const D64 d;
  const hn::RebindToSigned<D64> wide;
  const V64 even_rows = hn::ShiftLeft<1>(hn::Iota(d, 0));
  const auto both = hn::BitCast(wide, right_px);
  return {{even_rows, hn::BitCast(d, hn::ShiftRight<32>(hn::ShiftLeft<32>(both)))},
          {hn::Add(even_rows, hn::Set(d, 1)), hn::BitCast(d, hn::ShiftRight<32>(both))}};
}

// Which of kLanes rows are so many or more below the first one.
using RowsBelow = ByParity<hn::Mask<D64>>;
[[nodiscard]] HWY_INLINE RowsBelow rows_below(int32_t rows) {
  const hn::RebindToSigned<D64> d;
  const auto even = hn::ShiftLeft<1>(hn::Iota(d, 0)), last = hn::Set(d, rows - 1);
  return {hn::RebindMask(D64(), hn::Gt(even, last)),
          hn::RebindMask(D64(), hn::Gt(hn::Add(even, hn::Set(d, 1)), last))};
}

// A column of numbers by halves of it.
template <class Half>
class ByHalves {
 public:
  template <class Line>
  HWY_INLINE ByHalves(const Line& line, const ByParity<SlabPixels>& first)
      : even_(line, first.even), odd_(line, first.odd) {}

  // In these rows those of the other one.
  HWY_INLINE void take(const RowsBelow& rows, const ByHalves& other) {
    even_.take(rows.even, other.even_);
    odd_.take(rows.odd, other.odd_);
  }

  [[nodiscard]] HWY_INLINE auto from(int32_t /*px*/) const {
    return ByParity<decltype(even_.get())>{even_.get(), odd_.get()};
  }
  HWY_INLINE void go_right() {
    even_.go_right();
    odd_.go_right();
  }

 private:
  Half even_, odd_;
};

// Modulo 2^64, as OneLimb has them.
struct OneLimbColumn {
  using Slab = DirectedSlab<uint64_t>;
  using Limbs = OneLimb;

  class Half {
   public:
    HWY_INLINE Half(const Slab::Line& line, const SlabPixels& px)
        : step_(px.step(line.step, line.turn)),
          at_(hn::Add(px.at_column(line.start, line.down, line.bend), hn::Mul(px.right, step_))) {}
    HWY_INLINE void take(hn::Mask<D64> rows, const Half& other) {
      step_ = hn::IfThenElse(rows, other.step_, step_);
      at_ = hn::IfThenElse(rows, other.at_, at_);
    }
    HWY_INLINE void go_right() { at_ = hn::Add(at_, step_); }
    [[nodiscard]] HWY_INLINE V64 get() const { return at_; }

   private:
    V64 step_, at_;
  };
  using Numerator = ByHalves<Half>;
  using Divisor = ByHalves<Half>;
};

// Modulo 2^109, as TwoLimbs has them. Low limbs carry nothing at first: products by factors of less
// than 2^17 together leave them room.
struct TwoLimbsColumn {
  using Slab = DirectedSlab<uint128>;
  using Limbs = TwoLimbs;

  class Half {
   public:
    HWY_INLINE Half(const Slab::Line& line, const SlabPixels& px)
        : step_(settled({px.step(low(line.step), low(line.turn)),
                         px.step(high(line.step), high(line.turn))})),
          at_(settled({at(low(line.start), low(line.down), low(line.bend), px, step_.low),
                       at(high(line.start), high(line.down), high(line.bend), px, step_.high)})) {}
    HWY_INLINE void go_right() {
      at_ = {hn::Add(at_.low, step_.low), hn::Add(at_.high, step_.high)};
    }

   protected:
    // Pixels right of a column, rows and pairs of them below it; and pixels that are gone through.
    static constexpr int32_t kMost_px = 1 << 15;
    static_assert(1 + kLanes + kLanes * kLanes / 2 + kMost_px < 1 << TwoLimbs::kFactorBits);
    static_assert(kMostLanes < 1 << TwoLimbs::kFactorBits);

    static HWY_INLINE V64 at(uint64_t start, uint64_t down, uint64_t bend, const SlabPixels& px,
                             V64 step) {
      return hn::Add(px.at_column(start, down, bend), hn::Mul(px.right, step));
    }
    static HWY_INLINE uint64_t low(uint128 a) {
      return static_cast<uint64_t>(a) & ((uint64_t{1} << TwoLimbs::kLowBits) - 1);
    }
    static HWY_INLINE uint64_t high(uint128 a) {
      return static_cast<uint64_t>(a >> TwoLimbs::kLowBits);
    }
    // What is beyond a low limb's bits is added to the high one: it may be below 0.
    static HWY_INLINE LowAndHigh settled(const LowAndHigh& n) {
      const hn::RebindToSigned<D64> wide;
      const V64 beyond =
          hn::BitCast(D64(), hn::ShiftRight<TwoLimbs::kLowBits>(hn::BitCast(wide, n.low)));
      const V64 mask = hn::Set(D64(), (uint64_t{1} << TwoLimbs::kLowBits) - 1);
      return {hn::And(n.low, mask), hn::Add(n.high, beyond)};
    }

    LowAndHigh step_, at_;
  };
  // With more, so that no difference of low limbs is below 0.
  struct NumeratorHalf : Half {
    HWY_INLINE NumeratorHalf(const Slab::Line& line, const SlabPixels& px) : Half(line, px) {}
    [[nodiscard]] HWY_INLINE LowAndHigh get() const {
      constexpr uint64_t kMore = uint64_t{1} << 63;
      return {hn::Add(at_.low, hn::Set(D64(), kMore)),
              hn::Sub(at_.high, hn::Set(D64(), kMore >> TwoLimbs::kLowBits))};
    }
  };
  // Without the zeros.
  struct DivisorHalf : Half {
    HWY_INLINE DivisorHalf(const Slab::Line& line, const SlabPixels& px) : Half(line, px) {}
    [[nodiscard]] HWY_INLINE LowAndHigh get() const {
      const LowAndHigh at = settled(at_);
      return {hn::ShiftRight<TwoLimbs::kDivisorZeros>(at.low), at.high};
    }
  };
  using Numerator = ByHalves<NumeratorHalf>;
  using Divisor = ByHalves<DivisorHalf>;
};

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
