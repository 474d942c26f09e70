// Affine spans by windows, those of some vectors of a row found at once. Included once for each
// SIMD target.
#if defined(SELVAGE_VECTOR_AFFINE_WINDOW_RUNS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_AFFINE_WINDOW_RUNS_INL_H
#undef SELVAGE_VECTOR_AFFINE_WINDOW_RUNS_INL_H
#else
#define SELVAGE_VECTOR_AFFINE_WINDOW_RUNS_INL_H
#endif

#include "mapper/vector/affine_windows-inl.h"
#include "mapper/vector/left-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// Vectors side by side, found at once: so many, for they are read so soon after they are written
// that the first of them wait for it.
inline constexpr int32_t kRunVectors = 2 * kMostLanes, kRun_px = kRunVectors * kLanes;
static_assert(kRunVectors <= FoundWindows::kMost);

// Of one coordinate: the lanes of anchors that are so far apart. Where there are windows a step is
// a texel at most: no sum overflows.
class AnchorRun {
 public:
  HWY_INLINE explicit AnchorRun(int64_t apart_fx32)
      : apart_fx32_(apart_fx32),
        low_(hn::Mul(hn::Iota(Wide(), 0), hn::Set(Wide(), apart_fx32_))),
        high_(hn::Add(low_, hn::Set(Wide(), kLanes / 2 * apart_fx32_))) {}

  // kLanes of them from the k-th on.
  HWY_INLINE WideLanes from(int64_t first_fx32, int32_t k) const {
    const auto first = hn::Set(Wide(), first_fx32 + k * apart_fx32_);
    return {hn::BitCast(D32(), hn::Add(first, low_)), hn::BitCast(D32(), hn::Add(first, high_))};
  }

 private:
  using Wide = hn::Repartition<int64_t, D32>;

  int64_t apart_fx32_;
  hn::Vec<Wide> low_, high_;
};

// Draws the run that begins with a pixel, and puts down the vectors that are left.
template <class Pixel, class Draw>
HWY_INLINE int32_t draw_run(const Draw& by, const FoundWindows& found, const Span& rest, Pixel* row,
                            int32_t left_count, Left* left) {
  const auto leave = [&](int32_t px) HWY_ATTR {
    left->rest[static_cast<size_t>(left_count++)] = {rest.row, px, rest.right_px};
  };
  const int32_t count_px = HWY_MIN(rest.width_px(), kRun_px);
  const int32_t whole = count_px / kLanes, last_px = count_px % kLanes;
  Pixel* const to = row + rest.left_px;
  for (int32_t k = 0; k < whole; ++k) {
    if (HWY_UNLIKELY(!by.draw(found, k, kLanes, to + k * kLanes))) leave(rest.left_px + k * kLanes);
  }
  if (last_px != 0 && HWY_UNLIKELY(!by.draw(found, whole, last_px, to + whole * kLanes))) {
    leave(rest.left_px + whole * kLanes);
  }
  return left_count;
}

template <class Pixel, class InWindow, int kColumnBits, int32_t kRows>
HWY_NOINLINE void draw_windows(const AffineSpans& spans, const Surface& surface,
                               const WindowShape& shape, bool inside, Resume* at, Left* left) {
  const AffineField field = spans.field;
  using Draw = WindowDraw<Pixel, InWindow, kColumnBits, kRows>;
  const Draw by(spans, surface, shape.rows);
  const WindowFinder<typename Draw::Coarse> finder(surface, shape, inside);
  const AnchorRun run_u(kLanes * field.step_x.u_fx32), run_v(kLanes * field.step_x.v_fx32);
  const Lane to_anchor = by.to_anchor();
  FoundWindows found;
  int32_t i = at->row, px = at->px, left_count = 0;
  for (; i < spans.batch.rows; ++i, px = INT32_MIN) {
    const Span span = spans.batch.span(i);
    Pixel* const row = reinterpret_cast<Pixel*>(first_pixel(surface, {span.row, 0, 0}));
    for (px = HWY_MAX(px, span.left_px); px < span.right_px; px += kRun_px) {
      if (left_count > Left::kMost - kRunVectors) break;
      const Lane first = field.at(px, span.row);
      const Lane anchor{first.u_fx32 + to_anchor.u_fx32, first.v_fx32 + to_anchor.v_fx32};
      for (int32_t k = 0; k < kRunVectors && px + k * kLanes < span.right_px; k += kLanes) {
        finder.find(run_u.from(anchor.u_fx32, k), run_v.from(anchor.v_fx32, k), k, &found);
      }
      left_count = draw_run(by, found, {span.row, px, span.right_px}, row, left_count, left);
    }
    if (px < span.right_px) break;
  }
  left->count = left_count;
  *at = {i, px};
}

// All vectors, but for those that do not lie in a window.
struct WindowRuns {
  const AffineSpans& spans;
  const Surface& surface;
  bool inside;
  Resume* at;
  Left* left;

  template <class Pixel, class InWindow, int kColumnBits, int32_t kRows>
  HWY_INLINE void draw(const WindowShape& shape) const {
    draw_windows<Pixel, InWindow, kColumnBits, kRows>(spans, surface, shape, inside, at, left);
  }
};

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
