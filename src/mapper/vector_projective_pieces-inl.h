// Projective spans, a vector of pixels at a time, from anchors. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_PROJECTIVE_PIECES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_PROJECTIVE_PIECES_INL_H
#undef SELVAGE_VECTOR_PROJECTIVE_PIECES_INL_H
#else
#define SELVAGE_VECTOR_PROJECTIVE_PIECES_INL_H
#endif

#include "mapper/interior.h"
#include "mapper/vector_fetch-inl.h"
#include "mapper/vector_one_window-inl.h"
#include "mapper/vector_projective_anchors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// Vectors that are left, with their lanes.
struct LeftOfPieces : Left {
  HWY_ALIGN int32_t u_fx16[kMost * kLanes], v_fx16[kMost * kLanes];
  int32_t window_rows[kMost];

  HWY_INLINE void put(int32_t i, const Span& rest_of_span, const LaneVectors& lanes, int32_t rows) {
    rest[static_cast<size_t>(i)] = rest_of_span;
    window_rows[i] = rows;
    hn::Store(lanes.u, D32(), u_fx16 + i * kLanes);
    hn::Store(lanes.v, D32(), v_fx16 + i * kLanes);
  }
  // Of a whole vector.
  [[nodiscard]] HWY_INLINE LowWindow low_window(int32_t i) const {
    const auto least = [&](const int32_t* lane) {
      return HWY_MIN(lane[0], lane[kLanes - 1]) >> kTexelFraction;
    };
    return {least(u_fx16 + i * kLanes), least(v_fx16 + i * kLanes), window_rows[i]};
  }
  [[nodiscard]] HWY_INLINE LaneVectors lanes(int32_t i) const {
    return {hn::Load(D32(), u_fx16 + i * kLanes), hn::Load(D32(), v_fx16 + i * kLanes)};
  }
};

template <class Pixel, class Address>
HWY_NOINLINE void draw_left(const LeftOfPieces& left, const ProjectiveSpans& spans,
                            const Surface& surface, int32_t lack_fx16) {
  const FixedLanes<Address> fixed(surface.texture, lack_fx16);
  RowOfTies ties(spans.exact, left.rest[0], 0, fixed.spare_bits());
  for (int32_t i = 0; i < left.count; ++i) {
    const Span& rest = left.rest[static_cast<size_t>(i)];
    if (rest.row != ties.span().row) ties.go_to(rest);
    fixed.template draw<Pixel>(rest, surface, ties, left.lanes(i), left.low_window(i));
  }
}

template <class Address>
HWY_INLINE void find(const Pieces& pieces, const AnchoredVectors& vectors, const Extent& extent,
                     Anchors* anchors, PieceOrigins* origins) {
  for (int32_t k = 0; k < pieces.count; k += kDoubles) {
    vectors.find(pieces, k, anchors);
    for (int32_t at = 0; kHasWindows && pieces.has_windows && at < kVectorsPerPiece; ++at) {
      AnchoredVectors::find_origins<Address>(pieces, k, at, *anchors, extent, origins);
    }
  }
}

// Until `left` may not hold the next ones; false where no piece is left.
template <class Pixel, class Address, class Fetch>
HWY_NOINLINE bool draw_pieces(const Surface& surface, const AnchoredVectors& vectors,
                              PieceWalk* from, LeftOfPieces* left) {
  const FixedLanes<Address> fixed(surface.texture, vectors.lack_fx16());
  const Extent extent = extent_of(surface.texture);
  const auto* const texels = static_cast<const Pixel*>(surface.texture.texels);
  Fetch fetch(texels);
  char* const pixels = static_cast<char*>(surface.target.pixels);
  const ptrdiff_t pitch = surface.target.pitch;
  PieceWalk walk = *from;
  int32_t left_count = 0;
  bool more = true;
  Pieces pieces;
  Anchors anchors;
  PieceOrigins origins;
  static_assert(Left::kMost >= kMostPieces * kVectorsPerPiece);
  while (left_count <= Left::kMost - kMostPieces * kVectorsPerPiece &&
         (more = walk.next(&pieces))) {
    find<Address>(pieces, vectors, extent, &anchors, &origins);
    for (int32_t k = 0; k < pieces.count; ++k) {
      int32_t count_px = pieces.right_px[k] - pieces.left_px[k];
      const int32_t rows = kHasWindows ? pieces.window_rows[k] : 0;
      Pixel* to = reinterpret_cast<Pixel*>(pixels + pieces.row[k] * pitch) + pieces.left_px[k];
      for (int32_t at = 0; at < kVectorsPerPiece && count_px > 0; ++at) {
        const LaneVectors lanes = AnchoredVectors::lanes_from(anchors, k, at);
        if (HWY_UNLIKELY(fixed.any_near(lanes) || (rows != 0 && origins.place[at][k] < 0))) {
          left->put(left_count++, pieces.rest(k, at), lanes, rows);
        } else if (rows != 0) {
          const V32 index = fixed.window_index(lanes, hn::Set(D32(), origins.index[at][k]));
          store_pixels(pick_few(texels + origins.place[at][k], extent.pitch_texel, rows, index),
                       count_px, to);
        } else {
          fetch.add(fixed.places(lanes), count_px, reinterpret_cast<char*>(to));
        }
        count_px -= kLanes;
        to += kLanes;
      }
    }
  }
  fetch.finish();
  left->count = left_count;
  *from = walk;
  return more;
}

// A strip of a block: of its rows, a piece each, from so many pixels right of their first ones on,
// maybe of no pixels. Returns what the lanes of pixels lack changes in them.
template <class Pixel, class Fixed, class OneWindow>
[[nodiscard]] HWY_INLINE V32 draw_strip(const OneWindow& window, const Fixed& fixed,
                                        const AnchoredVectors& vectors, const SpanBatch& batch,
                                        const selvage_image& target, const RowBlock& block,
                                        int32_t right_by_px) {
  const D32 d;
  const ptrdiff_t pitch = target.pitch;
  char* row = static_cast<char*>(target.pixels) + (batch.first_row + block.first) * pitch;
  V32 changed = hn::Zero(d);
  Pieces pieces;
  Anchors anchors;
  for (int32_t first = block.first; first < block.end; first += kMostPieces) {
    pieces.put_rows(batch, first, HWY_MIN(block.end - first, kMostPieces), right_by_px);
    for (int32_t k = 0; k < pieces.count; k += kDoubles) vectors.find(pieces, k, &anchors);
    for (int32_t k = 0; k < pieces.count; ++k) {
      int32_t count_px = pieces.right_px[k] - pieces.left_px[k];
      Pixel* to = reinterpret_cast<Pixel*>(row) + pieces.left_px[k];
      for (int32_t at = 0; at < kVectorsPerPiece && (at == 0 || count_px > 0); ++at) {
        const LaneVectors lanes = AnchoredVectors::lanes_from(anchors, k, at);
        const auto is_pixel = hn::Gt(hn::Set(d, count_px), hn::Iota(d, 0));
        changed = hn::IfThenElse(is_pixel, hn::Or(changed, fixed.changes(lanes)), changed);
        store_first(is_pixel, window.texels(lanes), count_px, to);
        count_px -= kLanes;
        to += kLanes;
      }
      row += pitch;
    }
  }
  return changed;
}

// False where some pixel is a near-tie.
template <class Pixel, class Address, class OneWindow>
[[nodiscard]] HWY_INLINE bool draw_from(const OneWindow& window, const ProjectiveSpans& spans,
                                        const Surface& surface, const AnchoredVectors& vectors) {
  const FixedLanes<Address> fixed(surface.texture, vectors.lack_fx16());
  V32 changed = hn::Zero(D32());
  for_each_block(spans.batch, kPiece_px, [&](const RowBlock& block) HWY_ATTR {
    for (int32_t px = 0; px < block.widest_px; px += kPiece_px) {
      changed = hn::Or(changed, draw_strip<Pixel>(window, fixed, vectors, spans.batch,
                                                  surface.target, block, px));
    }
    return !any_bits(changed, ~0xFFFF);
  });
  return !any_bits(changed, ~0xFFFF);
}

// Draws a batch, if one window holds its texels and no pixel is a near-tie.
template <class Pixel, class Address>
[[nodiscard]] HWY_NOINLINE bool draw_one_window(const ProjectiveSpans& spans,
                                                const Surface& surface,
                                                const AnchoredVectors& vectors) {
  if (!pays_one_window(spans.batch)) return false;
  return with_one_window<Pixel, Address>(
      spans.texels, surface.texture, [&](const auto& window) HWY_ATTR {
        return draw_from<Pixel, Address>(window, spans, surface, vectors);
      });
}

template <class Pixel, class Address>
void draw_by_pieces(const ProjectiveSpans& spans, const Surface& surface) {
  const AnchoredVectors vectors(spans.field);
  if (draw_one_window<Pixel, Address>(spans, surface, vectors)) return;
  PieceWalk walk(spans, surface.texture);
  LeftOfPieces left;
  const bool cached = is_cached(surface.texture);
  const bool inside = cached && pays_to_ask_inside(spans.batch) &&
                      is_inside(spans.batch, spans.field, surface.texture);
  bool more = true;
  while (more) {
    if (!cached) {
      more = draw_pieces<Pixel, Address, FetchAhead<Pixel>>(surface, vectors, &walk, &left);
    } else if (inside) {
      more = draw_pieces<Pixel, Addressed<InsideVector>, FetchAtOnce<Pixel>>(surface, vectors,
                                                                             &walk, &left);
    } else {
      more = draw_pieces<Pixel, Address, FetchAtOnce<Pixel>>(surface, vectors, &walk, &left);
    }
    if (left.count != 0) {
      draw_left<Pixel, Address>(left, spans, surface, vectors.lack_fx16());
    }
  }
}

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

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
