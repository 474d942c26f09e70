// Narrow affine spans of which one window holds all texels. Included once for each SIMD target.
//
// The window's rows are loaded once and kept in registers. Near-ties are drawn as they come and
// counted out at the end: where there is one, the batch is drawn once more, by others.
#if defined(SELVAGE_VECTOR_AFFINE_WINDOW_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_AFFINE_WINDOW_INL_H
#undef SELVAGE_VECTOR_AFFINE_WINDOW_INL_H
#else
#define SELVAGE_VECTOR_AFFINE_WINDOW_INL_H
#endif

#include "mapper/vector_affine_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// Where the texels of all pixels of a batch are; no rows where one window does not hold them.
struct Footprint {
  Origin s{}, t{};
  int32_t rows = 0;
  bool inside = false;  // the texture, so that no address mode changes a texel
};

struct TexelRange {
  int32_t first, last;

  [[nodiscard]] HWY_INLINE bool within(int32_t size_texel) const {
    return first >= 0 && last < size_texel;
  }
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
  const AffineField& field = spans.field;
  const int64_t across = int64_t{field.end_px} - 1 - field.first_px, down = spans.batch.rows - 1;
  const Lane corner = field.at(field.first_px, spans.batch.first_row);
  const TexelRange s =
      texel_range(corner.u_fx32, field.step_x.u_fx32 * across, field.step_y.u_fx32 * down);
  const TexelRange t =
      texel_range(corner.v_fx32, field.step_x.v_fx32 * across, field.step_y.v_fx32 * down);
  const int32_t rows = whole_rows(t.last - t.first + 1);
  if (s.last - s.first >= kLanes || rows > HWY_MIN(kMostWindowRows, texture.height)) return {};
  const int32_t last_column = texture.width - kLanes, last_row = texture.height - rows;
  const Footprint footprint{Address::origin(s.first, last_column, texture.width),
                            Address::origin(t.first, last_row, texture.height), rows,
                            s.within(texture.width) && t.within(texture.height)};
  return footprint.s.index <= last_column && footprint.t.index <= last_row ? footprint
                                                                           : Footprint{};
}

// So many rows of a window, in registers.
template <class Pixel, int32_t kRows>
class Window {
 public:
  HWY_INLINE Window(const Pixel* HWY_RESTRICT texels, ptrdiff_t pitch_texel) {
#pragma GCC unroll 16
    for (int32_t row = 0; row < kRows; ++row) rows_[row] = load_row(texels + row * pitch_texel);
  }

  // Texels by their index: kLanes to the row.
  [[nodiscard]] HWY_INLINE V32 pick(V32 index) const {
    V32 picked = permute(0, index);
#pragma GCC unroll 16
    for (int32_t row = kRowsPerPermute; row < kRows; row += kRowsPerPermute) {
      const V32 before = hn::Set(D32(), (row << kWindowColumnBits) - 1);
      picked = hn::IfThenElse(hn::Gt(index, before), permute(row, index), picked);
    }
    return picked;
  }

 private:
  [[nodiscard]] HWY_INLINE V32 permute(int32_t row, V32 index) const {
#if HWY_TARGET == HWY_AVX3
    return V32{_mm512_permutex2var_epi32(rows_[row].raw, index.raw, rows_[row + 1].raw)};
#elif HWY_TARGET == HWY_AVX2
    return V32{_mm256_permutevar8x32_epi32(rows_[row].raw, index.raw)};
#else
    static_cast<void>(row);
    return index;
#endif
  }

  V32 rows_[kRows];
};

// Modulo 2^64.
[[nodiscard]] HWY_INLINE Lane plus(Lane lane, int32_t steps, Lane step) {
  const auto sum = [steps](int64_t from, int64_t by) {
    return static_cast<int64_t>(static_cast<uint64_t>(from) +
                                static_cast<uint64_t>(steps) * static_cast<uint64_t>(by));
  };
  return {sum(lane.u_fx32, step.u_fx32), sum(lane.v_fx32, step.v_fx32)};
}

// False where some pixel is a near-tie.
template <class Pixel, class Address, int32_t kRows>
[[nodiscard]] HWY_INLINE bool draw_from_window(const AffineSpans& spans, const Surface& surface,
                                               const Footprint& footprint) {
  const D32 d;
  const AffineBatch<Address> batch(spans, surface);
  const ptrdiff_t pitch_texel = pitch_texel_of(surface.texture);
  const Window<Pixel, kRows> window(static_cast<const Pixel*>(surface.texture.texels) +
                                        footprint.t.index * pitch_texel + footprint.s.index,
                                    pitch_texel);
  const V32 origin = hn::Set(d, (footprint.t.texel << kWindowColumnBits) + footprint.s.texel);
  const Lane step_x = spans.field.step_x, step_y = spans.field.step_y;
  Lane at_row = batch.anchor(spans.field.at(0, spans.batch.first_row));  // where px is 0
  ptrdiff_t row_bytes = spans.batch.first_row * surface.target.pitch;
  char* const target = static_cast<char*>(surface.target.pixels);
  V32 changed = hn::Zero(d);
  for (int32_t i = 0; i < spans.batch.rows; ++i) {
    const Span span = spans.batch.span(i);
    auto* pixels = reinterpret_cast<Pixel*>(target + row_bytes) + span.left_px;
    Lane anchor = plus(at_row, span.left_px, step_x);
    int32_t count_px = span.width_px();
    do {
      const LaneVectors lanes = batch.lanes_from(anchor);
      const auto is_pixel = hn::FirstN(d, static_cast<size_t>(count_px));
      changed = hn::IfThenElse(is_pixel, hn::Or(changed, batch.changes(lanes)), changed);
      store_pixels(window.pick(batch.window_index(lanes, origin)), count_px, pixels);
      pixels += kLanes;
      count_px -= kLanes;
      anchor = plus(anchor, kLanes, step_x);
    } while (count_px > 0);
    at_row = plus(at_row, 1, step_y);
    row_bytes += surface.target.pitch;
  }
  return !any_bits(changed, ~0xFFFF);
}

// From a window of so many rows or fewer.
template <class Pixel, class Address, int32_t kRows = kMostWindowRows>
[[nodiscard]] HWY_INLINE bool draw_rows(const AffineSpans& spans, const Surface& surface,
                                        const Footprint& footprint) {
  if constexpr (kRows > kRowsPerPermute) {
    if (footprint.rows < kRows) {
      return draw_rows<Pixel, Address, kRows - kRowsPerPermute>(spans, surface, footprint);
    }
  }
  return draw_from_window<Pixel, Address, kRows>(spans, surface, footprint);
}

// Draws a batch from one window, if that can be done without deciding a near-tie.
template <class Pixel, class Address>
[[nodiscard]] HWY_NOINLINE bool draw_one_window(const AffineSpans& spans, const Surface& surface) {
  if constexpr (!kHasWindows) return false;
  const Footprint footprint = footprint_of<Address>(spans, surface.texture);
  if (footprint.rows == 0) return false;
  return footprint.inside ? draw_rows<Pixel, Addressed<WrapMaskedVector>>(spans, surface, footprint)
                          : draw_rows<Pixel, Address>(spans, surface, footprint);
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
