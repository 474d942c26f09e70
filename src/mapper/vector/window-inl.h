// Texels by permuting a few rows of the texture. Included once for each SIMD target.
//
// Where neighbouring pixels are at most a texel apart along u, the texels of a vector of pixels lie
// in a window of as many columns as there are lanes, and of a few rows: loaded row by row, and
// picked by permutes, they cost less than a load each.
#if defined(SELVAGE_VECTOR_WINDOW_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_WINDOW_INL_H
#undef SELVAGE_VECTOR_WINDOW_INL_H
#else
#define SELVAGE_VECTOR_WINDOW_INL_H
#endif

#include "mapper/vector/kernel-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

#if HWY_TARGET == HWY_AVX3
inline constexpr bool kHasWindows = true;
inline constexpr int32_t kRowsPerPermute = 2;
inline constexpr int32_t kMostWindowRows = 10;  // more were measured to cost more than loads
#else
inline constexpr bool kHasWindows = HWY_TARGET == HWY_AVX2;
inline constexpr int32_t kRowsPerPermute = 1;
inline constexpr int32_t kMostWindowRows = 3;  // the same, where no AVX-512 is
#endif
// A window's columns are a power of two: as many as there are lanes, or half as many, two rows to
// the vector.
inline constexpr int kWindowColumnBits = kLanes == 16 ? 4 : 3;
inline constexpr int kHalfColumnBits = kWindowColumnBits - 1;
static_assert(!kHasWindows || 1 << kWindowColumnBits == kLanes);
template <int kColumnBits>
inline constexpr int32_t kColumns = 1 << kColumnBits;
template <int kColumnBits>
inline constexpr int32_t kRowsPerVector = kLanes >> kColumnBits;

// The rows of a window of half as many columns: one permute takes them.
inline constexpr int32_t kHalfWindowRows = kRowsPerPermute * kRowsPerVector<kHalfColumnBits>;

[[nodiscard]] HWY_INLINE int32_t whole_rows(int32_t rows) {
  return (rows + kRowsPerPermute - 1) / kRowsPerPermute * kRowsPerPermute;
}

template <class V>
[[nodiscard]] HWY_INLINE V whole_rows(V rows) {
  const hn::DFromV<V> d;
  constexpr int32_t kMore = kRowsPerPermute - 1;
  static_assert((kRowsPerPermute & kMore) == 0);
  return hn::And(hn::Add(rows, hn::Set(d, kMore)), hn::Set(d, ~kMore));
}

// How large the windows of vectors are; no rows where there is none.
struct WindowShape {
  int32_t column_bits, rows;

  [[nodiscard]] constexpr bool is_half() const { return column_bits == kHalfColumnBits; }
};

[[nodiscard]] HWY_INLINE bool may_have_windows(const selvage_texture& texture) {
  return kHasWindows && texture.layout == SELVAGE_LAYOUT_ROWS && texture.width >= kLanes;
}

[[nodiscard]] HWY_INLINE int64_t magnitude_fx32(int64_t step_fx32) {
  return step_fx32 < 0 ? -step_fx32 : step_fx32;
}

// How far apart the texels of pixels so many steps apart are, or so far that no window holds them.
[[nodiscard]] HWY_INLINE int64_t reach_fx32(int32_t steps, int64_t step_fx32) {
  constexpr int64_t kMostStep_fx32 = int64_t{kLanes} << kLaneFraction;
  return steps * HWY_MIN(magnitude_fx32(step_fx32), kMostStep_fx32);
}

// In how many columns or rows texels lie that are no further apart: n rounded up, plus one.
[[nodiscard]] HWY_INLINE int32_t texels_across(int64_t reach_fx32) {
  constexpr int64_t kOne = int64_t{1} << kLaneFraction;
  return static_cast<int32_t>((reach_fx32 + kOne - 1) >> kLaneFraction) + 1;
}

// The smallest one that holds so many columns and rows.
template <int32_t kMostRows = kMostWindowRows>
[[nodiscard]] HWY_INLINE WindowShape shape_that_holds(int32_t columns, int32_t rows,
                                                      const selvage_texture& texture) {
  const int32_t whole = whole_rows(rows);
  if (!may_have_windows(texture) || columns > kColumns<kWindowColumnBits> ||
      whole > HWY_MIN(kMostRows, texture.height)) {
    return {kWindowColumnBits, 0};
  }
  const bool is_half = whole == kHalfWindowRows && columns <= kColumns<kHalfColumnBits>;
  return {is_half ? kHalfColumnBits : kWindowColumnBits, whole};
}

// Of a vector of pixels, whose steps are given.
[[nodiscard]] HWY_INLINE WindowShape window_shape(Lane step_fx32, const selvage_texture& texture) {
  const auto texels = [](int64_t by_fx32) {
    return texels_across(reach_fx32(kLanes - 1, by_fx32));
  };
  return shape_that_holds(texels(step_fx32.u_fx32), texels(step_fx32.v_fx32), texture);
}

// Rows of the window of a vector of pixels, kLanes columns wide; 0 where there is none.
[[nodiscard]] HWY_INLINE int32_t window_rows(Lane step_fx32, const selvage_texture& texture) {
  return window_shape(step_fx32, texture).rows;
}

// Places are negative, too, where a texture is stored bottom row first; none is so low
// (places_fit).
inline constexpr int32_t kNoPlace = INT32_MIN;

// Where windows begin: at these texels, and their places in the texture, kNoPlace where a window
// does not lie in it.
template <class V>
struct WindowOrigins {
  V s, t, place;
};

// Of some windows, by their least texels, columns and rows.
template <class Address, class V>
[[nodiscard]] HWY_INLINE WindowOrigins<V> window_origins(V s, V t, V columns, V rows,
                                                         const Extent& extent) {
  const hn::DFromV<V> d;
  const V last_s = hn::Sub(hn::Set(d, extent.width_texel), columns);
  const V last_t = hn::Sub(hn::Set(d, extent.height_texel), rows);
  const auto column = Address::origins(s, last_s, extent.width_texel);
  const auto row = Address::origins(t, last_t, extent.height_texel);
  const auto outside = hn::Or(hn::Gt(column.index, last_s), hn::Gt(row.index, last_t));
  const V place = hn::Add(hn::Mul(row.index, hn::Set(d, extent.pitch_texel)), column.index);
  return {column.texel, row.texel, hn::IfThenElse(outside, hn::Set(d, kNoPlace), place)};
}

template <class D, class Pixel>
HWY_INLINE hn::Vec<D> load_row(const Pixel* texels) {
  if constexpr (sizeof(Pixel) == sizeof(int32_t)) {
    return hn::LoadU(D(), reinterpret_cast<const int32_t*>(texels));
  } else {
    return hn::PromoteTo(D(), hn::LoadU(hn::Rebind<Pixel, D>(), texels));
  }
}

// The first rows of a window of so many columns, as many as a vector holds.
template <int kColumnBits, class Pixel>
HWY_INLINE V32 load_rows(const Pixel* texels, ptrdiff_t pitch_texel) {
  if constexpr (kRowsPerVector<kColumnBits> == 1) {
    return load_row<D32>(texels);
  } else {
    using Half = hn::Half<D32>;
    return hn::Combine(D32(), load_row<Half>(texels + pitch_texel), load_row<Half>(texels));
  }
}

// The rows of a window that one permute takes.
template <int kColumnBits>
class PermutedRows {
 public:
  static constexpr int32_t kRows = kRowsPerPermute * kRowsPerVector<kColumnBits>;

  template <class Pixel>
  HWY_INLINE PermutedRows(const Pixel* texels, ptrdiff_t pitch_texel)
      : first_(load_rows<kColumnBits>(texels, pitch_texel)) {
#if HWY_TARGET == HWY_AVX3
    second_ =
        load_rows<kColumnBits>(texels + kRowsPerVector<kColumnBits> * pitch_texel, pitch_texel);
#endif
  }

  // In registers, or else compilers load them once for each use.
  HWY_INLINE void keep() {
#if HWY_TARGET == HWY_AVX3
    asm("" : "+v"(first_.raw), "+v"(second_.raw));
#endif
  }

  // The texels at the low bits of an index into a row after another.
  [[nodiscard]] HWY_INLINE V32 texels(V32 index) const {
#if HWY_TARGET == HWY_AVX3
    return V32{_mm512_permutex2var_epi32(first_.raw, index.raw, second_.raw)};
#elif HWY_TARGET == HWY_AVX2
    return V32{_mm256_permutevar8x32_epi32(first_.raw, index.raw)};
#else
    static_cast<void>(index);
    return first_;
#endif
  }

 private:
  V32 first_;
#if HWY_TARGET == HWY_AVX3
  V32 second_;
#endif
};

// Texels of some vectors by their index in a window, the rows of which are loaded once.
template <int kColumnBits, int32_t kVectors, class Pixel>
HWY_INLINE void pick_all(const Pixel* HWY_RESTRICT window, ptrdiff_t pitch_texel, int32_t rows,
                         const V32 (&index)[kVectors], V32 (&picked)[kVectors]) {
  using Rows = PermutedRows<kColumnBits>;
  constexpr int32_t kTexels = Rows::kRows << kColumnBits;
  const D32 d;
  Rows first(window, pitch_texel);
  if (kVectors > 1) first.keep();
  for (int32_t i = 0; i < kVectors; ++i) picked[i] = first.texels(index[i]);
  V32 before = hn::Set(d, kTexels - 1);
#pragma GCC unroll 8
  for (int32_t row = Rows::kRows; row < rows; row += Rows::kRows) {
    window += Rows::kRows * pitch_texel;
    Rows next(window, pitch_texel);
    if (kVectors > 1) next.keep();
    for (int32_t i = 0; i < kVectors; ++i) {
      picked[i] = hn::IfThenElse(hn::Gt(index[i], before), next.texels(index[i]), picked[i]);
    }
    before = hn::Add(before, hn::Set(d, kTexels));
  }
}

// The same. Most windows take one permute or two: loops that know it are faster.
template <int32_t kVectors, class Pixel>
HWY_INLINE void pick_few(const Pixel* HWY_RESTRICT window, ptrdiff_t pitch_texel, int32_t rows,
                         const V32 (&index)[kVectors], V32 (&picked)[kVectors]) {
  constexpr int kBits = kWindowColumnBits;
  constexpr int32_t kOne = kRowsPerPermute, kTwo = 2 * kOne;
  if (rows == kOne) return pick_all<kBits>(window, pitch_texel, kOne, index, picked);
  if (rows == kTwo) return pick_all<kBits>(window, pitch_texel, kTwo, index, picked);
  constexpr bool kAreThree = kMostWindowRows == 3 * kRowsPerPermute;
  pick_all<kBits>(window, pitch_texel, kAreThree ? kMostWindowRows : rows, index, picked);
}

// Of one vector.
template <int kColumnBits, class Pixel>
HWY_INLINE V32 pick(const Pixel* HWY_RESTRICT window, ptrdiff_t pitch_texel, int32_t rows,
                    V32 index) {
  const V32 indices[] = {index};
  V32 picked[1];
  pick_all<kColumnBits>(window, pitch_texel, rows, indices, picked);
  return picked[0];
}
template <class Pixel>
HWY_INLINE V32 pick_few(const Pixel* HWY_RESTRICT window, ptrdiff_t pitch_texel, int32_t rows,
                        V32 index) {
  const V32 indices[] = {index};
  V32 picked[1];
  pick_few(window, pitch_texel, rows, indices, picked);
  return picked[0];
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
