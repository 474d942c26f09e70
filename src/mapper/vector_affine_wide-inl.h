// Affine spans, a vector of pixels of one row at a time. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_AFFINE_WIDE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_AFFINE_WIDE_INL_H
#undef SELVAGE_VECTOR_AFFINE_WIDE_INL_H
#else
#define SELVAGE_VECTOR_AFFINE_WIDE_INL_H
#endif

#include "mapper/interior.h"
#include "mapper/vector_affine_exact-inl.h"
#include "mapper/vector_affine_window_runs-inl.h"
#include "mapper/vector_affine_window_strips-inl.h"
#include "mapper/vector_batch_ties-inl.h"
#include "mapper/vector_fetch-inl.h"

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

template <class Pixel, class Address, class Ties>
HWY_NOINLINE void draw_left(const Left& left, const AffineSpans& spans, const Surface& surface,
                            int32_t window_rows, Ties* ties) {
  const AffineBatch<Address> batch(spans, surface);
  for (int32_t i = 0; i < left.count; ++i) {
    const Span& rest = left.rest[static_cast<size_t>(i)];
    if (rest.row != ties->span().row) ties->go_to(rest);
    const Lane anchor = batch.anchor(spans.field.at(rest.left_px, rest.row));
    batch.template draw<Pixel>(
        rest, surface, *ties, batch.lanes_from(anchor),
        {floor_texel(anchor.u_fx32), floor_texel(anchor.v_fx32), window_rows});
  }
}

// Whether rows have so many vectors that finding their windows together costs less.
[[nodiscard]] HWY_INLINE bool pays_to_find_runs(const SpanBatch& batch) {
  constexpr int32_t kLeast_px = 64;
  return batch.widest_px >= kLeast_px;
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

// How many vectors lie from a row on up to a place.
[[nodiscard]] HWY_INLINE int32_t vectors_between(int32_t row, const Resume& end,
                                                 const SpanBatch& batch) {
  const int32_t rows = (end.row - row) * (batch.widest_px / kLanes + 1);
  return end.px == INT32_MIN ? rows : rows + (end.px - batch.span(end.row).left_px) / kLanes;
}

// Of a small polygon, which has finer lanes than vectors, a pixel at a time costs less, too.
[[nodiscard]] HWY_INLINE bool is_small(const AffineField& field) {
  constexpr uint32_t kSmall_fx32 = 128;
  return field.margin_fx32 <= kSmall_fx32;
}

// Narrow spans without windows.
template <class Pixel, class Address, class Fetch>
struct LoadStripDraw {
  AffineBatch<Address> batch;
  Fetch* fetch;

  HWY_INLINE bool draw(const AnchoredStrip& strip, int32_t row, int32_t count_px, Pixel* to) {
    const LaneVectors lanes = batch.lanes_from(strip.u_fx16[row], strip.v_fx16[row]);
    if (batch.any_near(lanes)) return false;
    fetch->add(batch.places(lanes), count_px, reinterpret_cast<char*>(to));
    return true;
  }
};

template <class Pixel, class Address, class Fetch, class DrawLeft>
HWY_NOINLINE void draw_load_strips(const AffineSpans& spans, const Surface& surface, Left* left,
                                   const DrawLeft& draw_left) {
  Fetch fetch(surface.texture.texels);
  const LoadStripDraw<Pixel, Address, Fetch> by{AffineBatch<Address>(spans, surface), &fetch};
  const Lane first = spans.field.at(0, spans.batch.first_row);
  AnchoredStrip strip;
  draw_strips<Pixel>(by, &strip, by.batch.anchor(first), spans, surface, left, draw_left);
  fetch.finish();
}

// Narrow spans.
template <class Pixel, class Address>
void draw_by_strips(const AffineSpans& spans, const Surface& surface, const WindowShape& shape) {
  const AffineBatch<Address> lanes(spans, surface);
  BatchTies batch_ties(spans.exact, spans.batch, lanes.spare_bits());
  Left left;
  const auto draw_rest = [&](int32_t first_row, int32_t of_vectors) {
    if (are_many(left.count, of_vectors)) {
      if (has_quotients(spans)) {
        draw_exactly<Pixel, Address>(spans, surface, first_row, shape.rows);
        return false;
      }
      if (is_small(spans.field)) {
        scalar_kernels(SELVAGE_FILTER_NEAREST).draw_affine(spans, surface);
        return false;
      }
    }
    batch_ties.with_ties(
        [&](auto* ties) { draw_left<Pixel, Address>(left, spans, surface, shape.rows, ties); });
    return true;
  };
  if (!kHasWindows || shape.rows == 0) {
    if (is_cached(surface.texture)) {
      draw_load_strips<Pixel, Address, FetchAtOnce<Pixel>>(spans, surface, &left, draw_rest);
    } else {
      draw_load_strips<Pixel, Address, FetchAhead<Pixel>>(spans, surface, &left, draw_rest);
    }
    return;
  }
  const bool inside = TexelRanges(spans.texels).within(surface.texture);
  with_window_shape<Pixel>(
      surface, shape, inside,
      WindowStrips<decltype(draw_rest)>{spans, surface, inside, &left, draw_rest});
}

template <class Pixel, class Address>
void draw_wide(const AffineSpans& spans, const Surface& surface, const WindowShape& shape) {
  const bool inside =
      pays_to_ask_inside(spans.batch) && is_inside(spans.batch, spans.field, surface.texture);
  const bool ahead = shape.rows == 0 && !is_cached(surface.texture);
  const AffineBatch<Address> lanes(spans, surface);
  BatchTies batch_ties(spans.exact, spans.batch, lanes.spare_bits());
  Resume at;
  Left left;
  do {
    const int32_t first = at.row;
    if (kHasWindows && shape.rows != 0) {
      with_window_shape<Pixel>(surface, shape, inside,
                               WindowRuns{spans, surface, inside, &at, &left});
    } else if (ahead) {
      draw_loads<Pixel, Address, FetchAhead<Pixel>>(spans, surface, &at, &left);
    } else if (inside) {
      draw_loads<Pixel, Addressed<InsideVector>, FetchAtOnce<Pixel>>(spans, surface, &at, &left);
    } else {
      draw_loads<Pixel, Address, FetchAtOnce<Pixel>>(spans, surface, &at, &left);
    }
    if (are_many(left.count, vectors_between(first, at, spans.batch))) {
      if (has_quotients(spans))
        return draw_exactly<Pixel, Address>(spans, surface, first, shape.rows);
      if (is_small(spans.field)) {
        return scalar_kernels(SELVAGE_FILTER_NEAREST).draw_affine(spans, surface);
      }
    }
    if (left.count == 0) continue;
    batch_ties.with_ties(
        [&](auto* ties) { draw_left<Pixel, Address>(left, spans, surface, shape.rows, ties); });
  } while (at.row < spans.batch.rows);
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
