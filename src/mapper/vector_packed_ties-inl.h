// Near-ties among the pixels of many short rows. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_PACKED_TIES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_PACKED_TIES_INL_H
#undef SELVAGE_VECTOR_PACKED_TIES_INL_H
#else
#define SELVAGE_VECTOR_PACKED_TIES_INL_H
#endif

#include "mapper/vector_near_ties-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// Of the rows of a batch from `first_row` on, packed one after another.
class PackedTies {
 public:
  HWY_INLINE PackedTies(const SpanBatch& rows, const ExactMap& exact, int32_t first_row,
                        int spare_bits)
      : rows_(rows), ties_(exact, rows.span(first_row), 0, spare_bits), row_(first_row) {}

  // As RowOfTies does, for packed pixels from a number on that never falls.
  HWY_INLINE void decide(int32_t first, const NearTies& near, V32* HWY_RESTRICT s,
                         V32* HWY_RESTRICT t) {
    const D32 d;
    const V32 low_s = *s, low_t = *t, lane = hn::Iota(d, 0);
    while (end() <= first && next_row()) continue;
    do {
      V32 row_s = low_s, row_t = low_t;
      ties_.decide(first - first_of_row_, near, &row_s, &row_t);
      const auto is_left = hn::Lt(lane, hn::Set(d, first_of_row_ - first));
      *s = hn::IfThenElse(is_left, *s, row_s);
      *t = hn::IfThenElse(is_left, *t, row_t);
    } while (end() < first + kLanes && next_row());
  }

 private:
  HWY_INLINE int32_t end() const { return first_of_row_ + rows_.span(row_).width_px(); }
  HWY_INLINE bool next_row() {
    if (row_ + 1 == rows_.rows) return false;
    first_of_row_ = end();
    ties_.go_to(rows_.span(++row_));
    return true;
  }

  const SpanBatch& rows_;
  RowOfTies ties_;
  int32_t row_, first_of_row_ = 0;
};

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
