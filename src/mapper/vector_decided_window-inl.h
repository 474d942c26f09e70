// Spans of a polygon whose texels lie in one window, with many near-ties among them. Included once
// for each SIMD target.
#if defined(SELVAGE_VECTOR_DECIDED_WINDOW_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_DECIDED_WINDOW_INL_H
#undef SELVAGE_VECTOR_DECIDED_WINDOW_INL_H
#else
#define SELVAGE_VECTOR_DECIDED_WINDOW_INL_H
#endif

#include "mapper/vector_one_window-inl.h"
#include "mapper/vector_plane_ties-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// Vectors of texels that `ties` decides, by permutes of a window in the texture.
template <class Pixel, int kColumnBits, class Ties>
class DecidedWindow {
 public:
  HWY_INLINE DecidedWindow(const Surface& surface, const WindowPlace& place, int32_t lack_fx16,
                           Ties* ties)
      : fixed_(surface.texture, lack_fx16),
        pitch_texel_(pitch_texel_of(surface.texture)),
        window_(static_cast<const Pixel*>(surface.texture.texels) + place.t.index * pitch_texel_ +
                place.s.index),
        rows_(place.vectors * kRowsPerVector<kColumnBits>),
        place_(place),
        ties_(ties) {}

  // The first of some pixels, counted from that of a span in the row that `ties` then knows.
  [[nodiscard]] HWY_INLINE int32_t offset_px(const Span& pixels) const {
    if (pixels.row != ties_->span().row) ties_->go_to(pixels);
    return pixels.left_px - ties_->span().left_px;
  }
  HWY_INLINE void draw(int32_t offset_px, const LaneVectors& lanes, int32_t count_px,
                       Pixel* to) const {
    const D32 d;
    const TexelVectors texels = fixed_.decided(*ties_, offset_px, lanes);
    const V32 column = hn::Sub(texels.s, hn::Set(d, place_.s.texel));
    const V32 row = hn::Sub(texels.t, hn::Set(d, place_.t.texel));
    const V32 index = hn::Add(hn::ShiftLeft<kColumnBits>(row), column);
    store_pixels(pick<kColumnBits>(window_, pitch_texel_, rows_, index), count_px, to);
  }

 private:
  FixedLanes<Addressed<InsideVector>> fixed_;
  ptrdiff_t pitch_texel_;
  const Pixel* window_;
  int32_t rows_;
  WindowPlace place_;
  Ties* ties_;
};

// Calls draw(window). The texels lie in the texture, and a window holds them.
template <class Pixel, class Ties, class Draw>
HWY_INLINE void with_decided_window(const TexelRanges& texels, const Surface& surface,
                                    int32_t lack_fx16, Ties* ties, const Draw& draw) {
  const auto half = place_inside<kHalfColumnBits>(texels, surface.texture);
  if (half.vectors != 0) {
    draw(DecidedWindow<Pixel, kHalfColumnBits, Ties>(surface, half, lack_fx16, ties));
  } else {
    const auto whole = place_inside<kWindowColumnBits>(texels, surface.texture);
    draw(DecidedWindow<Pixel, kWindowColumnBits, Ties>(surface, whole, lack_fx16, ties));
  }
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
