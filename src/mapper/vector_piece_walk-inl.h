// Pieces: a batch of spans cut into runs of a vector of pixels or some. Included once for each SIMD
// target.
#if defined(SELVAGE_VECTOR_PIECE_WALK_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_PIECE_WALK_INL_H
#undef SELVAGE_VECTOR_PIECE_WALK_INL_H
#else
#define SELVAGE_VECTOR_PIECE_WALK_INL_H
#endif

#include "mapper/span_batch.h"
#include "mapper/vector_kernel-inl.h"

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
  int32_t right_px[2 * kMostPieces];  // the end of the span
  int64_t to_byte[2 * kMostPieces];   // of the target: set by PieceWalk alone

  // Rows of a batch are pieces, from so many pixels right of their first ones on. Some may be
  // empty.
  HWY_INLINE void put_rows(const SpanBatch& batch, int32_t first, int32_t rows,
                           int32_t right_by_px) {
    count = rows;
    const D32 d;
    for (int32_t k = 0; k < rows; k += kLanes) {
      const V32 left = hn::LoadU(d, batch.left_px.data() + first + k);
      hn::StoreU(hn::Iota(d, batch.first_row + first + k), d, row + k);
      hn::StoreU(hn::Add(left, hn::Set(d, right_by_px)), d, left_px + k);
      hn::StoreU(hn::LoadU(d, batch.right_px.data() + first + k), d, right_px + k);
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
      hn::StoreU(hn::Set(d, span.right_px), d, right_px + count + k);
    }
    count += pieces;
    return {span.row, span.left_px + pieces * kPiece_px, span.right_px};
  }

  // From one of its vectors on.
  [[nodiscard]] HWY_INLINE Span rest(int32_t k, int32_t vector) const {
    return {row[k], left_px[k] + vector * kLanes, right_px[k]};
  }
};

// The pieces of a batch's spans, some at a time.
class PieceWalk {
 public:
  HWY_INLINE PieceWalk(const SpanBatch& batch, const selvage_image& target)
      : batch_(&batch), pitch_(target.pitch), pixel_bytes_(bytes_per_pixel(target.format)) {
    for (int32_t k = 0; k < kMostPieces; ++k) bytes_[k] = k * kPiece_px * pixel_bytes_;
  }

  // None where none is left. Some may be empty.
  HWY_INLINE void next(Pieces* pieces) {
    if (batch_->widest_px <= kPiece_px) {
      next_rows(pieces);
    } else {
      next_parts(pieces);
    }
  }

 private:
  // Each row is a piece.
  HWY_INLINE void next_rows(Pieces* pieces) {
    const int32_t rows = HWY_MIN(batch_->rows - next_, kMostPieces);
    pieces->put_rows(*batch_, next_, rows, 0);
    for (int32_t k = 0; k < rows; ++k) {
      pieces->to_byte[k] = first_byte({pieces->row[k], pieces->left_px[k], 0});
    }
    next_ += rows;
  }

  HWY_INLINE void next_parts(Pieces* pieces) {
    pieces->count = 0;
    while (pieces->count < kMostPieces) {
      if (span_.left_px >= span_.right_px) {
        if (next_ == batch_->rows) break;
        span_ = batch_->span(next_++);
      }
      const hn::Repartition<int64_t, D32> d;
      const auto first = hn::Set(d, first_byte(span_));
      int64_t* const to_byte = pieces->to_byte + pieces->count;
      span_ = pieces->add(span_);
      const int64_t* const end = pieces->to_byte + pieces->count;
      for (int32_t k = 0; to_byte + k < end; k += kLanes / 2) {
        hn::StoreU(hn::Add(first, hn::LoadU(d, bytes_ + k)), d, to_byte + k);
      }
    }
  }

  [[nodiscard]] HWY_INLINE int64_t first_byte(const Span& span) const {
    return span.row * pitch_ + span.left_px * pixel_bytes_;
  }

  const SpanBatch* batch_;
  int64_t pitch_, pixel_bytes_;
  int64_t bytes_[kMostPieces];  // from a span's first piece on
  int32_t next_ = 0;
  Span span_{0, 0, 0};
};

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
