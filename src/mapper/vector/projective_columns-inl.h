// Near-ties of narrow projective rows, column by column. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_PROJECTIVE_COLUMNS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_PROJECTIVE_COLUMNS_INL_H
#undef SELVAGE_VECTOR_PROJECTIVE_COLUMNS_INL_H
#else
#define SELVAGE_VECTOR_PROJECTIVE_COLUMNS_INL_H
#endif

#include "mapper/vector/projective_anchors-inl.h"
#include "mapper/vector/tie_columns-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// The lanes of a pixel of each of kLanes pieces, beginning with the anchors, as PieceLanes has
// them.
class AnchoredColumn {
 public:
  HWY_INLINE AnchoredColumn(const Anchors& anchors, int32_t k)
      : u_fx16_(hn::LoadU(D32(), anchors.u_fx16 + k)),
        v_fx16_(hn::LoadU(D32(), anchors.v_fx16 + k)),
        turn_(hn::LoadU(DFloat(), anchors.turn + k)),
        u_rise_(hn::LoadU(DFloat(), anchors.u_rise + k)),
        v_rise_(hn::LoadU(DFloat(), anchors.v_rise + k)),
        i_(hn::Zero(DFloat())) {}

  [[nodiscard]] HWY_INLINE LaneVectors get() const {
    const DFloat d;
    const VFloat share = share_of(d, i_, turn_);
    return {hn::Add(u_fx16_, walk_of(d, share, u_rise_)),
            hn::Add(v_fx16_, walk_of(d, share, v_rise_))};
  }
  HWY_INLINE void go_right() { i_ = hn::Add(i_, hn::Set(DFloat(), 1.0F)); }

 private:
  V32 u_fx16_, v_fx16_;
  VFloat turn_, u_rise_, v_rise_, i_;
};

// Draws pieces of narrow rows that lie in one slab, kLanes of them at a time.
template <class Pixel, class Address>
class PieceColumnsDraw {
 public:
  using Slab = TwoLimbsColumn::Slab;

  HWY_INLINE PieceColumnsDraw(const Slab& slab, const Surface& surface, int32_t lack_fx16)
      : slab_(slab), surface_(surface), extent_(extent_of(surface.texture)), low_(lack_fx16) {}

  // Those from k on that there are, by their anchors.
  HWY_INLINE void draw(const Pieces& pieces, const Anchors& anchors, int32_t k) {
    const int32_t end = HWY_MIN(k + kLanes, pieces.count);
    int32_t widest_px = 0;
    for (int32_t i = k; i < end; ++i) widest_px = HWY_MAX(widest_px, pieces.rest(i, 0).width_px());
    widest_px = HWY_MIN(widest_px, kPiece_px);
    const V32 left_px = hn::LoadU(D32(), pieces.left_px + k);
    DecidedColumns<TwoLimbsColumn, AnchoredColumn> from(
        low_, ColumnTies<TwoLimbsColumn>(slab_, pieces.row[k], left_px),
        AnchoredColumn(anchors, k));
    for (int32_t from_px = 0; from_px < widest_px; from_px += kLanes) {
      columns_.find<Address>(HWY_MIN(kLanes, widest_px - from_px), extent_, &from);
      for (int32_t i = k; i < end; ++i) {
        const Span piece = pieces.rest(i, 0);
        auto* const to = reinterpret_cast<Pixel*>(first_pixel(surface_, piece));
        columns_.draw(i - k, surface_.texture.texels, HWY_MIN(kLanes, piece.width_px() - from_px),
                      to + from_px);
      }
    }
  }

 private:
  Slab slab_;
  const Surface& surface_;
  Extent extent_;
  LowLanes low_;
  PlaceColumns columns_;
};

// Draws a batch. False where it costs less to decide vectors one by one, edges change sides, or
// there are several slabs, which batches in perspective have not.
template <class Pixel, class Address>
[[nodiscard]] HWY_NOINLINE bool draw_columns(const ProjectiveSpans& spans, const Surface& surface,
                                             const AnchoredVectors& vectors) {
  using Draw = PieceColumnsDraw<Pixel, Address>;
  const bool is_ruled = spans.exact.is_ruled();
  if (!pays_columns(spans.batch) || (is_ruled && !is_directed(spans.exact.ruled()))) return false;
  // One map goes from row to row at little cost.
  if (!is_ruled && spans.batch.widest_px > kLanes) return false;
  const Span first = spans.batch.span(0);
  const auto slab = biased_slab<typename Draw::Slab>(spans.exact, first.left_px, first.row);
  if (!slab.has(first.row + spans.batch.rows - 1)) return false;
  Draw by(slab, surface, vectors.lack_fx16());
  PieceWalk walk(spans.batch, PieceOrder::kAny);
  Pieces pieces;
  Anchors anchors;
  for (walk.next(&pieces); pieces.count != 0; walk.next(&pieces)) {
    for (int32_t k = 0; k < pieces.count; k += kLanes) {
      vectors.find_lanes(pieces, k, &anchors);
      by.draw(pieces, anchors, k);
    }
  }
  return true;
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
