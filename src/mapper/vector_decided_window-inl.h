// Spans of a polygon whose texels lie in one window, with many near-ties among them. Included once
// for each SIMD target.
#if defined(SELVAGE_VECTOR_DECIDED_WINDOW_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_DECIDED_WINDOW_INL_H
#undef SELVAGE_VECTOR_DECIDED_WINDOW_INL_H
#else
#define SELVAGE_VECTOR_DECIDED_WINDOW_INL_H
#endif

#include "mapper/vector_one_window-inl.h"
#include "mapper/vector_store-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// Vectors of texels of which no more is in doubt, by permutes of a window in the texture.
template <class Pixel, int kColumnBits>
class DecidedWindow {
 public:
  HWY_INLINE DecidedWindow(const selvage_texture& texture, const WindowPlace& place)
      : pitch_texel_(pitch_texel_of(texture)),
        window_(static_cast<const Pixel*>(texture.texels) + place.t.index * pitch_texel_ +
                place.s.index),
        rows_(place.vectors * kRowsPerVector<kColumnBits>),
        place_(place) {}

  HWY_INLINE void draw(const TexelVectors& texels, int32_t count_px, Pixel* to) const {
    const D32 d;
    const V32 column = hn::Sub(texels.s, hn::Set(d, place_.s.texel));
    const V32 row = hn::Sub(texels.t, hn::Set(d, place_.t.texel));
    const V32 index = hn::Add(hn::ShiftLeft<kColumnBits>(row), column);
    store_pixels(pick<kColumnBits>(window_, pitch_texel_, rows_, index), count_px, to);
  }

 private:
  ptrdiff_t pitch_texel_;
  const Pixel* window_;
  int32_t rows_;
  WindowPlace place_;
};

// Calls draw(window). The texels lie in the texture, and a window holds them.
template <class Pixel, class Draw>
HWY_INLINE void with_decided_window(const TexelRanges& texels, const selvage_texture& texture,
                                    const Draw& draw) {
  const auto half = place_inside<kHalfColumnBits>(texels, texture);
  if (half.vectors != 0) {
    draw(DecidedWindow<Pixel, kHalfColumnBits>(texture, half));
  } else {
    const auto whole = place_inside<kWindowColumnBits>(texels, texture);
    draw(DecidedWindow<Pixel, kWindowColumnBits>(texture, whole));
  }
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
