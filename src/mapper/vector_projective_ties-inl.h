// Projective spans of a polygon whose texels lie in one window, with many near-ties among them.
// Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_PROJECTIVE_TIES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_PROJECTIVE_TIES_INL_H
#undef SELVAGE_VECTOR_PROJECTIVE_TIES_INL_H
#else
#define SELVAGE_VECTOR_PROJECTIVE_TIES_INL_H
#endif

#include <optional>

#include "mapper/vector_batch_ties-inl.h"
#include "mapper/vector_decided_window-inl.h"
#include "mapper/vector_projective_anchors-inl.h"

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
  BatchTies of_one_map_;
  std::optional<RuledBatchTies> ruled_;
};

template <class Pixel, class Window>
HWY_NOINLINE void draw_decided(const Window& window, const SpanBatch& batch,
                               const selvage_image& target, const AnchoredVectors& vectors) {
  const PieceLanes lanes = vectors.lanes();
  char* const pixels = static_cast<char*>(target.pixels);
  PieceWalk walk(batch, PieceOrder::kSpanBySpan);  // ties go to another row at some cost
  Pieces pieces;
  Anchors anchors;
  for (walk.next(&pieces); pieces.count != 0; walk.next(&pieces)) {
    for (int32_t k = 0; k < pieces.count; k += kLanes) vectors.find_lanes(pieces, k, &anchors);
    for (int32_t k = 0; k < pieces.count; ++k) {
      const Span piece = pieces.rest(k, 0);
      int32_t count_px = piece.width_px();
      Pixel* to = reinterpret_cast<Pixel*>(pixels + piece.row * target.pitch) + piece.left_px;
      for (int32_t at = 0; at < kVectorsPerPiece && count_px > 0; ++at) {
        window.draw(window.offset_px(piece) + at * kLanes, lanes.lanes(anchors, k, at), count_px,
                    to);
        count_px -= kLanes;
        to += kLanes;
      }
    }
  }
}

template <class Pixel, class Ties>
HWY_INLINE void draw_near_ties_by(Ties* ties, const ProjectiveSpans& spans, const Surface& surface,
                                  const AnchoredVectors& vectors) {
  with_decided_window<Pixel>(TexelRanges(spans.texels), surface, vectors.lack_fx16(), ties,
                             [&](const auto& window) {
                               draw_decided<Pixel>(window, spans.batch, surface.target, vectors);
                             });
}

// Draws a batch that was drawn from one window in vain, if that lies within the texture.
template <class Pixel>
[[nodiscard]] HWY_NOINLINE bool draw_near_ties(const ProjectiveSpans& spans, const Surface& surface,
                                               const AnchoredVectors& vectors) {
  if (!TexelRanges(spans.texels).within(surface.texture)) return false;
  ProjectiveTies(spans, vectors).with_ties([&](auto* by) {
    draw_near_ties_by<Pixel>(by, spans, surface, vectors);
  });
  return true;
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
