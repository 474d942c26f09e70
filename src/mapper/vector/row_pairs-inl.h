// Rows drawn two at a time, a vector and the one below it from one window. Included once for each
// SIMD target.
#if defined(SELVAGE_VECTOR_ROW_PAIRS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_ROW_PAIRS_INL_H
#undef SELVAGE_VECTOR_ROW_PAIRS_INL_H
#else
#define SELVAGE_VECTOR_ROW_PAIRS_INL_H
#endif

#include "mapper/vector/left-inl.h"
#include "mapper/vector/store-inl.h"
#include "mapper/vector/window-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// Ends of rows, where fewer pixels are, are drawn by masks.
inline constexpr bool kHasPairs = kHasWindows && kHasMask;

// From the leftmost pixel of two rows to the rightmost one.
[[nodiscard]] HWY_INLINE Span around(const Span& upper, const Span& lower) {
  if (upper.empty()) return lower;
  if (lower.empty()) return upper;
  return {upper.row, HWY_MIN(upper.left_px, lower.left_px),
          HWY_MAX(upper.right_px, lower.right_px)};
}

// The pixel, at or left of a span's first one, from which a row's vectors each lie in one line of
// the cache: so many lie in two that stores take twice as long.
template <class Pixel>
[[nodiscard]] HWY_INLINE int32_t first_of_line(const Surface& surface, const Span& span) {
  const auto at = reinterpret_cast<uintptr_t>(first_pixel(surface, span));
  return span.left_px - static_cast<int32_t>(at / sizeof(Pixel) % kLanes);
}

// Vectors side by side of two rows, found at once.
struct PairRun {
  int32_t index;  // of the upper row in the batch
  Span upper, lower;
  int32_t px, vectors;

  // Those from here on are whole in both rows, up to there.
  [[nodiscard]] HWY_INLINE int32_t first_whole() const {
    const int32_t from_px = HWY_MAX(upper.left_px, lower.left_px) - px;
    return HWY_MIN(HWY_MAX(from_px + kLanes - 1, 0) / kLanes, vectors);
  }
  [[nodiscard]] HWY_INLINE int32_t end_whole() const {
    const int32_t to_px = HWY_MIN(upper.right_px, lower.right_px) - px;
    return HWY_MIN(HWY_MAX(to_px, 0) / kLanes, vectors);
  }
};

// All runs of a batch, but for a last row that has none below it. Rows' vectors begin at
// begin_of(both), at or left of the first pixel of two of them.
template <class BeginOf>
class PairWalk {
 public:
  // Of so many vectors at most, from a place on.
  HWY_INLINE PairWalk(const SpanBatch& batch, const Resume& at, int32_t most_vectors,
                      const BeginOf& begin_of)
      : batch_(batch), begin_of_(begin_of), at_(at), most_vectors_(most_vectors) {}

  // False where there is none left.
  HWY_INLINE bool next(PairRun* run) {
    for (; at_.row + 1 < batch_.rows; at_ = {at_.row + 2, INT32_MIN}) {
      const Span upper = batch_.span(at_.row), lower = batch_.span(at_.row + 1);
      const Span both = around(upper, lower);
      if (both.empty()) continue;
      const int32_t from_px = HWY_MAX(at_.px, begin_of_(both));
      const int32_t rest_px = both.right_px - from_px;
      if (rest_px <= 0) continue;
      const int32_t vectors = HWY_MIN((rest_px + kLanes - 1) / kLanes, most_vectors_);
      *run = {at_.row, upper, lower, from_px, vectors};
      at_.px = from_px + vectors * kLanes;
      return true;
    }
    return false;
  }
  // Where it goes on.
  [[nodiscard]] HWY_INLINE const Resume& at() const { return at_; }

 private:
  const SpanBatch& batch_;
  BeginOf begin_of_;
  Resume at_;
  int32_t most_vectors_;
};

// Those pixels of a vector that begins at `px` that are the span's: there, or nowhere.
template <class Pixel>
HWY_INLINE void store_within(V32 texels, const Span& span, int32_t px, Pixel* to) {
  const hn::Rebind<Pixel, D32> d;
  const auto before = [&](int32_t end_px) HWY_ATTR {
    return hn::FirstN(d, static_cast<size_t>(HWY_MIN(HWY_MAX(end_px - px, 0), kLanes)));
  };
  hn::BlendedStore(as_pixels<Pixel>(texels),
                   hn::AndNot(before(span.left_px), before(span.right_px)), d, to);
}

// The same of what is left of a vector.
HWY_INLINE void leave(const Span& span, int32_t px, Left* left) {
  const Span rest{span.row, HWY_MAX(px, span.left_px), span.right_px};
  if (rest.empty() || rest.left_px >= px + kLanes) return;
  left->rest[static_cast<size_t>(left->count++)] = rest;
}

// Draws a run's vectors up to where there is no room for more that are left. Returns how many.
template <class Pixel, class Picker, class Found>
HWY_INLINE int32_t draw_pair_run(const Picker& by, const Found& found, const PairRun& run,
                                 const Surface& surface, Left* left) {
  // Modulo 2^64: left of a row there may be no address.
  const auto row_of = [&](const Span& span) HWY_ATTR {
    return reinterpret_cast<uintptr_t>(first_pixel(surface, {span.row, 0, 0}));
  };
  const auto at = [](uintptr_t row, int32_t px) HWY_ATTR {
    return reinterpret_cast<Pixel*>(row + static_cast<uintptr_t>(px * ptrdiff_t{sizeof(Pixel)}));
  };
  const hn::Rebind<Pixel, D32> d;
  const uintptr_t upper = row_of(run.upper), lower = row_of(run.lower);
  const int32_t first_whole = run.first_whole(), end_whole = run.end_whole();
  int32_t px = run.px;
  V32 above, below;
  for (int32_t k = 0; k < run.vectors; ++k, px += kLanes) {
    for (; first_whole <= k && k < end_whole; ++k, px += kLanes) {
      if (HWY_UNLIKELY(!by.pick_both(found, k, &above, &below))) break;
      hn::StoreU(as_pixels<Pixel>(above), d, at(upper, px));
      hn::StoreU(as_pixels<Pixel>(below), d, at(lower, px));
    }
    if (k == run.vectors) break;
    if (HWY_LIKELY(by.pick_both(found, k, &above, &below))) {
      store_within(above, run.upper, px, at(upper, px));
      store_within(below, run.lower, px, at(lower, px));
      continue;
    }
    if (left->count > Left::kMost - 2) return k;
    leave(run.upper, px, left);
    leave(run.lower, px, left);
  }
  return run.vectors;
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
