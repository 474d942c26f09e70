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

inline constexpr bool kHasBlendWindows = HWY_TARGET == HWY_AVX3;

// Of so many vectors, each one row or two halves.
template <int kColumnBits, int32_t kVectors>
class BlendWindow {
 public:
  static constexpr int32_t kColumns = 1 << kColumnBits;
  static constexpr int32_t kRows = kVectors * (kLanes >> kColumnBits);
  // Fewer permutes pick from the next smaller one with as many columns, if there is such.
  static constexpr bool kHasSmaller = kVectors == 3 || kVectors > 4;
  using Smaller = BlendWindow<kColumnBits, kVectors == 3 ? 2 : kVectors - 2>;

  HWY_INLINE BlendWindow(const uint32_t* texels, ptrdiff_t pitch_texel, const BlendConstants& k)
      : k_(k) {
#pragma GCC unroll 16
    for (int32_t i = 0; i < kVectors; ++i) {
      vectors_[i] = hn::Xor(load(texels, pitch_texel), k.signs);
      texels += (kLanes >> kColumnBits) * pitch_texel;
    }
  }

  // With a weight of 0 the right texel is the left one.
  HWY_INLINE Corners corners(const WindowLanes& lanes) const {
    const D32 d;
    const V32 s = hn::ShiftRight<kWindowFraction>(lanes.u);
    const V32 t = hn::ShiftRight<kWindowFraction - kColumnBits>(lanes.v);
    const V32 upper = hn::Or(s, hn::And(t, hn::Set(d, -kColumns)));
    const V32 lower = hn::Add(upper, hn::Set(d, kColumns));
    const auto has_right = hn::TestBit(lanes.u, k_.weight_bits);
    const V32 right = hn::IfThenElseZero(has_right, k_.one);
    const V32 upper_right = hn::Add(upper, right), lower_right = hn::Add(lower, right);
    // The right texel is in the same row, and so in the same vector, as the left one.
    const Pick in_upper(upper, k_), in_lower(lower, k_);
    return {pick(upper, in_upper), pick(upper_right, in_upper), pick(lower, in_lower),
            pick(lower_right, in_lower)};
  }

 private:
  static HWY_INLINE V32 load(const uint32_t* texels, ptrdiff_t pitch_texel) {
    if constexpr (1 << kColumnBits == kLanes) {
      return load_row<D32>(texels);
    } else {
      using Half = hn::Half<D32>;
      return hn::Combine(D32(), load_row<Half>(texels + pitch_texel), load_row<Half>(texels));
    }
  }

  // Which of the pairs of vectors an index is in: bits of the pair's number.
  struct Pick {
    HWY_INLINE Pick(V32 index, const BlendConstants& k)
        : odd_pair(hn::TestBit(index, k.odd_pair)), last_pairs(hn::TestBit(index, k.last_pairs)) {}
    hn::Mask<D32> odd_pair, last_pairs;
  };

  template <int32_t kFirst>
  HWY_INLINE V32 permute(V32 index) const {
#if HWY_TARGET == HWY_AVX3
    if constexpr (kFirst + 1 == kVectors) {
      return V32{_mm512_permutexvar_epi32(index.raw, vectors_[kFirst].raw)};
    } else {
      return V32{
          _mm512_permutex2var_epi32(vectors_[kFirst].raw, index.raw, vectors_[kFirst + 1].raw)};
    }
#else
    return index;
#endif
  }
  // From the pair at kFirst and the next one.
  template <int32_t kFirst>
  HWY_INLINE V32 pick_four(V32 index, const Pick& of) const {
    if constexpr (kFirst + 2 >= kVectors) {
      return permute<kFirst>(index);
    } else {
      return hn::IfThenElse(of.odd_pair, permute<kFirst + 2>(index), permute<kFirst>(index));
    }
  }
  HWY_INLINE V32 pick(V32 index, const Pick& of) const {
    if constexpr (kVectors <= 4) {
      return pick_four<0>(index, of);
    } else {
      return hn::IfThenElse(of.last_pairs, pick_four<4>(index, of), pick_four<0>(index, of));
    }
  }

  const BlendConstants& k_;
  V32 vectors_[kVectors];
};

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
