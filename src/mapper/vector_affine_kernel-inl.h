// Affine spans by vectors. Included once for each SIMD target.
//
// Lanes are 16.16 (fx16), 32 bits wide: an anchor, the floor of the 32.32 lane of a vector's first
// pixel, and the floors of the steps from there. So
//
//     lane <= true value < lane + kVectorTruncations_fx16 + margin     (spec/proofs/vector_lanes.g)
//
// modulo 2^32, and a lane whose fraction is not within so much of 1 shows the texel.
#if defined(SELVAGE_VECTOR_AFFINE_KERNEL_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_AFFINE_KERNEL_INL_H
#undef SELVAGE_VECTOR_AFFINE_KERNEL_INL_H
#else
#define SELVAGE_VECTOR_AFFINE_KERNEL_INL_H
#endif

#include <algorithm>

#include "mapper/vector_kernel-inl.h"
#include "mapper/vector_window-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

inline constexpr int kAnchorShift = kLaneFraction - kTexelFraction;

[[nodiscard]] HWY_INLINE int32_t floor_fx16(int64_t lane_fx32) {
  return static_cast<int32_t>(lane_fx32 >> kAnchorShift);
}

// The lane of a vector that has the least value, and from which the others are counted.
[[nodiscard]] HWY_INLINE int32_t anchor_lane(int64_t step_fx32) {
  return step_fx32 < 0 ? kLanes - 1 : 0;
}

// floor(i step) for lane i counted from the anchor: whole units, and what the fraction adds.
[[nodiscard]] HWY_INLINE V32 offsets_fx16(int64_t step_fx32) {
  const D32 d;
  const V32 i = hn::Abs(hn::Sub(hn::Iota(d, 0), hn::Set(d, anchor_lane(step_fx32))));
  const int64_t rise_fx32 = step_fx32 < 0 ? -step_fx32 : step_fx32;
  const V32 whole = hn::Mul(i, hn::Set(d, floor_fx16(rise_fx32)));
  const V32 fraction = hn::Mul(i, hn::Set(d, static_cast<int32_t>(rise_fx32 & 0xFFFF)));
  return hn::Add(whole, hn::ShiftRight<kAnchorShift>(fraction));
}

// kLanes lanes of both coordinates.
struct LaneVectors {
  V32 u, v;
};

template <class Address>
class AffineBatch {
 public:
  HWY_INLINE AffineBatch(const AffineSpans& spans, const Surface& surface)
      : exact_(spans.exact),
        extent_(extent_of(surface.texture)),
        lack_fx16_(kVectorTruncations_fx16 +
                   static_cast<int32_t>(spans.field.margin_fx32 >> kAnchorShift) + 1),
        to_anchor_{anchor_lane(spans.field.step_x.u_fx32) * spans.field.step_x.u_fx32,
                   anchor_lane(spans.field.step_x.v_fx32) * spans.field.step_x.v_fx32},
        offset_u_(offsets_fx16(spans.field.step_x.u_fx32)),
        offset_v_(offsets_fx16(spans.field.step_x.v_fx32)) {}

  // From the 32.32 lane of a vector's first pixel to the least one.
  [[nodiscard]] HWY_INLINE Lane to_anchor() const { return to_anchor_; }
  HWY_INLINE Lane anchor(Lane first) const {
    return {first.u_fx32 + to_anchor_.u_fx32, first.v_fx32 + to_anchor_.v_fx32};
  }
  HWY_INLINE LaneVectors lanes_from(Lane anchor) const {
    const D32 d;
    return {hn::Add(hn::Set(d, floor_fx16(anchor.u_fx32)), offset_u_),
            hn::Add(hn::Set(d, floor_fx16(anchor.v_fx32)), offset_v_)};
  }

  // Places in the texture, in texels from its first; those of lanes that mean nothing are valid
  // too.
  HWY_INLINE V32 places(const LaneVectors& lanes) const {
    return places_of(texel_of(lanes.u), texel_of(lanes.v));
  }

  // Texels by their distance from the origin of a window, which is given as such an index.
  HWY_INLINE V32 window_index(const LaneVectors& lanes, int32_t origin) const {
    const V32 s = Address::window_texel(texel_of(lanes.u), extent_.width_texel);
    const V32 t = Address::window_texel(texel_of(lanes.v), extent_.height_texel);
    return hn::Sub(hn::Add(hn::ShiftLeft<kWindowColumnBits>(t), s), hn::Set(D32(), origin));
  }

  // Whether adding all that a lane may lack changes some texel.
  [[nodiscard]] HWY_INLINE bool any_near(const LaneVectors& lanes) const {
    return any_bits(hn::Or(change(lanes.u), change(lanes.v)), ~0xFFFF);
  }
  [[nodiscard]] HWY_INLINE uint32_t near_bits(V32 lane_fx16) const {
    return lane_bits(D32(), is_changed(change(lane_fx16)));
  }

  // The places of pixels that follow each other in a row, near-ties and all, where asked for.
  HWY_NOINLINE V32 decided_places(int32_t px, int32_t row, const LaneVectors& lanes,
                                  uint32_t asked) const {
    const D32 d;
    const uint32_t near_u = near_bits(lanes.u) & asked, near_v = near_bits(lanes.v) & asked;
    const ExactRow exact = exact_.row_from(px, row);
    return places_of(decide(d, texel_of(lanes.u), near_u, exact, exact.u),
                     decide(d, texel_of(lanes.v), near_v, exact, exact.v));
  }

  // The place of one pixel, near-ties or not.
  [[nodiscard]] int32_t decided_place(int32_t px, int32_t row, int32_t u_fx16,
                                      int32_t v_fx16) const {
    const ExactRow exact = exact_.row_from(px, row);
    const auto texel = [&](const ExactLine& coordinate, int32_t lane_fx16) {
      const int32_t low = lane_fx16 >> kTexelFraction;
      return (lane_fx16 & 0xFFFF) + lack_fx16_ > 0xFFFF && exact.reaches(coordinate, 0, low + 1)
                 ? low + 1
                 : low;
    };
    return Address::place_of_one(texel(exact.u, u_fx16), texel(exact.v, v_fx16), extent_);
  }

 private:
  static HWY_INLINE V32 texel_of(V32 lane_fx16) {
    return hn::ShiftRight<kTexelFraction>(lane_fx16);
  }
  HWY_INLINE V32 change(V32 lane_fx16) const {
    return hn::Xor(hn::Add(lane_fx16, hn::Set(D32(), lack_fx16_)), lane_fx16);
  }
  static HWY_INLINE hn::Mask<D32> is_changed(V32 change) {
    return hn::Ne(texel_of(change), hn::Zero(D32()));
  }
  HWY_INLINE V32 places_of(V32 s, V32 t) const { return Address::place(s, t, extent_); }

  const ExactMap& exact_;
  Extent extent_;
  int32_t lack_fx16_;
  Lane to_anchor_;
  V32 offset_u_, offset_v_;
};

// Vectors of pixels that a hot loop leaves to others, so that it has no calls and keeps all it needs
// in registers: what is left of their span from there on.
struct Left {
  static constexpr int32_t kMost = 64;
  int32_t count = 0;
  Span rest[kMost];
};

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
        left->rest[left_count++] = {span.row, px, span.right_px};
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

// A load for each pixel, near-ties and all.
template <class Pixel, class Address>
HWY_NOINLINE void draw_left(const Left& left, const AffineSpans& spans, const Surface& surface) {
  const AffineBatch<Address> batch(spans, surface);
  HWY_ALIGN int32_t place[kLanes];
  for (int32_t i = 0; i < left.count; ++i) {
    const Span& rest = left.rest[i];
    const int32_t count = HWY_MIN(rest.width_px(), kLanes);
    const LaneVectors lanes =
        batch.lanes_from(batch.anchor(spans.field.at(rest.left_px, rest.row)));
    hn::Store(batch.decided_places(rest.left_px, rest.row, lanes, first_bits(count)), D32(), place);
    fetch_as<Pixel>(surface.texture.texels, place, count, first_pixel(surface, rest));
  }
}

[[nodiscard]] HWY_INLINE int32_t floor_texel(int64_t lane_fx32) {
  return static_cast<int32_t>(lane_fx32 >> kLaneFraction);
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
        const V32 index = batch.window_index(lanes, (t.texel << kWindowColumnBits) + s.texel);
        const Pixel* const window = texels + t.index * ptrdiff_t{extent.pitch_texel} + s.index;
        store_pixels(pick(window, extent.pitch_texel, rows, index), count_px,
                     reinterpret_cast<Pixel*>(pixels + row * pitch) + px);
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
                    if (batch.any_near(lanes) || count_px < kLanes) return false;
                    HWY_ALIGN int32_t place[kLanes];
                    hn::Store(batch.places(lanes), D32(), place);
                    fetch_as<Pixel, kLanes>(texels, place,
                                            pixels + row * pitch + px * ptrdiff_t{sizeof(Pixel)});
                    return true;
                  });
}

// By windows of so many rows, or, where there are none, by loads.
template <class Pixel, class Address>
void draw_wide(const AffineSpans& spans, const Surface& surface, int32_t rows) {
  Resume at;
  Left left;
  do {
    if (kHasWindows && rows != 0) {
      draw_windows<Pixel, Address>(spans, surface, rows, &at, &left);
    } else {
      draw_loads<Pixel, Address>(spans, surface, &at, &left);
    }
    if (left.count != 0) draw_left<Pixel, Address>(left, spans, surface);
  } while (left.count == Left::kMost);
}

// Near-ties among packed pixels [first, first + kLanes): finds each one's row by the widths.
template <class Address>
HWY_NOINLINE void decide_packed(const AffineBatch<Address>& batch, const SpanBatch& rows,
                                const LaneVectors& lanes, int32_t first, int32_t* place) {
  HWY_ALIGN int32_t u_fx16[kLanes], v_fx16[kLanes];
  hn::Store(lanes.u, D32(), u_fx16);
  hn::Store(lanes.v, D32(), v_fx16);
  const uint32_t near = batch.near_bits(lanes.u) | batch.near_bits(lanes.v);
  int32_t row = 0, row_first = 0;
  for (int32_t i = 0; near >> i != 0; ++i) {
    if ((near >> i & 1U) == 0) continue;
    while (row < rows.rows && first + i >= row_first + rows.span(row).width_px()) {
      row_first += rows.span(row++).width_px();
    }
    if (row == rows.rows) break;  // beyond the last pixel
    const Span span = rows.span(row);
    place[i] =
        batch.decided_place(span.left_px + first + i - row_first, span.row, u_fx16[i], v_fx16[i]);
  }
}

template <class Pixel>
HWY_INLINE void store_rows(const Pixel* texels, const SpanBatch& batch, const Surface& surface) {
  for (int32_t i = 0; i < batch.rows; ++i) {
    const Span span = batch.span(i);
    store_row<Pixel>(texels, span.width_px(), first_pixel(surface, span));
    texels += span.width_px();
  }
}

// Spans up to kNarrow_px wide: the lanes of all are packed one after another, so that vectors are
// full although rows are short; each row is stored under a mask.
template <class Address>
void draw_narrow(const AffineSpans& spans, const Surface& surface) {
  constexpr int32_t kMost = kRowsPerBatch * kNarrow_px;
  const AffineBatch<Address> batch(spans, surface);
  const AffineField field = spans.field;
  const D32 d;
  HWY_ALIGN int32_t u_fx16[kMost + kMostLanes], v_fx16[kMost + kMostLanes];
  int32_t packed = 0;
  for (int32_t i = 0; i < spans.batch.rows; ++i) {
    const Span span = spans.batch.span(i);
    int32_t done = 0;
    do {
      const LaneVectors lanes = batch.lanes_from(batch.anchor(field.at(span.left_px + done, span.row)));
      hn::StoreU(lanes.u, d, u_fx16 + packed + done);
      hn::StoreU(lanes.v, d, v_fx16 + packed + done);
      done += kLanes;
    } while (done < span.width_px());
    packed += span.width_px();
  }
  hn::StoreU(hn::Zero(d), d, u_fx16 + packed);
  hn::StoreU(hn::Zero(d), d, v_fx16 + packed);

  HWY_ALIGN int32_t place[kLanes];
  HWY_ALIGN char texels[(kMost + kMostLanes) * sizeof(uint32_t)];
  const ptrdiff_t bytes = bytes_per_pixel(surface.target.format);
  for (int32_t first = 0; first < packed; first += kLanes) {
    const LaneVectors lanes{hn::Load(d, u_fx16 + first), hn::Load(d, v_fx16 + first)};
    hn::Store(batch.places(lanes), d, place);
    if (HWY_UNLIKELY(batch.any_near(lanes))) {
      decide_packed(batch, spans.batch, lanes, first, place);
    }
    fetch(surface.texture, place, kLanes, texels + first * bytes);
  }
  with_pixel(surface.target.format, [&](auto pixel) {
    store_rows(reinterpret_cast<const decltype(pixel)*>(texels), spans.batch, surface);
  });
}

void draw_affine(const AffineSpans& spans, const Surface& surface) {
  const int32_t rows = window_rows(spans.field.step_x, surface.texture);
  const bool narrow = spans.batch.widest_px <= kNarrow_px;
  with_address(surface, [&](auto address) {
    using Address = decltype(address);
    if (rows == 0 && narrow) return draw_narrow<Address>(spans, surface);
    with_pixel(surface.target.format,
               [&](auto pixel) { draw_wide<decltype(pixel), Address>(spans, surface, rows); });
  });
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
