// Projective spans by windows, two rows at a time: where texels are some pixels wide, one window
// holds those of a vector and of the one below it. Included once for each SIMD target.
//
// Pixels beside a row are found, too, and drawn nowhere: the map is asked to be gentle in the whole
// box around a batch.
#if defined(SELVAGE_VECTOR_PROJECTIVE_PAIRS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_PROJECTIVE_PAIRS_INL_H
#undef SELVAGE_VECTOR_PROJECTIVE_PAIRS_INL_H
#else
#define SELVAGE_VECTOR_PROJECTIVE_PAIRS_INL_H
#endif

#include <bit>

#include "mapper/vector/projective_interior-inl.h"
#include "mapper/vector/projective_pair_windows-inl.h"
#include "mapper/vector/projective_ties-inl.h"
#include "mapper/vector/row_blocks-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// Picks the texels of a vector and of the one below it. Lanes are as PairWindows has them: the bits
// of kWholeNumbers are above those of texels.
template <class Pixel>
class ProjectivePairPicker {
 public:
  HWY_INLINE ProjectivePairPicker(const AnchoredVectors& vectors, const Surface& surface)
      : raised_(vectors.lack_fx16()),
        one_(hn::Set(DFloat(), 1.0F)),
        texels_(static_cast<const Pixel*>(surface.texture.texels)),
        pitch_texel_(pitch_texel_of(surface.texture)) {
    for (int32_t i = 0; i < kPairAnchor_px; ++i) steps_[i] = static_cast<float>(i);
  }

  // False where one of their lanes, of a pixel or not, may be a near-tie, or there is no window.
  HWY_INLINE bool pick_both(const PairWindows& found, int32_t k, V32* upper, V32* lower) const {
    const int32_t rows = found.rows[k], at = 2 * (k / kVectorsPerAnchor);
    const VFloat i = hn::Load(DFloat(), steps_ + k % kVectorsPerAnchor * kLanes);
    const LaneVectors above = lanes(found, at, i, found.upper_u[k], found.upper_v[k]);
    const LaneVectors below = lanes(found, at + 1, i, found.lower_u[k], found.lower_v[k]);
    if (HWY_UNLIKELY(raised_.any_near(above, below))) return false;
    const Pixel* const window = texels_ + found.place[k];
    V32 picked[2];
    if (HWY_LIKELY(rows == kHalfWindow)) {
      const V32 indices[] = {half_index(above), half_index(below)};
      pick_all<kHalfColumnBits>(window, pitch_texel_, kHalfWindowRows, indices, picked);
    } else if (HWY_UNLIKELY(rows == 0)) {
      return false;
    } else {
      const V32 indices[] = {index(above), index(below)};
      pick_few(window, pitch_texel_, rows, indices, picked);
    }
    *upper = picked[0];
    *lower = picked[1];
    return true;
  }

 private:
  HWY_INLINE LaneVectors lanes(const PairWindows& found, int32_t anchor, VFloat i, float u,
                               float v) const {
    const DFloat df;
    const VFloat turn = hn::Set(df, found.turn[anchor]);
    const VFloat share = hn::Div(i, hn::MulAdd(i, turn, one_));
    const auto lane = [&](float rise, float from) HWY_ATTR {
      return hn::BitCast(D32(), hn::MulAdd(share, hn::Set(df, rise), hn::Set(df, from)));
    };
    return {lane(found.u_rise[anchor], u), lane(found.v_rise[anchor], v)};
  }
  // One permute asks for no higher bits than those of texels, and those of kWholeNumbers are 0
  // there.
  static constexpr auto kWholeBits = std::bit_cast<uint32_t>(kWholeNumbers);
  static_assert((kWholeBits >> kTexelFraction) % (2 * kLanes) == 0);
  static_assert((kWholeBits >> (kTexelFraction - kHalfColumnBits)) % (2 * kLanes) == 0);
  static HWY_INLINE V32 half_index(const LaneVectors& lanes) {
    return FixedLanes<Addressed<InsideVector>>::window_index<kHalfColumnBits>(lanes,
                                                                              kHalfWindowRows);
  }
  static HWY_INLINE V32 index(const LaneVectors& lanes) {
    const D32 d;
    const V32 s = hn::ShiftRight<kTexelFraction>(lanes.u);
    const V32 t = hn::ShiftRight<kTexelFraction - kWindowColumnBits>(lanes.v);
    constexpr int32_t kColumn = kLanes - 1, kTexels = 16 * kLanes - 1;
    static_assert(kMostWindowRows <= 16);
    return hn::And(hn::IfVecThenElse(hn::Set(d, kColumn), s, t), hn::Set(d, kTexels));
  }

  RaisedLanes raised_;
  VFloat one_;
  HWY_ALIGN float steps_[kPairAnchor_px];
  const Pixel* texels_;
  ptrdiff_t pitch_texel_;
};

// Pairs of rows from a place on, as far as there is room for what is left of them. Returns how many
// vectors it drew or left.
template <class Pixel>
HWY_NOINLINE int32_t draw_pairs(const SpanBatch& batch, const AnchoredVectors& vectors,
                                const Surface& surface, Resume* at, Left* left) {
  const ProjectivePairPicker<Pixel> by(vectors, surface);
  const PairFinder finder(vectors, extent_of(surface.texture));
  PairWindows found[2];
  PairRun runs[2];
  // No anchor lies left of the box.
  PairWalk walk(batch, *at, PairWindows::kMost,
                [](const Span& both) HWY_ATTR { return both.left_px; });
  const auto find_next = [&](int32_t i) HWY_ATTR __attribute__((always_inline)) {
    if (!walk.next(&runs[i])) return false;
    finder.find(runs[i], &found[i]);
    return true;
  };
  left->count = 0;
  int32_t i = 0, vectors_drawn = 0;
  for (bool has_run = find_next(i); has_run; i ^= 1) {
    has_run = find_next(i ^ 1);
    const PairRun& run = runs[i];
    const int32_t drawn = draw_pair_run<Pixel>(by, found[i], run, surface, left);
    vectors_drawn += 2 * drawn;
    if (drawn < run.vectors) {
      *at = {run.index, run.px + drawn * kLanes};
      return vectors_drawn;
    }
  }
  *at = walk.at();
  return vectors_drawn;
}

template <class Pixel, class Address>
HWY_NOINLINE void draw_left_of_pairs(const Left& left, const Surface& surface,
                                     const AnchoredVectors& vectors, ProjectiveTies* batch_ties) {
  const LowLanes low(vectors.lack_fx16());
  const PieceLanes lanes = vectors.lanes();
  Pieces pieces;
  Anchors anchors;
  DecidedTexels texels;
  for (int32_t first = 0; first < left.count; first += kMostPieces) {
    pieces.count = HWY_MIN(left.count - first, kMostPieces);
    for (int32_t k = 0; k < pieces.count; ++k) {
      const Span& rest = left.at(first + k);
      pieces.row[k] = rest.row;
      pieces.left_px[k] = rest.left_px;
      pieces.width_px[k] = HWY_MIN(rest.width_px(), kLanes);
    }
    for (int32_t k = 0; k < pieces.count; k += kLanes) vectors.find_lanes(pieces, k, &anchors);
    batch_ties->with_ties(
        [&](auto* ties) { decide_pieces(pieces, lanes, anchors, low, ties, &texels); });
    draw_decided<Pixel, Address>(pieces, texels, surface);
  }
}

// What pairs of rows cost beside their vectors, and vectors where one of them has no pixels, which
// are mostly left, beside those of both.
[[nodiscard]] HWY_INLINE bool pays_pairs(const ProjectiveSpans& spans,
                                         const selvage_texture& texture) {
  constexpr int32_t kPairCost_px = 5 * kLanes, kOverhangCost = 3;
  const SpanBatch& batch = spans.batch;
  if (is_narrow(batch) || batch.rows < 2 || spans.field.is_ruled || !may_have_windows(texture) ||
      HWY_MAX(texture.width, texture.height) > kMostPairTexture_texel) {
    return false;
  }
  int32_t by_rows_px = 0, by_pairs_px = 0;
  for (int32_t i = 0; i + 1 < batch.rows; i += 2) {
    const Span upper = batch.span(i), lower = batch.span(i + 1);
    const int32_t width_px = upper.width_px() + lower.width_px();
    const int32_t both_px = around(upper, lower).width_px();
    by_rows_px += width_px;
    by_pairs_px += both_px + kOverhangCost * (2 * both_px - width_px) + kPairCost_px;
  }
  return by_pairs_px <= by_rows_px;
}

// Draws a batch two rows at a time, but for a last row that has none below it. False where it costs
// less to draw all of it by others, be it that some was drawn.
template <class Pixel, class Address>
[[nodiscard]] HWY_NOINLINE bool draw_by_pairs(const ProjectiveSpans& spans,
                                              const Surface& surface) {
  const SpanBatch& batch = spans.batch;
  if (!pays_pairs(spans, surface.texture)) return false;
  const ProjectiveBox box(spans.field, batch);
  if (!are_pairs_anchored(box)) return false;
  const AnchoredVectors vectors(spans.field, pair_error_fx16(spans.field, box));
  if (!is_inside(batch, spans.field, vectors, surface.texture)) return false;
  ProjectiveTies batch_ties(spans, vectors);
  Resume at;
  Left left;
  while (at.row + 1 < batch.rows) {
    const int32_t drawn = draw_pairs<Pixel>(batch, vectors, surface, &at, &left);
    if (are_many(left.count, drawn)) return false;
    draw_left_of_pairs<Pixel, Address>(left, surface, vectors, &batch_ties);
  }
  return true;
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
