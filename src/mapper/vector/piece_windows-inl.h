// The windows of pieces. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_PIECE_WINDOWS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_PIECE_WINDOWS_INL_H
#undef SELVAGE_VECTOR_PIECE_WINDOWS_INL_H
#else
#define SELVAGE_VECTOR_PIECE_WINDOWS_INL_H
#endif

#include "mapper/vector/projective_anchors-inl.h"
#include "mapper/vector/window-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// The windows of vectors of pieces: the lanes of the piece's anchor counted from there, raised by
// all that lanes lack, less kWholeNumbers, as bits; their places; and rows. Where they are
// kHalfWindow, half as many columns are enough; where kNoWindow, it does not lie in the texture;
// where 0, there is a load for each pixel.
struct PieceWindows {
  int32_t u_fx16[kVectorsPerPiece][kMostPieces], v_fx16[kVectorsPerPiece][kMostPieces];
  int32_t place[kVectorsPerPiece][kMostPieces], rows[kVectorsPerPiece][kMostPieces];
};
inline constexpr int32_t kHalfWindow = -1, kNoWindow = -2;

// Texels from the first one on, at most as many as that: two no further apart than n are in n
// rounded up, plus one.
struct TexelRun {
  V32 first, count;
};
[[nodiscard]] HWY_INLINE TexelRun run_of(V32 anchor_fx16, VFloat rise, VFloat first, VFloat last) {
  const D32 d;
  const DFloat df;
  const V32 from = hn::Add(anchor_fx16, walk_of(df, first, rise));
  const V32 to = hn::Add(anchor_fx16, walk_of(df, last, rise));
  constexpr int32_t kOne = 1 << kTexelFraction;
  const V32 apart = hn::Add(hn::Abs(hn::Sub(to, from)), hn::Set(d, 2 * kOne - 1));
  return {hn::ShiftRight<kTexelFraction>(hn::Min(from, to)), hn::ShiftRight<kTexelFraction>(apart)};
}

// How large windows of so many texels are, and what PieceWindows calls their rows, 0 where they
// would be too large.
struct WindowShapes {
  V32 columns, rows, name;
};
[[nodiscard]] HWY_INLINE WindowShapes shapes_of(V32 columns, V32 rows, int32_t height_texel) {
  const D32 d;
  const int32_t most_half = height_texel >= kHalfWindowRows ? kColumns<kHalfColumnBits> : 0;
  const int32_t most_rows = HWY_MIN(kMostWindowRows, height_texel);
  const auto is_half = hn::And(hn::Lt(columns, hn::Set(d, most_half + 1)),
                               hn::Lt(rows, hn::Set(d, kHalfWindowRows + 1)));
  const V32 whole = whole_rows(rows);
  const auto too_large =
      hn::Or(hn::Gt(columns, hn::Set(d, kLanes)), hn::Gt(whole, hn::Set(d, most_rows)));
  return {hn::IfThenElse(is_half, hn::Set(d, kColumns<kHalfColumnBits>), hn::Set(d, kLanes)),
          hn::IfThenElse(is_half, hn::Set(d, kHalfWindowRows), whole),
          hn::IfThenElse(is_half, hn::Set(d, kHalfWindow), hn::IfThenZeroElse(too_large, whole))};
}

// Of one vector of kLanes pieces from k on. Along a span u and v rise or fall all the way: its ends
// have the least and the most.
template <class Address, int32_t kVector>
HWY_INLINE void find_windows(const Pieces& pieces, int32_t k, const Anchors& anchors,
                             const Extent& extent, int32_t lack_fx16, PieceWindows* windows) {
  const D32 d;
  const DFloat df;
  const V32 end = hn::Min(hn::LoadU(d, pieces.width_px + k), hn::Set(d, (kVector + 1) * kLanes));
  const VFloat turn = hn::LoadU(df, anchors.turn + k);
  const auto share = [&](V32 px) HWY_ATTR { return share_of(df, hn::ConvertTo(df, px), turn); };
  const VFloat first = kVector == 0 ? hn::Zero(df) : share(hn::Set(d, kVector * kLanes));
  const VFloat last = share(hn::Sub(end, hn::Set(d, 1)));
  const V32 u = hn::LoadU(d, anchors.u_fx16 + k), v = hn::LoadU(d, anchors.v_fx16 + k);
  const TexelRun s = run_of(u, hn::LoadU(df, anchors.u_rise + k), first, last);
  const TexelRun t = run_of(v, hn::LoadU(df, anchors.v_rise + k), first, last);

  const WindowShapes shapes = shapes_of(s.count, t.count, extent.height_texel);
  const auto origins =
      window_origins<Address>(s.first, t.first, shapes.columns, shapes.rows, extent);
  const V32 lack = hn::Set(d, lack_fx16);
  const auto from = [&](V32 anchor_fx16, V32 texel) HWY_ATTR {
    return hn::Sub(hn::Add(anchor_fx16, lack), hn::ShiftLeft<kTexelFraction>(texel));
  };
  hn::StoreU(from(u, origins.s), d, windows->u_fx16[kVector] + k);
  hn::StoreU(from(v, origins.t), d, windows->v_fx16[kVector] + k);
  hn::StoreU(origins.place, d, windows->place[kVector] + k);
  const auto is_outside =
      hn::And(hn::Eq(origins.place, hn::Set(d, kNoPlace)), hn::Ne(shapes.name, hn::Zero(d)));
  hn::StoreU(hn::IfThenElse(is_outside, hn::Set(d, kNoWindow), shapes.name), d,
             windows->rows[kVector] + k);
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
