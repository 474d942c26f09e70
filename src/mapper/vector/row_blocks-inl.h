// Rows of a batch, some at a time. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_ROW_BLOCKS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_ROW_BLOCKS_INL_H
#undef SELVAGE_VECTOR_ROW_BLOCKS_INL_H
#else
#define SELVAGE_VECTOR_ROW_BLOCKS_INL_H
#endif

#include <bit>

#include "mapper/vector/kernel-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// Whether rows have so few vectors that they are drawn some rows at a time.
inline constexpr int32_t kMostNarrow_px = HWY_MIN(64, 8 * kLanes);
[[nodiscard]] HWY_INLINE bool is_narrow(const SpanBatch& batch) {
  return batch.widest_px <= kMostNarrow_px;
}

// Some rows of a batch. They have few vectors, and where they end is seldom foreseen: they are
// drawn a strip at a time, a vector or two of every row, and no more rows at once than the cache
// has room for: lines of one set of it, a pitch apart, would throw each other out before the next
// strip.
struct RowBlock {
  int32_t first, end;
  int32_t widest_px;
};

// The widest of some rows of a batch.
[[nodiscard]] HWY_INLINE RowBlock block_of(const SpanBatch& batch, int32_t first, int32_t end) {
  const hn::CappedTag<int32_t, 8> d;
  constexpr int32_t kPart = static_cast<int32_t>(hn::MaxLanes(hn::CappedTag<int32_t, 8>()));
  auto widest = hn::Zero(d);
  for (int32_t i = first; i < end; i += kPart) {
    const auto width =
        hn::Sub(hn::LoadU(d, batch.right_px.data() + i), hn::LoadU(d, batch.left_px.data() + i));
    const auto is_row = hn::Lt(hn::Iota(d, i), hn::Set(d, end));
    widest = hn::Max(widest, hn::IfThenElseZero(is_row, width));
  }
  return {first, end, hn::GetLane(hn::MaxOfLanes(d, widest))};
}

// A block costs something by itself.
inline constexpr int32_t kLeastBlockRows = 16;

// As many rows as the cache has room for, a multiple of the least. Its sets are told by addresses
// modulo 4096 bytes or more, and hold 8 lines or more: 32 KB are the least of today.
[[nodiscard]] HWY_INLINE int32_t rows_per_block(ptrdiff_t pitch_bytes) {
  constexpr uint64_t kSets_bytes = 4096;
  constexpr int32_t kWays = 8;
  const int apart_bits = std::countr_zero(static_cast<uint64_t>(pitch_bytes) | kSets_bytes);
  const auto rows_apart = static_cast<int32_t>(kSets_bytes >> apart_bits);
  return HWY_MIN(HWY_MAX(kWays * rows_apart, kLeastBlockRows), kRowsPerBatch);
}

// All rows are one block where they are one strip. Ends where draw(block) returns false.
template <class Draw>
HWY_INLINE void for_each_block(const SpanBatch& batch, int32_t strip_px, int32_t most_rows,
                               const Draw& draw) {
  const bool is_one = batch.widest_px <= strip_px || batch.rows <= most_rows;
  const int32_t rows = is_one ? batch.rows : most_rows;
  for (int32_t first = 0; first < batch.rows; first += rows) {
    const RowBlock block = is_one ? RowBlock{0, batch.rows, batch.widest_px}
                                  : block_of(batch, first, HWY_MIN(first + rows, batch.rows));
    if (!draw(block)) return;
  }
}

// Of kLanes rows, what is drawn of them in a strip: the pixel where it begins, and how many there
// are from there to the span's end. It begins where the strip does, so many pixels right of the
// span's left end, or, where fewer than the strip's width are left, further left, so that it is
// whole or all of the span: some pixels are drawn twice, the same.
struct StripEnds {
  V32 from_px, count_px;
};
template <int32_t kStrip_px>
[[nodiscard]] HWY_INLINE StripEnds strip_ends(const SpanBatch& batch, int32_t row,
                                              int32_t right_by_px) {
  const D32 d;
  const V32 left = hn::LoadU(d, batch.left_px.data() + row);
  const V32 right = hn::LoadU(d, batch.right_px.data() + row);
  const V32 last = hn::Max(left, hn::Sub(right, hn::Set(d, kStrip_px)));
  const V32 from = hn::Min(hn::Add(left, hn::Set(d, right_by_px)), last);
  return {from, hn::Sub(right, from)};
}

// From the first row of a block that is asked for to the last one: asked(row) tells of kLanes rows
// from one on. No rows where none is.
template <class Asked>
[[nodiscard]] HWY_INLINE RowBlock rows_where(const RowBlock& block, const Asked& asked) {
  static_assert(kLeastBlockRows % kLanes == 0 && kRowsPerBatch % kLanes == 0);
  uint64_t rows = 0;
  for (int32_t row = block.first & -kLanes; row < block.end; row += kLanes) {
    rows |= bits_of(asked(row)) << row;
  }
  rows &= ~uint64_t{0} >> (kRowsPerBatch - block.end) & ~uint64_t{0} << block.first;
  return {std::countr_zero(rows), kRowsPerBatch - std::countl_zero(rows), block.widest_px};
}

// Those that have pixels so far right of their left ends, and maybe some between that have none
// there.
[[nodiscard]] HWY_INLINE RowBlock rows_with(const SpanBatch& batch, const RowBlock& block,
                                            int32_t right_by_px) {
  const D32 d;
  return rows_where(
      block, [&](int32_t row) HWY_ATTR __attribute__((always_inline)) {
        const V32 begin =
            hn::Add(hn::LoadU(d, batch.left_px.data() + row), hn::Set(d, right_by_px));
        return hn::Lt(begin, hn::LoadU(d, batch.right_px.data() + row));
      });
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
