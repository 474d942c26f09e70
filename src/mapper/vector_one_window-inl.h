// A window that holds all texels of a polygon. Included once for each SIMD target.
//
// Its rows are loaded once a batch and kept in registers. Near-ties are drawn as they come and
// counted out at the end: where there is one, the batch is drawn once more, by others.
#if defined(SELVAGE_VECTOR_ONE_WINDOW_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_ONE_WINDOW_INL_H
#undef SELVAGE_VECTOR_ONE_WINDOW_INL_H
#else
#define SELVAGE_VECTOR_ONE_WINDOW_INL_H
#endif

#include "mapper/vector_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// The texels of one coordinate, both of them included.
struct TexelRange {
  int32_t first, last;

  [[nodiscard]] HWY_INLINE int32_t count() const { return last - first + 1; }
  [[nodiscard]] HWY_INLINE bool within(int32_t size_texel) const {
    return first >= 0 && last < size_texel;
  }
};

// Where a window is; no rows where none holds all.
struct WindowPlace {
  Origin s{}, t{};
  int32_t rows = 0;
  bool inside = false;  // the texture, so that no address mode changes a texel
};

template <class Address>
[[nodiscard]] HWY_INLINE WindowPlace place_of(const TexelBox& box, const selvage_texture& texture) {
  const TexelRange s{box.least_u_fx16 >> kTexelFraction, box.most_u_fx16 >> kTexelFraction};
  const TexelRange t{box.least_v_fx16 >> kTexelFraction, box.most_v_fx16 >> kTexelFraction};
  if (texture.layout != SELVAGE_LAYOUT_ROWS || texture.width < kLanes || s.count() > kLanes ||
      t.count() > HWY_MIN(kMostWindowRows, texture.height)) {
    return {};
  }
  const int32_t rows = whole_rows(t.count());
  const int32_t last_column = texture.width - kLanes, last_row = texture.height - rows;
  if (last_row < 0) return {};
  const WindowPlace place{Address::origin(s.first, last_column, texture.width),
                          Address::origin(t.first, last_row, texture.height), rows,
                          s.within(texture.width) && t.within(texture.height)};
  return place.s.index <= last_column && place.t.index <= last_row ? place : WindowPlace{};
}

template <class Pixel, class Address, int32_t kRows>
class Window {
 public:
  HWY_INLINE Window(const selvage_texture& texture, const WindowPlace& place)
      : origin_(hn::Set(D32(), (place.t.texel << kWindowColumnBits) + place.s.texel)),
        width_texel_(texture.width),
        height_texel_(texture.height) {
    const ptrdiff_t pitch_texel = pitch_texel_of(texture);
    const Pixel* const texels =
        static_cast<const Pixel*>(texture.texels) + place.t.index * pitch_texel + place.s.index;
#pragma GCC unroll 16
    for (int32_t row = 0; row < kRows; ++row) rows_[row] = load_row(texels + row * pitch_texel);
  }

  [[nodiscard]] HWY_INLINE V32 texels(const LaneVectors& lanes) const {
    const V32 s = Address::window_texel(hn::ShiftRight<kTexelFraction>(lanes.u), width_texel_);
    const V32 t = Address::window_texel(hn::ShiftRight<kTexelFraction>(lanes.v), height_texel_);
    const V32 index = hn::Sub(hn::Add(hn::ShiftLeft<kWindowColumnBits>(t), s), origin_);
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
  V32 origin_;
  int32_t width_texel_, height_texel_;
};

// Calls draw(window) with a window of so many rows, or of fewer.
template <class Pixel, class Address, int32_t kRows = kMostWindowRows, class Draw>
[[nodiscard]] HWY_INLINE bool with_window(const selvage_texture& texture, const WindowPlace& place,
                                          const Draw& draw) {
  if constexpr (kRows > kRowsPerPermute) {
    if (place.rows < kRows) {
      return with_window<Pixel, Address, kRows - kRowsPerPermute>(texture, place, draw);
    }
  }
  return draw(Window<Pixel, Address, kRows>(texture, place));
}

// What draw(window) returns, or false where there is no such window.
template <class Pixel, class Address, class Draw>
[[nodiscard]] HWY_INLINE bool with_one_window(const TexelBox& box, const selvage_texture& texture,
                                              const Draw& draw) {
  if constexpr (!kHasWindows) return false;
  const WindowPlace place = place_of<Address>(box, texture);
  if (place.rows == 0) return false;
  using Inside = Addressed<WrapMaskedVector>;
  return place.inside ? with_window<Pixel, Inside>(texture, place, draw)
                      : with_window<Pixel, Address>(texture, place, draw);
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
