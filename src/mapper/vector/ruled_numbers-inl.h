// The exact numbers of rows that each have a map of their own, for what decides near-ties. Included
// once for each SIMD target.
#if defined(SELVAGE_VECTOR_RULED_NUMBERS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_RULED_NUMBERS_INL_H
#undef SELVAGE_VECTOR_RULED_NUMBERS_INL_H
#else
#define SELVAGE_VECTOR_RULED_NUMBERS_INL_H
#endif

#include <type_traits>

#include "mapper/exact_slab.h"
#include "mapper/vector/limbs-inl.h"
#include "mapper/vector/row_walk-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

template <class Number>
using RuledWalk = RowWalk<typename Number::Numerator>;
template <class Number>
using RuledDivisorWalk = RowWalk<typename Number::Divisor>;

template <class Number>
HWY_INLINE void set_row(const ExactRow& row, RuledWalk<Number>* u, RuledWalk<Number>* v,
                        RuledDivisorWalk<Number>* d) {
  u->set(biased(row.u, row.d));
  v->set(biased(row.v, row.d));
  d->set(row.d);
}

template <class Number>
class RuledNumbers {
 public:
  explicit RuledNumbers(const RuledMap& map) : rows_(map) {}

  // From a span's first pixel on.
  HWY_INLINE void set(const Span& span, RuledWalk<Number>* u, RuledWalk<Number>* v,
                      RuledDivisorWalk<Number>* d) {
    set_row<Number>(rows_.row_from(span.left_px, span.row), u, v, d);
  }

 private:
  std::conditional_t<Number::kBits == OneLimb::kBits, ShortRuledRowFinder, RuledRowFinder> rows_;
};

// A number of a slab, as SlabLine has it: at a column and to the next pixel, and what these are
// more in the next row. What a LoosePair carries late is at any row what it would be by a formula
// from the slab's first one: below 2^16 (1 + n + n^2 / 2), n < 2^16.
template <class Scalar>
struct SlabScalars {
  Scalar start, down, bend, step, turn;

  template <class ScalarOf>
  static HWY_INLINE SlabScalars of(const ExactSlab::Line& line, const ScalarOf& scalar) {
    return {scalar(line.start), scalar(line.down), scalar(line.bend), scalar(line.step),
            scalar(line.turn)};
  }
  HWY_INLINE void go_down() {
    start = start + down;
    down = down + bend;
    step = step + turn;
  }
  // Or up, where rows are less than 0.
  HWY_INLINE void go_down(int64_t rows) {
    start = start + (times(rows, down) + times(rows * (rows - 1) / 2, bend));
    down = down + times(rows, bend);
    step = step + times(rows, turn);
  }
};

// Modulo 2^80 a row is two sums of 64 bits, a coordinate, from the one above it, where 128 bits
// take three products. Not where edges change sides, which changes signs that 80 bits may not tell.
template <>
class RuledNumbers<UpperLimb> {
 public:
  explicit RuledNumbers(const RuledMap& map) : map_(&map), any_(map) {}

  HWY_INLINE void set(const Span& span, RuledWalk<UpperLimb>* u, RuledWalk<UpperLimb>* v,
                      RuledDivisorWalk<UpperLimb>* d) {
    if (span.row < first_row_ || span.row >= end_row_) find(span);
    if (HWY_UNLIKELY(!is_directed_)) {
      return set_row<UpperLimb>(any_.row_from(span.left_px, span.row), u, v, d);
    }
    go_to(span.row);
    const int32_t right_px = span.left_px - first_px_;
    u->set(u_.start + times(right_px, u_.step), u_.step);
    v->set(v_.start + times(right_px, v_.step), v_.step);
    d->set(d_.start + times(right_px, d_.step), d_.step);
  }

 private:
  HWY_NOINLINE void find(const Span& span) {
    const Slab& slab = map_->slab_of(span.row);
    first_row_ = row_ = slab.first_row;
    end_row_ = slab.end_row;
    first_px_ = span.left_px;
    const auto directed = from_left_to_right(slab);
    is_directed_ = directed.has_value();
    if (!is_directed_) return;
    const ExactSlab rows(*directed, first_px_);
    u_ = biased(rows.u(), rows.d());
    v_ = biased(rows.v(), rows.d());
    d_ = SlabScalars<uint64_t>::of(rows.d(), UpperLimb::Divisor::scalar);
  }
  static HWY_INLINE SlabScalars<LoosePair> biased(ExactSlab::Line n, const ExactSlab::Line& d) {
    n.subtract(static_cast<uint128>(int128{-kTexelBias}), d);
    return SlabScalars<LoosePair>::of(n, UpperLimb::Numerator::scalar);
  }
  HWY_INLINE void go_to(int32_t row) {
    const int32_t rows = row - row_;
    row_ = row;
    if (HWY_LIKELY(rows == 1)) {
      u_.go_down();
      v_.go_down();
      d_.go_down();
    } else if (rows != 0) {
      u_.go_down(rows);
      v_.go_down(rows);
      d_.go_down(rows);
    }
  }

  const RuledMap* map_;
  RuledRowFinder any_;
  int32_t first_px_ = 0, first_row_ = 0, end_row_ = 0;
  bool is_directed_ = false;
  int32_t row_ = 0;  // that the numbers are of, from the column on
  SlabScalars<LoosePair> u_, v_;
  SlabScalars<uint64_t> d_;
};

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
