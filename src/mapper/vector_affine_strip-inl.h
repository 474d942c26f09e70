// The vectors of narrow affine spans, what they need found some rows at once. Included once for
// each SIMD target.
#if defined(SELVAGE_VECTOR_AFFINE_STRIP_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_AFFINE_STRIP_INL_H
#undef SELVAGE_VECTOR_AFFINE_STRIP_INL_H
#else
#define SELVAGE_VECTOR_AFFINE_STRIP_INL_H
#endif

#include <bit>

#include "mapper/vector_affine_lanes-inl.h"
#include "mapper/vector_one_window-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// Modulo 2^64.
[[nodiscard]] HWY_INLINE Lane plus(Lane lane, int32_t steps, Lane step) {
  const auto sum = [steps](int64_t from, int64_t by) {
    return static_cast<int64_t>(static_cast<uint64_t>(from) +
                                static_cast<uint64_t>(steps) * static_cast<uint64_t>(by));
  };
  return {sum(lane.u_fx32, step.u_fx32), sum(lane.v_fx32, step.v_fx32)};
}

// Rows that are asked for at once, as many as there are 64-bit lanes.
using RowTag32 = hn::Half<D32>;
using RowTag64 = hn::Repartition<int64_t, D32>;
inline constexpr int32_t kStripRows = kLanes / 2;

// One coordinate of the anchors, modulo 2^64, of kStripRows rows: of the vectors that begin at
// these pixels of them.
class RowAnchors {
 public:
  using Lanes = hn::Vec<RowTag64>;

  // `first_fx32`: that of the first row's vector that begins at pixel 0.
  HWY_INLINE RowAnchors(int64_t first_fx32, int64_t step_x_fx32, int64_t step_y_fx32)
      : step_x_(hn::Set(RowTag64(), step_x_fx32)),
        down_(hn::ShiftLeft<kStripRowBits>(hn::Set(RowTag64(), step_y_fx32))),
        rows_(hn::Add(hn::Set(RowTag64(), first_fx32),
                      hn::Mul(hn::Iota(RowTag64(), 0), hn::Set(RowTag64(), step_y_fx32)))) {}

  HWY_INLINE Lanes at(hn::Vec<RowTag64> px) const { return hn::Add(rows_, hn::Mul(px, step_x_)); }
  HWY_INLINE void go_down() { rows_ = hn::Add(rows_, down_); }

 private:
  static constexpr int kStripRowBits = kLanes == 16 ? 3 : kLanes == 8 ? 2 : 1;
  static_assert(1 << kStripRowBits == kStripRows);

  Lanes step_x_, down_, rows_;
};

[[nodiscard]] HWY_INLINE hn::Vec<RowTag32> floors_fx16(RowAnchors::Lanes anchors_fx32) {
  const hn::RebindToUnsigned<RowTag64> from;
  const hn::RebindToUnsigned<RowTag32> to;
  const auto shifted = hn::ShiftRight<kAnchorShift>(hn::BitCast(from, anchors_fx32));
  return hn::BitCast(RowTag32(), hn::TruncateTo(to, shifted));
}

// A strip of a block: of each of its rows, the vector that begins so many pixels right of the
// span's left end; its anchor, and how many pixels the row has from there on, maybe less than none.
struct StripVectors {
  HWY_ALIGN int32_t u_fx16[kRowsPerBatch], v_fx16[kRowsPerBatch], count_px[kRowsPerBatch];

  // The anchors are those of the block's first row.
  HWY_INLINE StripVectors(const SpanBatch& batch, const RowBlock& block, int32_t right_by_px,
                          RowAnchors u, RowAnchors v) {
    const RowTag32 d;
    const auto right_by = hn::Set(d, right_by_px);
    for (int32_t row = block.first; row < block.end; row += kStripRows) {
      const auto from_px = hn::Add(hn::LoadU(d, batch.left_px.data() + row), right_by);
      const auto end_px = hn::LoadU(d, batch.right_px.data() + row);
      const auto wide_px = hn::PromoteTo(RowTag64(), from_px);
      hn::Store(floors_fx16(u.at(wide_px)), d, u_fx16 + row);
      hn::Store(floors_fx16(v.at(wide_px)), d, v_fx16 + row);
      hn::Store(hn::Sub(end_px, from_px), d, count_px + row);
      u.go_down();
      v.go_down();
    }
  }

  // Those of the rows of a block that have pixels, and maybe some between that have none.
  [[nodiscard]] HWY_INLINE RowBlock with_pixels(const RowBlock& block) const {
    static_assert(kLeastBlockRows % kLanes == 0 && kRowsPerBatch % kLanes == 0);
    uint64_t rows = 0;
    for (int32_t row = block.first; row < block.end; row += kLanes) {
      const V32 count = hn::LoadU(D32(), count_px + row);
      rows |= bits_of(hn::Gt(count, hn::Zero(D32()))) << row;
    }
    rows &= ~uint64_t{0} >> (kRowsPerBatch - block.end);
    return {std::countr_zero(rows), kRowsPerBatch - std::countl_zero(rows), block.widest_px};
  }
};

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
