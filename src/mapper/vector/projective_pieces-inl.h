// Projective spans, a vector of pixels at a time, from anchors. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_PROJECTIVE_PIECES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_PROJECTIVE_PIECES_INL_H
#undef SELVAGE_VECTOR_PROJECTIVE_PIECES_INL_H
#else
#define SELVAGE_VECTOR_PROJECTIVE_PIECES_INL_H
#endif

#include "mapper/vector/entries-inl.h"
#include "mapper/vector/fetch-inl.h"
#include "mapper/vector/left-inl.h"
#include "mapper/vector/piece_queue-inl.h"
#include "mapper/vector/projective_interior-inl.h"
#include "mapper/vector/projective_pairs-inl.h"
#include "mapper/vector/projective_ties-inl.h"
#include "mapper/vector/projective_wide-inl.h"
#include "mapper/vector/projective_window-inl.h"
#include "mapper/vector/store-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// Vectors that are left, with their lanes.
struct LeftOfPieces : Left {
  int32_t of_pieces;
  HWY_ALIGN int32_t u_fx16[kMost * kLanes], v_fx16[kMost * kLanes];
  int32_t window_rows[kMost];

  HWY_INLINE void put(int32_t i, const Span& rest_of_span, const LaneVectors& lanes, int32_t rows) {
    rest[static_cast<size_t>(i)] = rest_of_span;
    window_rows[i] = rows == kHalfWindow ? kHalfWindowRows : HWY_MAX(rows, 0);
    hn::Store(lanes.u, D32(), u_fx16 + i * kLanes);
    hn::Store(lanes.v, D32(), v_fx16 + i * kLanes);
  }
  [[nodiscard]] HWY_INLINE LaneVectors lanes(int32_t i) const {
    return {hn::Load(D32(), u_fx16 + i * kLanes), hn::Load(D32(), v_fx16 + i * kLanes)};
  }
};

template <class Ties>
HWY_NOINLINE void decide_left(const LeftOfPieces& left, const LowLanes& low, Ties* ties,
                              LeftTexels* texels) {
  for (int32_t i = 0; i < left.count; ++i) {
    const Span& rest = left.at(i);
    if (rest.row != ties->span().row) ties->go_to(rest);
    const int32_t offset_px = rest.left_px - ties->span().left_px;
    texels->put(i, low.decided(*ties, offset_px, left.lanes(i)), left.window_rows[i]);
  }
}

template <class Pixel, class Address>
HWY_NOINLINE void draw_left(const LeftOfPieces& left, const Surface& surface, const LowLanes& low,
                            ProjectiveTies* batch_ties) {
  LeftTexels texels;
  batch_ties->with_ties([&](auto* ties) { decide_left(left, low, ties, &texels); });
  draw_left<Pixel, Address>(left, texels, surface);
}

// What vectors of pieces are drawn with.
template <class Pixel, class Address>
class PieceDraw {
 public:
  HWY_INLINE PieceDraw(const AnchoredVectors& vectors, const Surface& surface, bool has_windows)
      : lanes_(vectors.lanes()),
        fixed_(surface.texture, vectors.lack_fx16()),
        raised_(vectors.lack_fx16()),
        texels_(static_cast<const Pixel*>(surface.texture.texels)),
        pitch_texel_(pitch_texel_of(surface.texture)),
        has_windows_(has_windows) {}

  HWY_INLINE LaneVectors lanes(const PieceBlock& block, int32_t k, int32_t at) const {
    return lanes_.lanes(block.anchors, k, at);
  }
  HWY_INLINE int32_t window_rows(const PieceBlock& block, int32_t k, int32_t at) const {
    return kHasWindows && has_windows_ ? block.windows.rows[at][k] : 0;
  }
  // False where a pixel may be a near-tie, or there is no window.
  template <class Fetch>
  HWY_INLINE bool draw(const PieceBlock& block, int32_t k, int32_t at, int32_t count_px,
                       Fetch* fetch, Pixel* to) const {
    const int32_t rows = window_rows(block, k, at);
    if (kHasWindows && rows != 0) {
      if (HWY_UNLIKELY(rows == kNoWindow)) return false;
      const LaneVectors lanes = in_window(block, k, at);
      if (HWY_UNLIKELY(raised_.any_near(lanes))) return false;
      store_pixels(picked(block, k, at, rows, lanes), count_px, to);
    } else {
      const LaneVectors lanes = this->lanes(block, k, at);
      if (HWY_UNLIKELY(fixed_.any_near(lanes))) return false;
      fetch->add(fixed_.places(lanes), count_px, reinterpret_cast<char*>(to));
    }
    return true;
  }
  // Both vectors of a whole piece; false, and nothing is drawn, where one of them has no window or
  // a pixel may be a near-tie.
  HWY_INLINE bool draw_both(const PieceBlock& block, int32_t k, Pixel* to) const {
    static_assert(!kHasWindows || kVectorsPerPiece <= 2);
    constexpr int32_t kSecond = kVectorsPerPiece - 1;
    const int32_t rows = window_rows(block, k, 0), second_rows = window_rows(block, k, kSecond);
    if (!is_window(rows) || !is_window(second_rows)) return false;
    const LaneVectors lanes = in_window(block, k, 0), second = in_window(block, k, kSecond);
    if (HWY_UNLIKELY(raised_.any_near(lanes, second))) return false;
    store_pixels(picked(block, k, 0, rows, lanes), kLanes, to);
    store_pixels(picked(block, k, kSecond, second_rows, second), kLanes, to + kLanes);
    return true;
  }

 private:
  using Fixed = FixedLanes<Address>;
  static HWY_INLINE bool is_window(int32_t rows) { return rows == kHalfWindow || rows > 0; }
  // From a window, by raised lanes that are counted from it.
  HWY_INLINE V32 picked(const PieceBlock& block, int32_t k, int32_t at, int32_t rows,
                        const LaneVectors& lanes) const {
    const Pixel* const window = texels_ + block.windows.place[at][k];
    if (HWY_LIKELY(rows == kHalfWindow)) {
      const V32 index = Fixed::template window_index<kHalfColumnBits>(lanes, kHalfWindowRows);
      return pick<kHalfColumnBits>(window, pitch_texel_, kHalfWindowRows, index);
    }
    const V32 index = Fixed::template window_index<kWindowColumnBits>(lanes, rows);
    return pick_few(window, pitch_texel_, rows, index);
  }
  // Raised lanes, counted from the window.
  HWY_INLINE LaneVectors in_window(const PieceBlock& block, int32_t k, int32_t at) const {
    const PieceWindows& windows = block.windows;
    return PieceLanes::plus(lanes_.walk(block.anchors, k, at), windows.u_fx16[at][k],
                            windows.v_fx16[at][k]);
  }

  PieceLanes lanes_;
  Fixed fixed_;
  RaisedLanes raised_;
  const Pixel* texels_;
  ptrdiff_t pitch_texel_;
  bool has_windows_;
};

// Until `left` may not hold the next ones; false where no piece is left.
template <class Pixel, class Address, class Fetch>
HWY_NOINLINE bool draw_pieces(const Surface& surface, const AnchoredVectors& vectors,
                              bool has_windows, PieceQueue* queue, LeftOfPieces* left) {
  const PieceDraw<Pixel, Address> by(vectors, surface, has_windows);
  const Extent extent = extent_of(surface.texture);
  Fetch fetch(surface.texture.texels);
  char* const pixels = static_cast<char*>(surface.target.pixels);
  const ptrdiff_t pitch = surface.target.pitch;
  int32_t left_count = 0, piece_count = 0;
  bool more = true;
  static_assert(Left::kMost >= kMostPieces * kVectorsPerPiece);
  while (left_count <= Left::kMost - kMostPieces * kVectorsPerPiece) {
    const PieceBlock& block = queue->template next<Address>(extent, has_windows);
    const Pieces& pieces = block.pieces;
    more = pieces.count != 0;
    if (!more) break;
    piece_count += pieces.count;
    for (int32_t k = 0, count = pieces.count; k < count; ++k) {
      int32_t count_px = pieces.width_px[k];
      Pixel* to = reinterpret_cast<Pixel*>(pixels + pieces.row[k] * pitch) + pieces.left_px[k];
      if (kHasWindows && kVectorsPerPiece == 2 && count_px >= kPiece_px) {
        if (HWY_LIKELY(by.draw_both(block, k, to))) continue;
      }
      for (int32_t at = 0; at < kVectorsPerPiece && count_px > 0; ++at) {
        if (HWY_UNLIKELY(!by.draw(block, k, at, count_px, &fetch, to))) {
          left->put(left_count++, pieces.rest(k, at), by.lanes(block, k, at),
                    by.window_rows(block, k, at));
        }
        count_px -= kLanes;
        to += kLanes;
      }
    }
  }
  fetch.finish();
  left->count = left_count;
  left->of_pieces = piece_count;
  return more;
}

// By itself, so that small polygons, which one window holds, do without the room that this takes.
template <class Pixel, class Address>
HWY_NOINLINE void draw_all_pieces(const ProjectiveSpans& spans, const Surface& surface,
                                  const AnchoredVectors& vectors) {
  // Ties of rows that each have a map of their own cost most where they go to another row.
  const PieceOrder order = spans.exact.is_ruled() ? PieceOrder::kSpanBySpan : PieceOrder::kAny;
  PieceQueue queue(spans.batch, order, vectors);
  LeftOfPieces left;
  ProjectiveTies batch_ties(spans, vectors);
  const bool cached = is_cached(surface.texture);
  const bool inside = cached && pays_to_ask_inside(spans.batch) &&
                      is_inside(spans.batch, spans.field, vectors, surface.texture);
  const bool has_windows = may_have_windows(surface.texture) && spans.batch.widest_px >= 2 * kLanes;
  bool more = true, is_refused = false;
  while (more) {
    if (!cached) {
      more = draw_pieces<Pixel, Address, FetchAhead<Pixel>>(surface, vectors, has_windows, &queue,
                                                            &left);
    } else if (inside) {
      more = draw_pieces<Pixel, Addressed<InsideVector>, FetchAtOnce<Pixel>>(
          surface, vectors, has_windows, &queue, &left);
    } else {
      more = draw_pieces<Pixel, Address, FetchAtOnce<Pixel>>(surface, vectors, has_windows, &queue,
                                                             &left);
    }
    if (left.count == 0) continue;
    if (!is_refused && are_most(left.count, left.of_pieces)) {
      if (draw_together<Pixel, Address>(spans, surface, vectors)) return;
      is_refused = true;
    }
    draw_left<Pixel, Address>(left, surface, LowLanes(vectors.lack_fx16()), &batch_ties);
  }
}

// The last row of an odd number of them has none below it to be drawn with.
template <class Pixel, class Address>
HWY_INLINE void draw_last_row(const ProjectiveSpans& spans, const Surface& surface,
                              const AnchoredVectors& vectors) {
  const SpanBatch last = one_span(spans.batch.span(spans.batch.rows - 1));
  draw_all_pieces<Pixel, Address>({last, spans.field, spans.texels, spans.exact}, surface, vectors);
}

template <class Pixel, class Address>
HWY_NOINLINE void draw_by_pieces(const ProjectiveSpans& spans, const Surface& surface) {
  const AnchoredVectors vectors(spans.field);
  const InOneWindow in_one = draw_one_window<Pixel, Address>(spans, surface, vectors);
  if (in_one == InOneWindow::kDrawn) return;
  if (in_one == InOneWindow::kManyNearTies) {
    return draw_near_ties<Pixel, Address>(spans, surface, vectors);
  }
  if constexpr (kHasPairs) {
    if (draw_by_pairs<Pixel, Address>(spans, surface)) {
      if (spans.batch.rows % 2 != 0) draw_last_row<Pixel, Address>(spans, surface, vectors);
      return;
    }
  }
  draw_all_pieces<Pixel, Address>(spans, surface, vectors);
}

}  // namespace

void draw_projective(const ProjectiveSpans& spans, const Surface& surface) {
  const bool by_pieces = are_anchored(spans.field);
  with_address(surface, [&](auto address) {
    with_pixel(surface.target.format, [&](auto pixel) {
      using Pixel = decltype(pixel);
      using Address = decltype(address);
      if (by_pieces) {
        draw_by_pieces<Pixel, Address>(spans, surface);
      } else if (is_cached(surface.texture)) {
        draw_wide_projective<Pixel, Address, FetchAtOnce<Pixel>>(spans, surface);
      } else {
        draw_wide_projective<Pixel, Address, FetchAhead<Pixel>>(spans, surface);
      }
    });
  });
}

}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
