// Pieces: a batch of spans cut into runs of a vector of pixels or some. Included once for each SIMD
// target.
#if defined(SELVAGE_VECTOR_PIECE_WALK_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_PIECE_WALK_INL_H
#undef SELVAGE_VECTOR_PIECE_WALK_INL_H
#else
#define SELVAGE_VECTOR_PIECE_WALK_INL_H
#endif

#include "mapper/span_batch.h"
#include "mapper/vector/row_blocks-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// So many at once that finding their anchors, which takes long but not much, is done side by side.
inline constexpr int32_t kMostPieces = kLanes == kMostLanes ? 32 : 16;
static_assert(kMostPieces % kLanes == 0);

// Pixels of a row, kMostLanes of them, or the last ones of a span.
inline constexpr int32_t kPiece_px = kMostLanes;
inline constexpr int32_t kVectorsPerPiece = kPiece_px / kLanes;
struct Pieces {
  int32_t count;  // beyond it, values mean nothing
  int32_t row[2 * kMostPieces], left_px[2 * kMostPieces];
  int32_t width_px[2 * kMostPieces];  // from there to the end of the span

  // Rows of a batch are pieces, of the strip that is so many pixels right of their left ends. Some
  // may be empty.
  HWY_INLINE void put_rows(const SpanBatch& batch, const RowBlock& rows, int32_t right_by_px) {
    count = rows.end - rows.first;
    const D32 d;
    for (int32_t k = 0; k < count; k += kLanes) {
      const StripEnds ends = strip_ends<kPiece_px>(batch, rows.first + k, right_by_px);
      hn::StoreU(hn::Iota(d, batch.first_row + rows.first + k), d, row + k);
      hn::StoreU(ends.from_px, d, left_px + k);
      hn::StoreU(ends.count_px, d, width_px + k);
    }
  }

  // The first pieces of a span, up to kMostPieces of them in all. Returns what is left of it.
  HWY_INLINE Span add(const Span& span) {
    const D32 d;
    const int32_t pieces =
        HWY_MIN((span.width_px() + kPiece_px - 1) / kPiece_px, kMostPieces - count);
    for (int32_t k = 0; k < pieces; k += kLanes) {
      const V32 first_px = hn::Mul(hn::Iota(d, k), hn::Set(d, kPiece_px));
      hn::StoreU(hn::Set(d, span.row), d, row + count + k);
      hn::StoreU(hn::Add(first_px, hn::Set(d, span.left_px)), d, left_px + count + k);
      hn::StoreU(hn::Sub(hn::Set(d, span.width_px()), first_px), d, width_px + count + k);
    }
    count += pieces;
    return {span.row, span.left_px + pieces * kPiece_px, span.right_px};
  }

  // From one of its vectors on.
  [[nodiscard]] HWY_INLINE Span rest(int32_t k, int32_t vector) const {
    return {row[k], left_px[k] + vector * kLanes, left_px[k] + width_px[k]};
  }
};

// The pieces of a batch's spans, some at a time: span by span or, of narrow ones, strip by strip of
// some rows, which takes less.
enum class PieceOrder { kAny, kSpanBySpan };
class PieceWalk {
 public:
  HWY_INLINE PieceWalk(const SpanBatch& batch, PieceOrder order)
      : batch_(&batch),
        by_strips_(batch.widest_px <= kPiece_px ||
                   (order == PieceOrder::kAny && is_narrow(batch))) {}

  // None where none is left. Some may be empty.
  HWY_INLINE void next(Pieces* pieces) {
    if (by_strips_) {
      next_strip(pieces);
    } else {
      next_parts(pieces);
    }
  }

 private:
  HWY_INLINE void next_strip(Pieces* pieces) {
    right_by_px_ += kPiece_px;
    if (right_by_px_ >= block_.widest_px) {
      right_by_px_ = 0;
      block_ = block_of(*batch_, next_, HWY_MIN(next_ + kMostPieces, batch_->rows));
      next_ = block_.end;
    }
    const bool is_first = right_by_px_ == 0;
    pieces->put_rows(*batch_, is_first ? block_ : rows_with(*batch_, block_, right_by_px_),
                     right_by_px_);
  }

  HWY_INLINE void next_parts(Pieces* pieces) {
    pieces->count = 0;
    while (pieces->count < kMostPieces) {
      if (span_.left_px >= span_.right_px) {
        if (next_ == batch_->rows) break;
        span_ = batch_->span(next_++);
      }
      span_ = pieces->add(span_);
    }
  }

  const SpanBatch* batch_;
  bool by_strips_;
  int32_t next_ = 0;
  Span span_{0, 0, 0};
  RowBlock block_{0, 0, 0};
  int32_t right_by_px_ = 0;
};

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
