// Affine spans, a vector of pixels of one row at a time. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_AFFINE_WIDE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_AFFINE_WIDE_INL_H
#undef SELVAGE_VECTOR_AFFINE_WIDE_INL_H
#else
#define SELVAGE_VECTOR_AFFINE_WIDE_INL_H
#endif

#include "mapper/vector_affine_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// Where a hot loop goes on: in this row of the batch, not before this pixel.
struct Resume {
  int32_t row = 0, px = INT32_MIN;
};

// Calls draw(row, px, count_px, anchor) for each vector of pixels, from `at` on; false from it
// leaves the vector to others. Returns at the end, or where no more can be left.
template <class Draw>
HWY_INLINE void for_each_vector(const AffineSpans& spans, Lane to_anchor, Resume* at, Left* left,
                                const Draw& draw) {
  const AffineField field = spans.field;
  const int64_t step_u = kLanes * field.step_x.u_fx32, step_v = kLanes * field.step_x.v_fx32;
  const int32_t rows = spans.batch.rows;
  int32_t i = at->row, from_px = at->px, left_count = 0;
  for (; i < rows && left_count < Left::kMost; ++i) {
    const Span span = spans.batch.span(i);
    int32_t px = HWY_MAX(span.left_px, from_px);
    from_px = INT32_MIN;
    const Lane first = field.at(px, span.row);
    int64_t u = first.u_fx32 + to_anchor.u_fx32, v = first.v_fx32 + to_anchor.v_fx32;
    for (int32_t count_px = span.right_px - px; count_px > 0; count_px -= kLanes) {
      if (HWY_UNLIKELY(!draw(span.row, px, count_px, Lane{u, v}))) {
        left->rest[static_cast<size_t>(left_count++)] = {span.row, px, span.right_px};
        if (left_count == Left::kMost) {
          from_px = px + kLanes;
          --i;
          break;
        }
      }
      px += kLanes;
      u += step_u;
      v += step_v;
    }
  }
  left->count = left_count;
  *at = {i, from_px};
}

[[nodiscard]] HWY_INLINE int32_t floor_texel(int64_t lane_fx32) {
  return static_cast<int32_t>(lane_fx32 >> kLaneFraction);
}

template <class Pixel, class Address>
HWY_NOINLINE void draw_left(const Left& left, const AffineSpans& spans, const Surface& surface,
                            int32_t window_rows) {
  const AffineBatch<Address> batch(spans, surface);
  RowOfTies ties(spans.exact, left.rest[0], 0, batch.spare_bits());
  for (int32_t i = 0; i < left.count; ++i) {
    const Span& rest = left.rest[static_cast<size_t>(i)];
    if (rest.row != ties.span().row) ties.go_to(rest);
    const Lane anchor = batch.anchor(spans.field.at(rest.left_px, rest.row));
    batch.template draw<Pixel>(
        rest, surface, ties, batch.lanes_from(anchor),
        {floor_texel(anchor.u_fx32), floor_texel(anchor.v_fx32), window_rows});
  }
}

// Texels from windows of so many rows, but for what does not lie in one.
template <class Pixel, class Address>
HWY_NOINLINE void draw_windows(const AffineSpans& spans, const Surface& surface, int32_t rows,
                               Resume* at, Left* left) {
  const AffineBatch<Address> batch(spans, surface);
  const Extent extent = extent_of(surface.texture);
  const auto* const texels = static_cast<const Pixel*>(surface.texture.texels);
  const int32_t last_column = extent.width_texel - kLanes, last_row = extent.height_texel - rows;
  char* const pixels = static_cast<char*>(surface.target.pixels);
  const ptrdiff_t pitch = surface.target.pitch;
  for_each_vector(
      spans, batch.to_anchor(), at, left,
      [&](int32_t row, int32_t px, int32_t count_px, Lane anchor) HWY_ATTR {
        const LaneVectors lanes = batch.lanes_from(anchor);
        const Origin s =
            Address::origin(floor_texel(anchor.u_fx32), last_column, extent.width_texel);
        const Origin t = Address::origin(floor_texel(anchor.v_fx32), last_row, extent.height_texel);
        if (batch.any_near(lanes) || s.index > last_column || t.index > last_row) return false;
        const V32 index =
            batch.window_index(lanes, hn::Set(D32(), (t.texel << kWindowColumnBits) + s.texel));
        const Pixel* const window = texels + t.index * ptrdiff_t{extent.pitch_texel} + s.index;
        store_pixels(pick(window, extent.pitch_texel, rows, index), count_px,
                     reinterpret_cast<Pixel*>(pixels + row * pitch) + px);
        return true;
      });
}

// Where the texels of all pixels of a batch are; no rows where one window does not hold them.
struct Footprint {
  Origin s{}, t{};
  int32_t rows = 0;
};

struct TexelRange {
  int32_t first, last;
};

// Of what a coordinate is at a corner, and what it changes by to the right end and to the lower
// one.
[[nodiscard]] HWY_INLINE TexelRange texel_range(int64_t corner_fx32, int64_t right, int64_t down) {
  return {floor_texel(corner_fx32 + HWY_MIN(right, 0) + HWY_MIN(down, 0)),
          floor_texel(corner_fx32 + HWY_MAX(right, 0) + HWY_MAX(down, 0))};
}

// Steps to the right are at most a texel.
template <class Address>
[[nodiscard]] HWY_INLINE Footprint footprint_of(const AffineSpans& spans,
                                                const selvage_texture& texture) {
  int32_t left_px = INT32_MAX, right_px = INT32_MIN;
  for (int32_t i = 0; i < spans.batch.rows; ++i) {
    const Span span = spans.batch.span(i);
    left_px = HWY_MIN(left_px, span.left_px);
    right_px = HWY_MAX(right_px, span.right_px);
  }
  const int64_t across = int64_t{right_px} - left_px, down = spans.batch.rows - 1;
  const AffineField& field = spans.field;
  const Lane corner = field.at(left_px, spans.batch.first_row);
  const TexelRange s =
      texel_range(corner.u_fx32, field.step_x.u_fx32 * across, field.step_y.u_fx32 * down);
  const TexelRange t =
      texel_range(corner.v_fx32, field.step_x.v_fx32 * across, field.step_y.v_fx32 * down);
  const int32_t rows = whole_rows(t.last - t.first + 1);
  if (s.last - s.first >= kLanes || rows > HWY_MIN(kMostWindowRows, texture.height)) return {};
  const int32_t last_column = texture.width - kLanes, last_row = texture.height - rows;
  const Footprint footprint{Address::origin(s.first, last_column, texture.width),
                            Address::origin(t.first, last_row, texture.height), rows};
  return footprint.s.index <= last_column && footprint.t.index <= last_row ? footprint
                                                                           : Footprint{};
}

// All texels of a batch from one window, whose least texel is `least`.
template <class Pixel, class Address>
HWY_NOINLINE void draw_one_window(const AffineSpans& spans, const Surface& surface,
                                  const Footprint& footprint, Resume* at, Left* left) {
  const AffineBatch<Address> batch(spans, surface);
  const Extent extent = extent_of(surface.texture);
  const V32 origin = hn::Set(D32(), (footprint.t.texel << kWindowColumnBits) + footprint.s.texel);
  const Pixel* const window = static_cast<const Pixel*>(surface.texture.texels) +
                              footprint.t.index * ptrdiff_t{extent.pitch_texel} + footprint.s.index;
  char* const pixels = static_cast<char*>(surface.target.pixels);
  const ptrdiff_t pitch = surface.target.pitch;
  for_each_vector(spans, batch.to_anchor(), at, left,
                  [&](int32_t row, int32_t px, int32_t count_px, Lane anchor) HWY_ATTR {
                    const LaneVectors lanes = batch.lanes_from(anchor);
                    if (batch.any_near(lanes)) return false;
                    store_pixels(pick(window, extent.pitch_texel, footprint.rows,
                                      batch.window_index(lanes, origin)),
                                 count_px, reinterpret_cast<Pixel*>(pixels + row * pitch) + px);
                    return true;
                  });
}

// A load for each pixel of a vector of them.
template <class Pixel, class Address>
HWY_NOINLINE void draw_loads(const AffineSpans& spans, const Surface& surface, Resume* at,
                             Left* left) {
  const AffineBatch<Address> batch(spans, surface);
  const void* const texels = surface.texture.texels;
  char* const pixels = static_cast<char*>(surface.target.pixels);
  const ptrdiff_t pitch = surface.target.pitch;
  for_each_vector(spans, batch.to_anchor(), at, left,
                  [&](int32_t row, int32_t px, int32_t count_px, Lane anchor) HWY_ATTR {
                    const LaneVectors lanes = batch.lanes_from(anchor);
                    if (batch.any_near(lanes)) return false;
                    HWY_ALIGN int32_t place[kLanes];
                    hn::Store(batch.places(lanes), D32(), place);
                    fetch_vector<Pixel>(texels, place, count_px,
                                        pixels + row * pitch + px * ptrdiff_t{sizeof(Pixel)});
                    return true;
                  });
}

// By windows of so many rows, or, where there are none, by loads.
template <class Pixel, class Address>
void draw_wide(const AffineSpans& spans, const Surface& surface, int32_t rows) {
  Footprint footprint;
  if (rows != 0 && spans.batch.widest_px <= kNarrow_px) {
    footprint = footprint_of<Address>(spans, surface.texture);
  }
  Resume at;
  Left left;
  do {
    if (kHasWindows && footprint.rows != 0) {
      draw_one_window<Pixel, Address>(spans, surface, footprint, &at, &left);
    } else if (kHasWindows && rows != 0) {
      draw_windows<Pixel, Address>(spans, surface, rows, &at, &left);
    } else {
      draw_loads<Pixel, Address>(spans, surface, &at, &left);
    }
    if (left.count != 0) draw_left<Pixel, Address>(left, spans, surface, rows);
  } while (left.count == Left::kMost);
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
