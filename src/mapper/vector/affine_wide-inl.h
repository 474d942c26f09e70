// Affine spans, a vector of pixels of one row at a time. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_AFFINE_WIDE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_AFFINE_WIDE_INL_H
#undef SELVAGE_VECTOR_AFFINE_WIDE_INL_H
#else
#define SELVAGE_VECTOR_AFFINE_WIDE_INL_H
#endif

#include "mapper/vector/affine_pair_runs-inl.h"
#include "mapper/vector/affine_rest-inl.h"
#include "mapper/vector/fetch-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// Calls draw(row, px, count_px, anchor) for each vector of pixels, from `at` on; false from it
// leaves the vector to others. Returns at the end, or where no more can be left. Inlined twice: one
// of them knows that the vector is whole.
template <class Address, class Draw>
HWY_INLINE void for_each_vector(const AffineSpans& spans, const AffineBatch<Address>& batch,
                                Resume* at, Left* left, const Draw& draw) {
  const AffineField field = spans.field;
  const int64_t step_u = kLanes * field.step_x.u_fx32, step_v = kLanes * field.step_x.v_fx32;
  const int32_t rows = spans.batch.rows;
  int32_t i = at->row, from_px = at->px, left_count = 0;
  for (; i < rows && left_count < Left::kMost; ++i) {
    const Span span = spans.batch.span(i);
    int32_t px = HWY_MAX(span.left_px, from_px);
    from_px = INT32_MIN;
    Lane anchor = batch.anchor(field.at(px, span.row));
    for (int32_t count_px = span.right_px - px; count_px > 0; count_px -= kLanes) {
      const bool drawn = HWY_LIKELY(count_px >= kLanes) ? draw(span.row, px, kLanes, anchor)
                                                        : draw(span.row, px, count_px, anchor);
      if (HWY_UNLIKELY(!drawn)) {
        left->rest[static_cast<size_t>(left_count++)] = {span.row, px, span.right_px};
        if (left_count == Left::kMost) {
          from_px = px + kLanes;
          --i;
          break;
        }
      }
      px += kLanes;
      anchor.u_fx32 += step_u;
      anchor.v_fx32 += step_v;
    }
  }
  left->count = left_count;
  *at = {i, from_px};
}

// A load for each pixel of a vector of them.
template <class Pixel, class Address, class Fetch>
HWY_NOINLINE void draw_loads(const AffineSpans& spans, const Surface& surface, Resume* at,
                             Left* left) {
  const AffineBatch<Address> batch(spans, surface);
  Fetch fetch(surface.texture.texels);
  char* const pixels = static_cast<char*>(surface.target.pixels);
  const ptrdiff_t pitch = surface.target.pitch;
  for_each_vector(
      spans, batch, at, left,
      [&](int32_t row, int32_t px, int32_t count_px, Lane anchor) HWY_ATTR
      __attribute__((always_inline)) {
        const LaneVectors lanes = batch.lanes_from(anchor);
        if (batch.any_near(lanes)) return false;
        fetch.add(batch.places(lanes), count_px,
                  pixels + row * pitch + px * ptrdiff_t{sizeof(Pixel)});
        return true;
      });
  fetch.finish();
}

// How many vectors lie from a row on up to a place, which is in one row or in a pair of them.
[[nodiscard]] HWY_INLINE int32_t vectors_between(int32_t row, const Resume& end, bool in_pair,
                                                 const SpanBatch& batch) {
  const int32_t rows = (end.row - row) * (batch.widest_px / kLanes + 1);
  if (end.px == INT32_MIN) return rows;
  const Span first = batch.span(end.row);
  if (!in_pair) return rows + (end.px - first.left_px) / kLanes;
  return rows + 2 * (end.px - around(first, batch.span(end.row + 1)).left_px) / kLanes;
}

template <class Pixel, class Address>
void draw_wide(const AffineSpans& spans, const Surface& surface, const WindowShape& shape,
               const WindowShape& of_pairs, bool inside, RestDraw* rest) {
  const bool ahead = shape.rows == 0 && !is_cached(surface.texture);
  Resume at;
  Left left;
  do {
    const int32_t first = at.row;
    const bool in_pairs = kHasPairs && of_pairs.rows != 0 && first + 1 < spans.batch.rows;
    if (in_pairs) {
      if constexpr (kHasPairs) {
        with_pair_shape<Pixel>(of_pairs, PairRuns{spans, surface, &at, &left});
      }
    } else if (kHasWindows && shape.rows != 0) {
      with_window_shape<Pixel>(surface, shape, inside,
                               WindowRuns{spans, surface, inside, &at, &left});
    } else if (ahead) {
      draw_loads<Pixel, Address, FetchAhead<Pixel>>(spans, surface, &at, &left);
    } else if (inside) {
      draw_loads<Pixel, Addressed<InsideVector>, FetchAtOnce<Pixel>>(spans, surface, &at, &left);
    } else {
      draw_loads<Pixel, Address, FetchAtOnce<Pixel>>(spans, surface, &at, &left);
    }
    const int32_t vectors = vectors_between(first, at, in_pairs, spans.batch);
    if (left.count != 0 && !rest->draw(left, first, vectors)) return;
  } while (at.row < spans.batch.rows);
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
