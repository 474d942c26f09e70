// Narrow affine spans by windows, those of some rows found at once. Included once for each SIMD
// target.
#if defined(SELVAGE_VECTOR_AFFINE_WINDOW_STRIPS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_AFFINE_WINDOW_STRIPS_INL_H
#undef SELVAGE_VECTOR_AFFINE_WINDOW_STRIPS_INL_H
#else
#define SELVAGE_VECTOR_AFFINE_WINDOW_STRIPS_INL_H
#endif

#include "mapper/vector/affine_rest-inl.h"
#include "mapper/vector/affine_strip-inl.h"
#include "mapper/vector/affine_windows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// Vectors and their windows.
template <class Finder>
struct WindowStrip : Strip {
  Finder finder;
  FoundWindows found;

  HWY_INLINE explicit WindowStrip(const Finder& by) : finder(by) {}
  HWY_INLINE void put(int32_t row, const StripEnds& ends, const WidePair& at) {
    Strip::put(row, ends);
    finder.find(at.u, at.v, row, &found);
  }
};

// Draws them.
template <class Pixel, class Window>
struct WindowStripDraw {
  static constexpr bool kTellsWhole = false;
  static HWY_INLINE bool is_in_vain() { return false; }

  Window window;

  template <class AnyStrip>
  HWY_INLINE bool draw(const AnyStrip& strip, int32_t row, int32_t count_px, Pixel* to) const {
    return window.draw(strip.found, row, count_px, to);
  }
};

// Draws a batch by windows of one shape, and what does not lie in one by rest->draw(). Rows are
// under one map, or those whose anchors these are, from which on lanes of the spans' step are as
// near as their margin says.
template <class Anchors>
struct WindowStrips {
  const AffineSpans& spans;
  Anchors anchors;
  const Surface& surface;
  bool inside;
  RestDraw* rest;

  template <class Pixel, class InWindow, int kColumnBits, int32_t kRows>
  HWY_NOINLINE void draw(const WindowShape& shape) const {
    using Window = WindowDraw<Pixel, InWindow, kColumnBits, kRows>;
    using Finder = WindowFinder<typename Window::Coarse>;
    const WindowStripDraw<Pixel, Window> by{Window(spans, surface, shape.rows)};
    WindowStrip<Finder> strip(Finder(surface, shape, inside));
    draw_strips<Pixel>(by, &strip, anchors, spans.batch, surface, rest);
  }
};

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
