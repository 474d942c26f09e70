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

// A number of a slab, biased, as SlabLine has it: at a column and to the next pixel, and what these
// are more in the next row.
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
    if (span.row == row_ + 1) {
      u_.go_down();
      v_.go_down();
      d_.go_down();
      row_ = span.row;
    } else if (span.row != row_) {
      go_to(span.row);
    }
    const int32_t right_px = span.left_px - first_px_;
    u->set(u_.start + times(right_px, u_.step), u_.step);
    v->set(v_.start + times(right_px, v_.step), v_.step);
    d->set(d_.start + times(right_px, d_.step), d_.step);
  }

 private:
  HWY_NOINLINE void find(const Span& span) {
    const Slab& slab = map_->slab_of(span.row);
    first_row_ = slab.first_row;
    end_row_ = slab.end_row;
    first_px_ = span.left_px;
    const auto directed = from_left_to_right(slab);
    is_directed_ = directed.has_value();
    if (!is_directed_) return;
    const ExactSlab rows(*directed, first_px_);
    lines_[0] = rows.u();
    lines_[1] = rows.v();
    lines_[2] = rows.d();
    constexpr auto kTimes = static_cast<uint128>(int128{-kTexelBias});
    lines_[0].subtract(kTimes, lines_[2]);
    lines_[1].subtract(kTimes, lines_[2]);
    go_to(span.row);
  }
  HWY_NOINLINE void go_to(int32_t row) {
    ExactSlab::Line u = lines_[0], v = lines_[1], d = lines_[2];
    for (ExactSlab::Line* const line : {&u, &v, &d}) line->go_down(row - first_row_);
    u_ = SlabScalars<LoosePair>::of(u, UpperLimb::Numerator::scalar);
    v_ = SlabScalars<LoosePair>::of(v, UpperLimb::Numerator::scalar);
    d_ = SlabScalars<uint64_t>::of(d, UpperLimb::Divisor::scalar);
    row_ = row;
  }

  const RuledMap* map_;
  RuledRowFinder any_;
  int32_t first_px_ = 0, first_row_ = 0, end_row_ = 0;
  bool is_directed_ = false;
  ExactSlab::Line lines_[3];  // u, v, d from the slab's first row on
  int32_t row_ = 0;           // that the scalars are of
  SlabScalars<LoosePair> u_, v_;
  SlabScalars<uint64_t> d_;
};

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
