// Blocks of pieces, made ready ahead of being drawn. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_PIECE_QUEUE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_PIECE_QUEUE_INL_H
#undef SELVAGE_VECTOR_PIECE_QUEUE_INL_H
#else
#define SELVAGE_VECTOR_PIECE_QUEUE_INL_H
#endif

#include "mapper/vector/piece_windows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// Blocks of pieces on their way. What one is drawn by takes long to find, step by step: while one
// block is drawn, the windows of the next, the anchors of the one after, and the places of the last
// are found side by side.
struct PieceBlock {
  Pieces pieces;
  Anchors anchors;
  PieceWindows windows;
};

class PieceQueue {
 public:
  HWY_INLINE PieceQueue(const SpanBatch& batch, PieceOrder order, const AnchoredVectors& vectors)
      : walk_(batch, order), vectors_(vectors) {
    find_pieces(0);
    find_anchors(0);
    find_pieces(1);
    find_anchors(1);
    find_pieces(2);
  }

  // The next block; without pieces where none is left.
  template <class Address>
  HWY_INLINE const PieceBlock& next(const Extent& extent, bool has_windows) {
    if (has_windows) {
      if (at_ == 0) find_windows_of<Address>(extent, 0);
      find_windows_of<Address>(extent, at_ + 1);
    }
    find_anchors(at_ + 2);
    find_pieces(at_ + 3);
    return blocks_[at_++ % kBlocks];
  }

 private:
  static constexpr uint32_t kBlocks = 4;

  HWY_INLINE void find_pieces(uint32_t at) { walk_.next(&blocks_[at % kBlocks].pieces); }
  // Not in line, for what draws is compiled for each kind of pixel, address mode and way to fetch.
  HWY_NOINLINE void find_anchors(uint32_t at) {
    PieceBlock& block = blocks_[at % kBlocks];
    for (int32_t k = 0; k < block.pieces.count; k += kLanes) {
      vectors_.find_lanes(block.pieces, k, &block.anchors);
    }
  }
  template <class Address>
  HWY_INLINE void find_windows_of(const Extent& extent, uint32_t at) {
    PieceBlock& block = blocks_[at % kBlocks];
    const int32_t lack_fx16 = vectors_.lack_fx16();
    for (int32_t k = 0; k < block.pieces.count; k += kLanes) {
      find_windows<Address, 0>(block.pieces, k, block.anchors, extent, lack_fx16, &block.windows);
      if constexpr (kVectorsPerPiece > 1) {
        find_windows<Address, 1>(block.pieces, k, block.anchors, extent, lack_fx16, &block.windows);
      }
    }
  }

  PieceWalk walk_;
  const AnchoredVectors& vectors_;
  uint32_t at_ = 0;
  PieceBlock blocks_[kBlocks];
};

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
