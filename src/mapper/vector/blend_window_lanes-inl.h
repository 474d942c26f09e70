// From lanes to windows of the texture to pixels. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_BLEND_WINDOW_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_BLEND_WINDOW_LANES_INL_H
#undef SELVAGE_VECTOR_BLEND_WINDOW_LANES_INL_H
#else
#define SELVAGE_VECTOR_BLEND_WINDOW_LANES_INL_H
#endif

#include "mapper/vector/blend_window-inl.h"
#include "mapper/vector/store-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

inline constexpr int64_t kOneTexel_fx24 = int64_t{1} << kWindowFraction;

// The least lanes of a vector of pixels, of u - 1/2 and v - 1/2.
struct Anchor_fx24 {
  int64_t u, v;
};

// Where a window begins, along u or along v.
struct WindowOrigin {
  int32_t texel;       // of the texture
  int32_t shift_fx24;  // from lanes, modulo 2^32, to those of the window

  // At `last` at the latest, so that the window lies in the texture.
  static HWY_INLINE WindowOrigin of(int64_t anchor_fx24, int32_t last) {
    const int32_t texel = HWY_MIN(floor_texel(anchor_fx24), last);
    return {texel, back_by(texel)};
  }
  // The same where lanes may lie beyond the texture: those far away are as good as some nearer.
  static HWY_INLINE WindowOrigin clamped(int64_t anchor_fx24, int32_t last, int32_t size_texel) {
    const int64_t near_fx24 =
        HWY_MAX(HWY_MIN(anchor_fx24, (size_texel + kBeyond_texel) * kOneTexel_fx24),
                -kBeyond_texel * kOneTexel_fx24);
    const int32_t texel = HWY_MAX(0, HWY_MIN(floor_texel(near_fx24), last));
    return {texel, back_by(texel, near_fx24 - anchor_fx24)};
  }
  // The same of a texture that repeats: the window does not lie in it if it begins after `last`.
  static HWY_INLINE WindowOrigin wrapped(int64_t anchor_fx24, int32_t size_texel) {
    const int32_t texel = floor_texel(anchor_fx24);
    return {Wrap::index(texel, size_texel), back_by(texel)};
  }

  // How far a lane lies above it.
  HWY_INLINE int64_t above(int64_t lane_fx24) const { return lane_fx24 - texel * kOneTexel_fx24; }

  // Lanes of the window within the texture: the mean there is that of texels clamped one by one.
  HWY_INLINE V32 clamp(V32 lanes, int32_t size_texel) const {
    const D32 d;
    const int32_t least = HWY_MIN(texel, kMost_texel);
    const int32_t most = HWY_MIN(size_texel - 1 - texel, kMost_texel);
    return hn::Min(hn::Max(lanes, hn::Set(d, -least * (1 << kWindowFraction))),
                   hn::Set(d, most * (1 << kWindowFraction)));
  }

 private:
  // Further than a vector is long, and so near that lanes from a window in the texture fit.
  static constexpr int32_t kBeyond_texel = 32, kMost_texel = 100;
  static_assert(kBeyond_texel >= kMostLanes && kBeyond_texel + 2 * kMostLanes < kMost_texel);
  static_assert(kMost_texel < 1 << (31 - kWindowFraction));

  static HWY_INLINE int32_t floor_texel(int64_t lane_fx24) {
    return static_cast<int32_t>(lane_fx24 >> kWindowFraction);
  }
  // Modulo 2^32.
  static HWY_INLINE int32_t back_by(int32_t texel, int64_t nearer_by_fx24 = 0) {
    return static_cast<int32_t>(static_cast<uint32_t>(nearer_by_fx24) -
                                (static_cast<uint32_t>(texel) << kWindowFraction));
  }
};

// Draws vectors of pixels whose texels lie in a window each: by the mean of four, or bilinear.
template <class Window, bool kFour>
class WindowBlender {
 public:
  HWY_INLINE WindowBlender(const Surface& surface, int32_t lack_fx24)
      : texels_(static_cast<const uint32_t*>(surface.texture.texels)),
        pitch_texel_(pitch_texel_of(surface.texture)),
        width_texel_(surface.texture.width),
        height_texel_(surface.texture.height),
        clamps_(surface.address == SELVAGE_ADDRESS_CLAMP),
        sure_(hn::Set(D32(), ~lack_fx24)) {}

  // `lanes` are from(u_shift_fx24, v_shift_fx24), shifted by so much; v is no more than
  // `v_reach_fx24` above the anchor; `inside` is that all of them have their four texels in the
  // texture. False, and nothing is drawn, where one is a near-tie, or no window holds them. Rather
  // few may be pixels, the first ones.
  template <class Lanes>
  HWY_INLINE bool draw(const Lanes& from, const Anchor_fx24& anchor, int32_t v_reach_fx24,
                       bool inside, int32_t count_px, uint32_t* pixels) const {
    const WindowOrigin s = WindowOrigin::of(anchor.u, width_texel_ - Window::kColumns);
    const WindowOrigin t = WindowOrigin::of(anchor.v, height_texel_ - Window::kRows);
    const WindowLanes lanes = from(s.shift_fx24, t.shift_fx24);
    if (HWY_UNLIKELY(any_near(lanes))) return false;
    if (HWY_UNLIKELY(!inside)) return draw_at_sides(lanes, s, t, anchor, count_px, pixels);
    if constexpr (Window::kHasSmaller) {
      using Smaller = typename Window::Smaller;
      if (t.above(anchor.v) + v_reach_fx24 < (Smaller::kRows - 1) * kOneTexel_fx24) {
        blend<Smaller>(lanes, s, t, Smaller::kRows, count_px, pixels);
        return true;
      }
    }
    blend<Window>(lanes, s, t, Window::kRows, count_px, pixels);
    return true;
  }

 private:
  // The same of lanes from `s` and `t` on that are beyond the texture, or that have no texel right
  // of or below them.
  HWY_INLINE bool draw_at_sides(const WindowLanes& lanes, const WindowOrigin& s,
                                const WindowOrigin& t, const Anchor_fx24& anchor, int32_t count_px,
                                uint32_t* pixels) const {
    const int32_t last_column = width_texel_ - Window::kColumns;
    const int32_t last_row = height_texel_ - Window::kRows;
    if (clamps_) {
      // Below the last row there is nothing to pick: it may be the last upper one.
      const WindowOrigin left = WindowOrigin::clamped(anchor.u, last_column, width_texel_);
      const WindowOrigin top = WindowOrigin::clamped(anchor.v, last_row + 1, height_texel_);
      const V32 u = weighted(shifted(lanes.u, s, left)), v = weighted(shifted(lanes.v, t, top));
      blend_weighted<Window>({left.clamp(u, width_texel_), top.clamp(v, height_texel_)}, left, top,
                             height_texel_ - top.texel, count_px, pixels);
      return true;
    }
    const WindowOrigin left = WindowOrigin::wrapped(anchor.u, width_texel_);
    const WindowOrigin top = WindowOrigin::wrapped(anchor.v, height_texel_);
    if (left.texel > last_column || top.texel > last_row) return false;
    blend<Window>({shifted(lanes.u, s, left), shifted(lanes.v, t, top)}, left, top, Window::kRows,
                  count_px, pixels);
    return true;
  }

  // Lanes from `to` on instead of `from`.
  static HWY_INLINE V32 shifted(V32 lanes, const WindowOrigin& from, const WindowOrigin& to) {
    const uint32_t by_fx24 =
        static_cast<uint32_t>(to.shift_fx24) - static_cast<uint32_t>(from.shift_fx24);
    return hn::Add(lanes, hn::Set(D32(), static_cast<int32_t>(by_fx24)));
  }
  template <class From>
  HWY_INLINE void blend(const WindowLanes& lanes, const WindowOrigin& s, const WindowOrigin& t,
                        int32_t rows, int32_t count_px, uint32_t* pixels) const {
    blend_weighted<From>({weighted(lanes.u), weighted(lanes.v)}, s, t, rows, count_px, pixels);
  }
  template <class From>
  HWY_INLINE void blend_weighted(const WindowLanes& lanes, const WindowOrigin& s,
                                 const WindowOrigin& t, int32_t rows, int32_t count_px,
                                 uint32_t* pixels) const {
    const uint32_t* const first = texels_ + (t.texel * pitch_texel_ + s.texel);
    const From window(first, pitch_texel_, rows, constants_);
    store_pixels(mix_corners(window.corners(lanes), lanes, constants_), count_px, pixels);
  }
  // Below the grid are the low words, and the high ones are never more than those of sure_.
  HWY_INLINE bool any_near(const WindowLanes& lanes) const {
    const hn::Repartition<uint16_t, D32> d;
    const auto below = hn::Max(hn::BitCast(d, lanes.u), hn::BitCast(d, lanes.v));
    return !hn::AllFalse(d, hn::Gt(below, hn::BitCast(d, sure_)));
  }
  // The same for bilinear; for four, with weights of a half.
  HWY_INLINE V32 weighted(V32 lanes) const {
    if constexpr (!kFour) return lanes;
    const V32 weights = hn::Set(D32(), 0xFF << kWindowGridFraction);
    return hn::IfVecThenElse(weights, hn::Set(D32(), kTexel_fx8 / 2 << kWindowGridFraction), lanes);
  }

  const uint32_t* texels_;
  ptrdiff_t pitch_texel_;
  int32_t width_texel_, height_texel_;
  bool clamps_;
  V32 sure_;
  BlendConstants constants_;
};

// How many texels the lanes of a vector, and those right of or below them, are in at most, where
// neighbouring pixels are so far apart.
[[nodiscard]] HWY_INLINE int32_t texels_around(int64_t step_fx32) {
  constexpr int64_t kOne = int64_t{1} << kLaneFraction;
  const int64_t rise_fx32 = HWY_MIN(step_fx32 < 0 ? -step_fx32 : step_fx32, kLanes * kOne);
  return static_cast<int32_t>(((kLanes - 1) * rise_fx32 + kOne - 1) >> kLaneFraction) + 2;
}

// Whether all pixels show texels of the texture alone.
[[nodiscard]] HWY_INLINE bool is_inside(const TexelBox& box, const selvage_texture& texture) {
  constexpr int32_t kHalf = 1 << (kTexelFraction - 1);
  const auto has = [](int32_t least_fx16, int32_t most_fx16, int32_t size_texel) {
    return least_fx16 >= kHalf && int64_t{most_fx16} - kHalf < int64_t{size_texel - 1}
                                                                   << kTexelFraction;
  };
  return has(box.least_u_fx16, box.most_u_fx16, texture.width) &&
         has(box.least_v_fx16, box.most_v_fx16, texture.height);
}

// Calls with(std::type_identity<Window>()) for the cheapest window that holds all texels around a
// vector of pixels whose neighbours are so far apart; for none where there is none.
template <class With>
HWY_INLINE void with_blend_window([[maybe_unused]] Lane step_fx32,
                                  [[maybe_unused]] const TexelBox& box,
                                  [[maybe_unused]] const Surface& surface,
                                  [[maybe_unused]] const With& with) {
  if constexpr (kHasBlendWindows) {
    const selvage_texture& texture = surface.texture;
    if (texture.layout != SELVAGE_LAYOUT_ROWS) return;
    // Where a texture repeats, windows across its sides are left to others: they should be few.
    constexpr int32_t kLeastOfWindows = 4;
    const bool all = surface.address == SELVAGE_ADDRESS_CLAMP || is_inside(box, texture);
    const int32_t width_texel = all ? texture.width : texture.width / kLeastOfWindows;
    const int32_t height_texel = all ? texture.height : texture.height / kLeastOfWindows;
    const int32_t columns = texels_around(step_fx32.u_fx32);
    const int32_t rows = texels_around(step_fx32.v_fx32);
    const auto holds = [&](auto window) {
      using Window = typename decltype(window)::type;
      if (columns > Window::kColumns || Window::kColumns > width_texel || rows > Window::kRows ||
          Window::kRows > height_texel) {
        return false;
      }
      with(window);
      return true;
    };
    if constexpr (kLanes == 16) {
      static_cast<void>(holds(std::type_identity<BlendWindow<3, 1>>()) ||
                        holds(std::type_identity<BlendWindow<4, 2>>()) ||
                        holds(std::type_identity<BlendWindow<3, 2>>()) ||
                        holds(std::type_identity<BlendWindow<3, 3>>()) ||
                        holds(std::type_identity<BlendWindow<4, 3>>()) ||
                        holds(std::type_identity<BlendWindow<4, 4>>()) ||
                        holds(std::type_identity<BlendWindow<3, 4>>()) ||
                        holds(std::type_identity<BlendWindow<4, 6>>()) ||
                        holds(std::type_identity<BlendWindow<4, 8>>()));
    } else {
      static_cast<void>(holds(std::type_identity<BlendWindow<3, 1>>()) ||
                        holds(std::type_identity<BlendWindow<3, 2>>()) ||
                        holds(std::type_identity<BlendWindow<3, 3>>()));
    }
  }
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
