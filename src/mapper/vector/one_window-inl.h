// A window that holds all texels of a polygon. Included once for each SIMD target.
//
// Its rows are loaded once a batch and kept in registers. Near-ties are drawn as they come and
// looked for behind some rows: where there is one, the batch is drawn once more, by others.
#if defined(SELVAGE_VECTOR_ONE_WINDOW_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_ONE_WINDOW_INL_H
#undef SELVAGE_VECTOR_ONE_WINDOW_INL_H
#else
#define SELVAGE_VECTOR_ONE_WINDOW_INL_H
#endif

#include "mapper/vector/lanes-inl.h"
#include "mapper/vector/row_blocks-inl.h"
#include "mapper/vector/store-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// Whether rows share the window.
[[nodiscard]] HWY_INLINE bool pays_one_window(const SpanBatch& batch) {
  return is_narrow(batch) && batch.rows > 1;
}

// What became of a batch: drawn, or not, for no window holds it or for it has near-ties.
enum class InOneWindow { kDrawn, kNotInOne, kFewNearTies, kManyNearTies };

// Whether what lanes of so many bits of fraction lack changes a texel.
template <int kFraction>
[[nodiscard]] HWY_INLINE bool changes_texels(V32 changed) {
  return any_bits(changed, ~0 << kFraction);
}

// Of a batch that was drawn, or given up at a near-tie, by what the lanes of the pixels that were
// drawn lack changes in them: near-ties are many where they lie in many lanes, or in all of the
// widest row. How many vectors hold them is not known, as are_many() asks.
template <int kFraction>
[[nodiscard]] HWY_INLINE InOneWindow in_one_window(V32 changed, int32_t widest_px) {
  const int32_t many = HWY_MIN(4, widest_px);
  if (!changes_texels<kFraction>(changed)) return InOneWindow::kDrawn;
  const auto near = hn::Ne(hn::ShiftRight<kFraction>(changed), hn::Zero(D32()));
  const auto count = static_cast<int32_t>(hn::CountTrue(D32(), near));
  return count < many ? InOneWindow::kFewNearTies : InOneWindow::kManyNearTies;
}

// The texels of one coordinate, both of them included.
struct TexelRange {
  int32_t first, last;

  [[nodiscard]] HWY_INLINE int32_t count() const { return last - first + 1; }
  [[nodiscard]] HWY_INLINE bool within(int32_t size_texel) const {
    return first >= 0 && last < size_texel;
  }
};

struct TexelRanges {
  TexelRange s, t;

  HWY_INLINE explicit TexelRanges(const TexelBox& box)
      : s{box.least_u_fx16 >> kTexelFraction, box.most_u_fx16 >> kTexelFraction},
        t{box.least_v_fx16 >> kTexelFraction, box.most_v_fx16 >> kTexelFraction} {}

  // The texture, so that no address mode changes a texel.
  [[nodiscard]] HWY_INLINE bool within(const selvage_texture& texture) const {
    return s.within(texture.width) && t.within(texture.height);
  }
};

// Picked from by one permute, and the most that are kept.
inline constexpr int32_t kVectorsPerPermute = kRowsPerPermute;
inline constexpr int32_t kMostWindowVectors = kMostWindowRows;

// Where a window is; no vectors where none holds all.
struct WindowPlace {
  Origin s{}, t{};
  int32_t vectors = 0;
};

// Of some windows there are two sizes alone, so that there is less code.
inline constexpr int32_t kFewWindowVectors = 2 * kVectorsPerPermute;

// As many vectors as the smallest window of no fewer has; more than kMostWindowVectors where there
// is none.
template <bool kTwoSizes>
[[nodiscard]] HWY_INLINE int32_t window_vectors(int32_t vectors) {
  if constexpr (!kTwoSizes) {
    return whole_rows(vectors);
  } else {
    return vectors <= kFewWindowVectors ? kFewWindowVectors : HWY_MAX(vectors, kMostWindowVectors);
  }
}

// Of any texels.
template <class Address, int kColumnBits, bool kTwoSizes>
[[nodiscard]] HWY_INLINE WindowPlace place_of(const TexelRanges& texels,
                                              const selvage_texture& texture) {
  constexpr int32_t kRows = kRowsPerVector<kColumnBits>;
  const int32_t vectors = window_vectors<kTwoSizes>((texels.t.count() + kRows - 1) / kRows);
  const int32_t last_column = texture.width - kColumns<kColumnBits>;
  const int32_t last_row = texture.height - vectors * kRows;
  if (texels.s.count() > kColumns<kColumnBits> || vectors > kMostWindowVectors || last_column < 0 ||
      last_row < 0) {
    return {};
  }
  const WindowPlace place{Address::origin(texels.s.first, last_column, texture.width),
                          Address::origin(texels.t.first, last_row, texture.height), vectors};
  return place.s.index <= last_column && place.t.index <= last_row ? place : WindowPlace{};
}

template <class Pixel, class Address, int kColumnBits, int32_t kVectors>
class Window {
 public:
  static constexpr bool kClamps = Address::kClampsWindows;

  HWY_INLINE Window(const selvage_texture& texture, const WindowPlace& place)
      : origin_{int64_t{place.s.texel} << kLaneFraction, int64_t{place.t.texel} << kLaneFraction} {
    const ptrdiff_t pitch_texel = pitch_texel_of(texture);
    const Pixel* texels =
        static_cast<const Pixel*>(texture.texels) + place.t.index * pitch_texel + place.s.index;
#pragma GCC unroll 16
    for (int32_t i = 0; i < kVectors; ++i) {
      vectors_[i] = load(texels, pitch_texel);
      texels += kRowsPerVector<kColumnBits> * pitch_texel;
    }
  }

  // The texel whose lanes are 0.
  [[nodiscard]] HWY_INLINE Lane origin() const { return origin_; }

  // By lanes that are counted from the origin, of so many bits of fraction.
  template <int kFraction>
  [[nodiscard]] HWY_INLINE V32 texels(const LaneVectors& lanes) const {
    constexpr int32_t kRows = kVectors * kRowsPerVector<kColumnBits>;
    const V32 index =
        FixedLanes<Address>::template window_index<kColumnBits, kFraction>(lanes, kRows);
    V32 picked = permute(0, index);
#pragma GCC unroll 16
    for (int32_t i = kVectorsPerPermute; i < kVectors; i += kVectorsPerPermute) {
      const V32 before = hn::Set(D32(), i * kLanes - 1);
      picked = hn::IfThenElse(hn::Gt(index, before), permute(i, index), picked);
    }
    return picked;
  }

 private:
  static HWY_INLINE V32 load(const Pixel* texels, ptrdiff_t pitch_texel) {
    if constexpr (kRowsPerVector<kColumnBits> == 1) {
      return load_row<D32>(texels);
    } else {
      using Half = hn::Half<D32>;
      return hn::Combine(D32(), load_row<Half>(texels + pitch_texel), load_row<Half>(texels));
    }
  }
  [[nodiscard]] HWY_INLINE V32 permute(int32_t i, V32 index) const {
#if HWY_TARGET == HWY_AVX3
    return V32{_mm512_permutex2var_epi32(vectors_[i].raw, index.raw, vectors_[i + 1].raw)};
#elif HWY_TARGET == HWY_AVX2
    return V32{_mm256_permutevar8x32_epi32(vectors_[i].raw, index.raw)};
#else
    static_cast<void>(i);
    return index;
#endif
  }

  V32 vectors_[kVectors];
  Lane origin_;
};

// Each draws pixels of a vector from a window, and returns what the lanes of pixels lack changes in
// them, beside what that changed before: all,
template <class Pixel, class OneWindow, class Low>
[[nodiscard]] HWY_INLINE V32 draw_whole(const OneWindow& window, const Low& low,
                                        const LaneVectors& lanes, V32 changed, Pixel* to) {
  store_pixels(window.template texels<Low::kFraction>(lanes), kLanes, to);
  return hn::Or(changed, low.changes(lanes));
}
// the first ones, maybe none or all, without a branch,
template <class Pixel, class OneWindow, class Low>
[[nodiscard]] HWY_INLINE V32 draw_some(const OneWindow& window, const Low& low,
                                       const LaneVectors& lanes, int32_t count_px, V32 changed,
                                       Pixel* to) {
  const D32 d;
  const auto is_pixel = hn::Gt(hn::Set(d, count_px), hn::Iota(d, 0));
  const V32 texels = window.template texels<Low::kFraction>(lanes);
  if constexpr (kHasMask && sizeof(Pixel) == sizeof(int32_t)) {
    hn::BlendedStore(texels, is_pixel, d, reinterpret_cast<int32_t*>(to));
  } else {
    store_first(texels, count_px, to);
  }
  return hn::IfThenElse(is_pixel, hn::Or(changed, low.changes(lanes)), changed);
}
// and the first ones where most vectors are whole. With a mask there is no need to ask.
template <class Pixel, class OneWindow, class Low>
[[nodiscard]] HWY_INLINE V32 draw_first(const OneWindow& window, const Low& low,
                                        const LaneVectors& lanes, int32_t count_px, V32 changed,
                                        Pixel* to) {
  constexpr bool kByMask = kHasMask && sizeof(Pixel) == sizeof(int32_t);
  return !kByMask && HWY_LIKELY(count_px >= kLanes)
             ? draw_whole(window, low, lanes, changed, to)
             : draw_some(window, low, lanes, count_px, changed, to);
}

// Calls draw(window) with a window of so many vectors, or of fewer.
template <class Pixel, class Address, int kColumnBits, int32_t kVectors = kMostWindowVectors,
          class Draw>
[[nodiscard]] HWY_INLINE bool with_window(const selvage_texture& texture, const WindowPlace& place,
                                          const Draw& draw) {
  if constexpr (kVectors > kVectorsPerPermute) {
    if (place.vectors < kVectors) {
      return with_window<Pixel, Address, kColumnBits, kVectors - kVectorsPerPermute>(texture, place,
                                                                                     draw);
    }
  }
  return draw(Window<Pixel, Address, kColumnBits, kVectors>(texture, place));
}

// The same with one of window_vectors<kTwoSizes>().
template <class Pixel, class Address, int kColumnBits, bool kTwoSizes, class Draw>
[[nodiscard]] HWY_INLINE bool with_window_as(const selvage_texture& texture,
                                             const WindowPlace& place, const Draw& draw) {
  if constexpr (!kTwoSizes) {
    return with_window<Pixel, Address, kColumnBits>(texture, place, draw);
  } else {
    return place.vectors == kFewWindowVectors
               ? draw(Window<Pixel, Address, kColumnBits, kFewWindowVectors>(texture, place))
               : draw(Window<Pixel, Address, kColumnBits, kMostWindowVectors>(texture, place));
  }
}

// A window whose texels need no clamping is the same whatever the address mode: one function for
// all of them.
template <class Pixel, int kColumnBits, bool kTwoSizes, class Draw>
[[nodiscard]] HWY_NOINLINE bool with_window_inside(const selvage_texture& texture,
                                                   const WindowPlace& place, const Draw& draw) {
  return with_window_as<Pixel, Addressed<InsideVector>, kColumnBits, kTwoSizes>(texture, place,
                                                                                draw);
}
template <class Pixel, int kColumnBits, bool kTwoSizes, class Draw>
[[nodiscard]] HWY_NOINLINE bool with_window_clamped(const selvage_texture& texture,
                                                    const WindowPlace& place, const Draw& draw) {
  return with_window_as<Pixel, Addressed<ClampVector>, kColumnBits, kTwoSizes>(texture, place,
                                                                               draw);
}

// What draw(window) returns, or false where no window of so many columns holds the texels. Those
// that clamp are seldom.
template <class Pixel, class Address, int kColumnBits, class Draw>
[[nodiscard]] HWY_INLINE bool with_window_of(const TexelRanges& texels,
                                             const selvage_texture& texture, const Draw& draw) {
  constexpr bool kTwoSizes = Draw::kTwoSizes || Address::kClampsWindows;
  const auto place = place_of<Address, kColumnBits, kTwoSizes>(texels, texture);
  if (place.vectors == 0) return false;
  if constexpr (Address::kClampsWindows) {
    return with_window_clamped<Pixel, kColumnBits, kTwoSizes>(texture, place, draw);
  } else {
    return with_window_inside<Pixel, kColumnBits, kTwoSizes>(texture, place, draw);
  }
}

// The same of as many columns as it takes. Where it returns false it has drawn nothing.
template <class Pixel, class Address, class Draw>
[[nodiscard]] HWY_INLINE bool with_smallest_window(const TexelRanges& texels,
                                                   const selvage_texture& texture,
                                                   const Draw& draw) {
  return with_window_of<Pixel, Address, kHalfColumnBits>(texels, texture, draw) ||
         with_window_of<Pixel, Address, kWindowColumnBits>(texels, texture, draw);
}

// What draw(window) returns, or false where there is no such window. Where it returns false it has
// drawn nothing, and may be called with another.
template <class Pixel, class Address, class Draw>
[[nodiscard]] HWY_INLINE bool with_one_window(const TexelBox& box, const selvage_texture& texture,
                                              const Draw& draw) {
  if (!kHasWindows || texture.layout != SELVAGE_LAYOUT_ROWS) return false;
  const TexelRanges texels(box);
  return texels.within(texture)
             ? with_smallest_window<Pixel, Addressed<InsideVector>>(texels, texture, draw)
             : with_smallest_window<Pixel, Address>(texels, texture, draw);
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
