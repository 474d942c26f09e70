// Affine spans of the filters over four texels, from windows. Included once for each SIMD target.
//
// Lanes are 8.24 (fx24), modulo 2^32: an anchor, the floor of the least 32.32 lane of a vector's
// pixels, and the floors of the steps from there. So
//
//     lane <= true value < lane + kVectorTruncations_fx24 + margin     (spec/proofs/vector_lanes.g)
//
// in units of 2^-24 texel, and a lane that lacks less to the next step of the grid is sure.
#if defined(SELVAGE_VECTOR_BLEND_AFFINE_WINDOWS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_BLEND_AFFINE_WINDOWS_INL_H
#undef SELVAGE_VECTOR_BLEND_AFFINE_WINDOWS_INL_H
#else
#define SELVAGE_VECTOR_BLEND_AFFINE_WINDOWS_INL_H
#endif

#include "mapper/vector/affine_wide-inl.h"
#include "mapper/vector/blend_window_lanes-inl.h"
#include "mapper/vector/left-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

[[nodiscard]] HWY_INLINE int32_t lack_fx24(const AffineField& field) {
  return fine_lack_fx24(0, field.margin_fx32);
}
inline constexpr int32_t kMostLack_fx24 = 1 << 9;  // with more, near-ties are many

// The least lane of the vectors that begin at a row's pixels, along u or along v.
class AnchorLine {
 public:
  HWY_INLINE AnchorLine(int64_t step_fx32, int32_t size_texel)
      : to_anchor_fx32_(anchor_lane(step_fx32) * step_fx32 - (int64_t{1} << (kLaneFraction - 1))),
        step_fx32_(kLanes * step_fx32),
        offset_(offsets_from_anchor<kWindowShift>(step_fx32)) {
    const int64_t walk_fx32 = (kLanes - 1) * magnitude_fx32(step_fx32);
    reach_fx24_ = static_cast<int32_t>(walk_fx32 >> kWindowShift);
    end_fx32_ =
        static_cast<uint64_t>(HWY_MAX(0, (int64_t{size_texel - 1} << kLaneFraction) - walk_fx32));
  }

  HWY_INLINE void go_to(int64_t lane_fx32) { at_fx32_ = lane_fx32 + to_anchor_fx32_; }
  HWY_INLINE void advance() { at_fx32_ += step_fx32_; }
  HWY_INLINE int64_t anchor_fx24() const { return at_fx32_ >> kWindowShift; }
  // Of the lane that lies furthest above it.
  HWY_INLINE int32_t reach_fx24() const { return reach_fx24_; }
  // Of all lanes from here.
  HWY_INLINE bool inside() const { return static_cast<uint64_t>(at_fx32_) < end_fx32_; }
  HWY_INLINE V32 lanes(int32_t shift_fx24) const {
    const auto anchor = static_cast<uint32_t>(anchor_fx24()) + static_cast<uint32_t>(shift_fx24);
    return hn::Add(hn::Set(D32(), static_cast<int32_t>(anchor)), offset_);
  }

 private:
  int64_t to_anchor_fx32_, step_fx32_, at_fx32_ = 0;
  int32_t reach_fx24_;
  uint64_t end_fx32_;
  V32 offset_;
};

// Draws vectors of pixels from `at` on, but for those it leaves to others.
template <class Window, bool kFour>
HWY_NOINLINE void blend_windows(const AffineSpans& spans, const Surface& surface, Resume* at,
                                Left* left) {
  const AffineField field = spans.field;
  const WindowBlender<Window, kFour> blender(surface, lack_fx24(field));
  AnchorLine u(field.step_x.u_fx32, surface.texture.width);
  AnchorLine v(field.step_x.v_fx32, surface.texture.height);
  char* const pixels = static_cast<char*>(surface.target.pixels);
  const ptrdiff_t pitch = surface.target.pitch;
  int32_t left_count = 0, i = at->row, from_px = at->px;
  for (; i < spans.batch.rows && left_count < Left::kMost; ++i) {
    const Span span = spans.batch.span(i);
    int32_t px = HWY_MAX(span.left_px, from_px);
    from_px = INT32_MIN;
    const Lane first = field.at(px, span.row);
    u.go_to(first.u_fx32);
    v.go_to(first.v_fx32);
    uint32_t* const row = reinterpret_cast<uint32_t*>(pixels + span.row * pitch);
    for (; px < span.right_px; px += kLanes) {
      const bool drawn = blender.draw(
          [&](int32_t u_fx24, int32_t v_fx24) HWY_ATTR -> WindowLanes {
            return {u.lanes(u_fx24), v.lanes(v_fx24)};
          },
          {u.anchor_fx24(), v.anchor_fx24()}, v.reach_fx24(), u.inside() && v.inside(),
          span.right_px - px, row + px);
      u.advance();
      v.advance();
      if (HWY_LIKELY(drawn)) continue;
      left->rest[static_cast<size_t>(left_count++)] = {span.row, px, span.right_px};
      if (left_count == Left::kMost) {
        from_px = px + kLanes;
        --i;
        break;
      }
    }
  }
  left->count = left_count;
  *at = {i, from_px};
}

template <class Spans>
using BlendWindows = void (*)(const Spans& spans, const Surface& surface, Resume* at, Left* left);

// Or NULL.
template <bool kFour>
[[nodiscard]] HWY_INLINE BlendWindows<AffineSpans> blend_windows_for(const AffineSpans& spans,
                                                                     const Surface& surface) {
  if (lack_fx24(spans.field) > kMostLack_fx24) return nullptr;
  BlendWindows<AffineSpans> found = nullptr;
  with_blend_window(spans.field.step_x, spans.texels, surface, [&](auto window) {
    using Window = typename decltype(window)::type;
    found = blend_windows<Window, kFour>;
  });
  return found;
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
