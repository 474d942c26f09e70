// The four texels around points by permuting a few rows of the texture. Included once for each SIMD
// target.
//
// Where the texture is not made smaller, the texels around a vector of pixels are few: a window of
// them is loaded row by row, and each corner is picked by permutes, which cost less than a load for
// each pixel.
#if defined(SELVAGE_VECTOR_BLEND_WINDOW_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_BLEND_WINDOW_INL_H
#undef SELVAGE_VECTOR_BLEND_WINDOW_INL_H
#else
#define SELVAGE_VECTOR_BLEND_WINDOW_INL_H
#endif

#include "mapper/vector/blend_corners-inl.h"
#include "mapper/vector/window-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

inline constexpr bool kHasBlendWindows = HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3;

// Upper texels are picked from so many vectors, each one row or two halves. Lower ones are picked
// from as many that begin a row below, at the same places; where that were too many vectors of
// halves, from the same ones.
template <int kColumnBits, int32_t kVectors>
class BlendWindow {
  static constexpr bool kHalves = 1 << kColumnBits < kLanes;
  static constexpr bool kHasLower = !kHalves || kVectors <= 3;

 public:
  static constexpr int32_t kColumns = 1 << kColumnBits;
  static constexpr int32_t kRows = kVectors * (kLanes >> kColumnBits) + (kHasLower ? 1 : 0);
  // Fewer permutes pick from the next smaller one with as many columns, if there is such.
  static constexpr bool kHasSmaller = kVectors > 4;
  using Smaller = BlendWindow<kColumnBits, kVectors - 2>;

  // Where there are fewer rows, the last one stands for those below it.
  HWY_INLINE BlendWindow(const uint32_t* texels, ptrdiff_t pitch_texel, int32_t rows,
                         const BlendConstants& k)
      : k_(k) {
    constexpr int32_t kRowsApart = kHasLower ? 1 : kLanes >> kColumnBits;
    const auto below = [&](int32_t row) { return row + 1 < rows ? pitch_texel : 0; };
#pragma GCC unroll 16
    for (int32_t i = 0; i < kLoads; ++i) {
      const int32_t row = i * kRowsApart;
      vectors_[i] = in_corners(load(texels, below(row)), k);
#pragma GCC unroll 2
      for (int32_t next = row; next < row + kRowsApart; ++next) texels += below(next);
    }
  }

  HWY_INLINE Corners corners(const WindowLanes& lanes) const {
    const V32 rows = kColumns == 8 ? k_.rows_of_8 : k_.rows_of_16;
    const V32 t = hn::ShiftRight<kWindowFraction - kColumnBits>(lanes.v);
    const auto at = [&](V32 u)
                        HWY_ATTR { return hn::OrAnd(hn::ShiftRight<kWindowFraction>(u), t, rows); };
    // With a weight of 0 the right texel is the left one. It is in the same row, and so in the same
    // vector.
    const V32 left = at(lanes.u), right = at(hn::Add(lanes.u, k_.to_right));
    const Pick upper(left, k_);
    if constexpr (kHasLower) {
      return {pick<0>(left, upper), pick<0>(right, upper), pick<1>(left, upper),
              pick<1>(right, upper)};
    } else {
      // ~(kColumns - 1) is -kColumns.
      const V32 lower_left = hn::Sub(left, rows), lower_right = hn::Sub(right, rows);
      const Pick lower(lower_left, k_);
      return {pick<0>(left, upper), pick<0>(right, upper), pick<0>(lower_left, lower),
              pick<0>(lower_right, lower)};
    }
  }

 private:
  static constexpr int32_t kLoads = !kHasLower ? kVectors : (kHalves ? 2 * kVectors : kVectors + 1);

  // The i-th vector to pick from, of those that begin kBelow rows below the first.
  template <int32_t kBelow>
  HWY_INLINE V32 vector(int32_t i) const {
    return vectors_[(kHalves && kHasLower ? 2 * i : i) + kBelow];
  }
  static HWY_INLINE V32 load(const uint32_t* texels, ptrdiff_t to_next_texel) {
    if constexpr (kHalves) {
      using Half = hn::Half<D32>;
      return hn::Combine(D32(), load_row<Half>(texels + to_next_texel), load_row<Half>(texels));
    } else {
      return load_row<D32>(texels);
    }
  }

#if HWY_TARGET == HWY_AVX3
  // Which of the pairs of vectors an index is in: bits of the pair's number.
  struct Pick {
    HWY_INLINE Pick(V32 index, const BlendConstants& k)
        : odd_pair(hn::TestBit(index, k.odd_pair)), last_pairs(hn::TestBit(index, k.last_pairs)) {}
    hn::Mask<D32> odd_pair, last_pairs;
  };

  template <int32_t kBelow, int32_t kFirst>
  HWY_INLINE V32 permute(V32 index) const {
    if constexpr (kFirst + 1 == kVectors) {
      return V32{_mm512_permutexvar_epi32(index.raw, vector<kBelow>(kFirst).raw)};
    } else {
      return V32{_mm512_permutex2var_epi32(vector<kBelow>(kFirst).raw, index.raw,
                                           vector<kBelow>(kFirst + 1).raw)};
    }
  }
  // From the pair at kFirst and the next one.
  template <int32_t kBelow, int32_t kFirst>
  HWY_INLINE V32 pick_four(V32 index, const Pick& of) const {
    if constexpr (kFirst + 2 >= kVectors) {
      return permute<kBelow, kFirst>(index);
    } else {
      return hn::IfThenElse(of.odd_pair, permute<kBelow, kFirst + 2>(index),
                            permute<kBelow, kFirst>(index));
    }
  }
  template <int32_t kBelow>
  HWY_INLINE V32 pick(V32 index, const Pick& of) const {
    if constexpr (kVectors <= 4) {
      return pick_four<kBelow, 0>(index, of);
    } else {
      return hn::IfThenElse(of.last_pairs, pick_four<kBelow, 4>(index, of),
                            pick_four<kBelow, 0>(index, of));
    }
  }
#else
  // Which rows below the first one an index is in, or below.
  struct Pick {
    HWY_INLINE Pick(V32 index, const BlendConstants& /*k*/) {
      for (int32_t i = 1; i < kVectors; ++i) {
        from[i] = hn::Gt(index, hn::Set(D32(), i * kColumns - 1));
      }
    }
    hn::Mask<D32> from[kVectors];
  };

  template <int32_t kBelow>
  HWY_INLINE V32 pick(V32 index, const Pick& of) const {
    V32 picked = permute(vector<kBelow>(0), index);
    for (int32_t i = 1; i < kVectors; ++i) {
      picked = hn::IfThenElse(of.from[i], permute(vector<kBelow>(i), index), picked);
    }
    return picked;
  }
  static HWY_INLINE V32 permute(V32 row, V32 index) {
#if HWY_TARGET == HWY_AVX2
    return V32{_mm256_permutevar8x32_epi32(row.raw, index.raw)};
#else
    static_cast<void>(index);
    return row;
#endif
  }
#endif

  const BlendConstants& k_;
  V32 vectors_[kLoads];
};

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
