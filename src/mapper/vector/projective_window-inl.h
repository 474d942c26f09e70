// Projective spans of a polygon whose texels lie in one window. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_PROJECTIVE_WINDOW_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_PROJECTIVE_WINDOW_INL_H
#undef SELVAGE_VECTOR_PROJECTIVE_WINDOW_INL_H
#else
#define SELVAGE_VECTOR_PROJECTIVE_WINDOW_INL_H
#endif

#include "mapper/vector/one_window-inl.h"
#include "mapper/vector/projective_anchors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// A strip of a block: of its rows, a piece each, from so many pixels right of their first ones on,
// maybe of no pixels. Returns what the lanes of pixels lack changes in them.
template <class Pixel, class Low, class OneWindow>
[[nodiscard]] HWY_INLINE V32 draw_strip(const OneWindow& window, const Low& low,
                                        const AnchoredVectors& vectors, const SpanBatch& batch,
                                        const selvage_image& target, const RowBlock& block,
                                        int32_t right_by_px) {
  char* const pixels = static_cast<char*>(target.pixels);
  // Modulo 2^64: a pitch below the last row there may be no address.
  const auto pitch = static_cast<size_t>(target.pitch);
  size_t row = static_cast<size_t>(batch.first_row + block.first) * pitch;
  V32 changed = hn::Zero(D32());
  const PieceLanes lanes_of;
  Pieces pieces;
  Anchors anchors;
  for (int32_t first = block.first; first < block.end; first += kMostPieces) {
    pieces.put_rows(batch, {first, HWY_MIN(block.end, first + kMostPieces), block.widest_px},
                    right_by_px);
    for (int32_t k = 0; k < pieces.count; k += kDoubles) {
      vectors.find(pieces, k, window.origin(), &anchors);
    }
    for (int32_t k = 0; k < pieces.count; ++k) {
      int32_t count_px = pieces.width_px[k];
      Pixel* to =
          reinterpret_cast<Pixel*>(pixels + static_cast<ptrdiff_t>(row)) + pieces.left_px[k];
      for (int32_t at = 0; at < kVectorsPerPiece && (at == 0 || count_px > 0); ++at) {
        const LaneVectors lanes = lanes_of.lanes(anchors, k, at);
        changed = draw_first(window, low, lanes, count_px, changed, to);
        count_px -= kLanes;
        to += kLanes;
      }
      row += pitch;
    }
  }
  return changed;
}

// Draws a batch from one window.
template <class Pixel>
struct ProjectiveFromWindow {
  static constexpr bool kTwoSizes = false;

  const ProjectiveSpans& spans;
  const Surface& surface;
  const AnchoredVectors& vectors;
  V32* changed_by_near;

  // In vain from the first near-ties on.
  template <class OneWindow>
  [[nodiscard]] HWY_INLINE bool operator()(const OneWindow& window) const {
    const LowLanes low(vectors.lack_fx16());
    V32 changed = hn::Zero(D32());
    const auto draw_block = [&](const RowBlock& block) HWY_ATTR {
      for (int32_t px = 0; px < block.widest_px; px += kPiece_px) {
        const RowBlock rows = px == 0 ? block : rows_with(spans.batch, block, px);
        changed = hn::Or(changed, draw_strip<Pixel>(window, low, vectors, spans.batch,
                                                    surface.target, rows, px));
      }
      return !changes_texels<kTexelFraction>(changed);
    };
    // few rows at once, for behind a near-tie all were drawn in vain
    for_each_block(spans.batch, kPiece_px, kLeastBlockRows, draw_block);
    *changed_by_near = changed;
    return true;
  }
};

// Draws a batch, if one window holds its texels and no pixel is a near-tie.
template <class Pixel, class Address>
[[nodiscard]] HWY_INLINE InOneWindow draw_one_window(const ProjectiveSpans& spans,
                                                     const Surface& surface,
                                                     const AnchoredVectors& vectors) {
  if (!pays_one_window(spans.batch)) return InOneWindow::kNotInOne;
  V32 changed;
  if (!with_one_window<Pixel, Address>(
          spans.texels, surface.texture,
          ProjectiveFromWindow<Pixel>{spans, surface, vectors, &changed})) {
    return InOneWindow::kNotInOne;
  }
  return in_one_window<kTexelFraction>(changed, spans.batch.widest_px);
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
