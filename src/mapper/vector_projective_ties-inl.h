// Projective spans of a polygon whose texels lie in one window, with many near-ties among them.
// Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_PROJECTIVE_TIES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_PROJECTIVE_TIES_INL_H
#undef SELVAGE_VECTOR_PROJECTIVE_TIES_INL_H
#else
#define SELVAGE_VECTOR_PROJECTIVE_TIES_INL_H
#endif

#include "mapper/vector_one_window-inl.h"
#include "mapper/vector_plane_ties-inl.h"
#include "mapper/vector_projective_anchors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// Vectors of texels that `ties` decides, by permutes of the window.
template <class Pixel, int kColumnBits>
class DecidedDraw {
 public:
  HWY_INLINE DecidedDraw(const AnchoredVectors& vectors, const Surface& surface,
                         const WindowPlace& place, PlaneTies* ties)
      : lanes_(vectors.lanes()),
        fixed_(surface.texture, vectors.lack_fx16()),
        pitch_texel_(pitch_texel_of(surface.texture)),
        window_(static_cast<const Pixel*>(surface.texture.texels) + place.t.index * pitch_texel_ +
                place.s.index),
        rows_(place.vectors * kRowsPerVector<kColumnBits>),
        place_(place),
        ties_(ties) {}

  HWY_INLINE void draw(const Pieces& pieces, const Anchors& anchors, int32_t k, Pixel* to) const {
    const D32 d;
    const Span piece = pieces.rest(k, 0);
    if (piece.row != ties_->span().row) ties_->go_to(piece);
    int32_t px = piece.left_px - ties_->span().left_px, count_px = piece.width_px();
    for (int32_t at = 0; at < kVectorsPerPiece && count_px > 0; ++at) {
      const TexelVectors texels = fixed_.decided(*ties_, px, lanes_.lanes(anchors, k, at));
      const V32 column = hn::Sub(texels.s, hn::Set(d, place_.s.texel));
      const V32 row = hn::Sub(texels.t, hn::Set(d, place_.t.texel));
      const V32 index = hn::Add(hn::ShiftLeft<kColumnBits>(row), column);
      store_pixels(pick<kColumnBits>(window_, pitch_texel_, rows_, index), count_px, to);
      px += kLanes;
      count_px -= kLanes;
      to += kLanes;
    }
  }

 private:
  PieceLanes lanes_;
  FixedLanes<Addressed<InsideVector>> fixed_;
  ptrdiff_t pitch_texel_;
  const Pixel* window_;
  int32_t rows_;
  WindowPlace place_;
  PlaneTies* ties_;
};

template <class Pixel, int kColumnBits>
HWY_NOINLINE void draw_decided(const ProjectiveSpans& spans, const Surface& surface,
                               const AnchoredVectors& vectors, const WindowPlace& place,
                               PlaneTies* ties) {
  const DecidedDraw<Pixel, kColumnBits> by(vectors, surface, place, ties);
  char* const pixels = static_cast<char*>(surface.target.pixels);
  PieceWalk walk(spans.batch, surface.target);
  Pieces pieces;
  Anchors anchors;
  for (walk.next(&pieces); pieces.count != 0; walk.next(&pieces)) {
    for (int32_t k = 0; k < pieces.count; k += kLanes) vectors.find_lanes(pieces, k, &anchors);
    for (int32_t k = 0; k < pieces.count; ++k) {
      by.draw(pieces, anchors, k, reinterpret_cast<Pixel*>(pixels + pieces.to_byte[k]));
    }
  }
}

// Draws a batch that was drawn from one window in vain, if that lies within the texture and 64 bits
// tell the near-ties.
template <class Pixel>
[[nodiscard]] HWY_INLINE bool draw_near_ties(const ProjectiveSpans& spans, const Surface& surface,
                                             const AnchoredVectors& vectors) {
  const TexelRanges texels(spans.texels);
  if (!texels.within(surface.texture)) return false;
  PlaneTies ties(spans.exact, spans.batch);
  if (!ties.are_enough(spare_bits_fx16(vectors.lack_fx16()))) return false;
  const auto half = place_inside<kHalfColumnBits>(texels, surface.texture);
  if (half.vectors != 0) {
    draw_decided<Pixel, kHalfColumnBits>(spans, surface, vectors, half, &ties);
  } else {
    const auto whole = place_inside<kWindowColumnBits>(texels, surface.texture);
    draw_decided<Pixel, kWindowColumnBits>(spans, surface, vectors, whole, &ties);
  }
  return true;
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
