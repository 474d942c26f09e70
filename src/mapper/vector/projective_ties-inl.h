// Projective spans of a polygon whose texels lie in one window, with many near-ties among them.
// Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_PROJECTIVE_TIES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_PROJECTIVE_TIES_INL_H
#undef SELVAGE_VECTOR_PROJECTIVE_TIES_INL_H
#else
#define SELVAGE_VECTOR_PROJECTIVE_TIES_INL_H
#endif

#include <optional>

#include "mapper/vector/batch_ties-inl.h"
#include "mapper/vector/boundaries-inl.h"
#include "mapper/vector/fetch-inl.h"
#include "mapper/vector/left-inl.h"
#include "mapper/vector/projective_anchors-inl.h"
#include "mapper/vector/projective_columns-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// What decides near-ties of a batch, be it of one map or of a slab.
class ProjectiveTies {
 public:
  HWY_INLINE ProjectiveTies(const ProjectiveSpans& spans, const AnchoredVectors& vectors)
      : spans_(spans),
        spare_bits_(spare_bits_fx16(vectors.lack_fx16())),
        of_one_map_(spans.exact, spans.batch, spare_bits_) {}

  // Calls decide(ties) with PlaneTies, or with RuledTies.
  template <class Decide>
  HWY_INLINE void with_ties(const Decide& decide) {
    if (!spans_.exact.is_ruled()) return of_one_map_.with_ties(decide);
    if (!ruled_) {
      ruled_.emplace(spans_.exact.ruled(), spans_.field.most_denominator, spare_bits_);
    }
    ruled_->with_ties(decide);
  }

 private:
  const ProjectiveSpans& spans_;
  int spare_bits_;
  PlaneBatchTies of_one_map_;
  std::optional<RuledBatchTies> ruled_;
};

static_assert(kMostPieces * kVectorsPerPiece <= Left::kMost);

// The texels of all vectors of some pieces.
template <class Ties>
HWY_NOINLINE void decide_pieces(const Pieces& pieces, const PieceLanes& lanes,
                                const Anchors& anchors, const LowLanes& low, Ties* ties,
                                DecidedTexels* texels) {
  for (int32_t k = 0; k < pieces.count; ++k) {
    const Span piece = pieces.rest(k, 0);
    if (piece.empty()) continue;
    if (piece.row != ties->span().row) ties->go_to(piece);
    const int32_t offset_px = piece.left_px - ties->span().left_px;
    for (int32_t at = 0; at < kVectorsPerPiece; ++at) {
      if (at * kLanes >= piece.width_px()) break;
      texels->put(k * kVectorsPerPiece + at,
                  low.decided(*ties, offset_px + at * kLanes, lanes.lanes(anchors, k, at)));
    }
  }
}

template <class Pixel, class Address>
HWY_NOINLINE void draw_decided(const Pieces& pieces, const DecidedTexels& texels,
                               const Surface& surface) {
  const TexelFetch<Pixel, Address> fetch(surface.texture);
  char* const pixels = static_cast<char*>(surface.target.pixels);
  const ptrdiff_t pitch = surface.target.pitch;
  for (int32_t k = 0; k < pieces.count; ++k) {
    const Span piece = pieces.rest(k, 0);
    int32_t count_px = piece.width_px();
    Pixel* to = reinterpret_cast<Pixel*>(pixels + piece.row * pitch) + piece.left_px;
    for (int32_t at = 0; at < kVectorsPerPiece && count_px > 0; ++at) {
      const TexelVectors decided = texels.at(k * kVectorsPerPiece + at);
      fetch.draw(decided.s, decided.t, count_px, to);
      count_px -= kLanes;
      to += kLanes;
    }
  }
}

// Draws a batch with many near-ties by columns or by boundaries, whichever costs less. False where
// it is drawn by neither.
template <class Pixel, class Address>
[[nodiscard]] HWY_NOINLINE bool draw_together(const ProjectiveSpans& spans, const Surface& surface,
                                              const AnchoredVectors& vectors) {
  const TexelRanges texels(spans.texels);
  const bool columns_first = beat_boundaries(spans.batch, texels);
  if (columns_first && draw_columns<Pixel, Address>(spans, surface, vectors)) return true;
  return draw_between_boundaries<Pixel, Address>(spans.batch, texels, spans.exact,
                                                 spans.field.most_denominator, surface) ||
         (!columns_first && draw_columns<Pixel, Address>(spans, surface, vectors));
}

// Draws a batch that was drawn from one window in vain.
template <class Pixel, class Address>
HWY_NOINLINE void draw_near_ties(const ProjectiveSpans& spans, const Surface& surface,
                                 const AnchoredVectors& vectors) {
  if (draw_together<Pixel, Address>(spans, surface, vectors)) return;
  ProjectiveTies batch_ties(spans, vectors);
  const LowLanes low(vectors.lack_fx16());
  const PieceLanes lanes = vectors.lanes();
  PieceWalk walk(spans.batch, PieceOrder::kSpanBySpan);  // ties go to another row at some cost
  Pieces pieces;
  Anchors anchors;
  DecidedTexels texels;
  for (walk.next(&pieces); pieces.count != 0; walk.next(&pieces)) {
    for (int32_t k = 0; k < pieces.count; k += kLanes) vectors.find_lanes(pieces, k, &anchors);
    batch_ties.with_ties(
        [&](auto* ties) { decide_pieces(pieces, lanes, anchors, low, ties, &texels); });
    draw_decided<Pixel, Address>(pieces, texels, surface);
  }
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
