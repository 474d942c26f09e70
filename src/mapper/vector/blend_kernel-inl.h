// The filters over four texels by vectors: points, the texels around them, their mean. Included
// once for each SIMD target.
#if defined(SELVAGE_VECTOR_BLEND_KERNEL_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_BLEND_KERNEL_INL_H
#undef SELVAGE_VECTOR_BLEND_KERNEL_INL_H
#else
#define SELVAGE_VECTOR_BLEND_KERNEL_INL_H
#endif

#include "mapper/interior.h"
#include "mapper/vector/blend_left-inl.h"
#include "mapper/vector/blend_mix-inl.h"
#include "mapper/vector/blend_pairs-inl.h"
#include "mapper/vector/blend_points-inl.h"
#include "mapper/vector/entries-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// Pixels from points, wherever those are: each texel is addressed by itself. Whatever a lane means,
// its places are valid.
template <class Address>
class Anywhere {
 public:
  HWY_INLINE Anywhere(const selvage_texture& texture, bool four)
      : lowest_(texture),
        extent_(extent_of(texture)),
        kept_(hn::Set(D32(), four ? 0 : kTexel_fx8 - 1)),
        set_(hn::Set(D32(), four ? kTexel_fx8 / 2 : 0)) {}

  HWY_INLINE V32 operator()(const PointVectors& points) const {
    const D32 d;
    const V32 one = hn::Set(d, 1);
    const V32 s = hn::ShiftRight<kGridBits>(points.u_fx8);
    const V32 t = hn::ShiftRight<kGridBits>(points.v_fx8);
    const V32 left = Address::column(s, extent_);
    const V32 right = Address::column(hn::Add(s, one), extent_);
    const V32 first = hn::Set(d, lowest_.first_texel);
    const V32 upper = hn::Add(first, Address::row(t, extent_));
    const V32 lower = hn::Add(first, Address::row(hn::Add(t, one), extent_));
    const V32 u_fx8 = weights(points.u_fx8), v_fx8 = weights(points.v_fx8);
    if (HWY_LIKELY(hn::AllTrue(d, hn::Eq(hn::Sub(right, left), one)))) {
      return mix(channels_of(adjacent(hn::Add(upper, left), hn::Add(lower, left))), u_fx8, v_fx8);
    }
    return mix(channels_of(apart(Places(hn::Add(upper, left)), Places(hn::Add(upper, right)),
                                 Places(hn::Add(lower, left)), Places(hn::Add(lower, right)))),
               u_fx8, v_fx8);
  }

 private:
  HWY_INLINE V32 weights(V32 point_fx8) const { return hn::Or(hn::And(point_fx8, kept_), set_); }
  HWY_INLINE Around<Pairs> adjacent(V32 upper_places, V32 lower_places) const {
    const Places upper(upper_places), lower(lower_places);
    const char* const texels = lowest_.texels;
    return gather([&](int32_t i) -> Around<Block> {
      return {load_block(texels + upper.bytes(i), texels + upper.bytes(i + 1)),
              load_block(texels + lower.bytes(i), texels + lower.bytes(i + 1))};
    });
  }
  HWY_INLINE Around<Pairs> apart(const Places& upper_left, const Places& upper_right,
                                 const Places& lower_left, const Places& lower_right) const {
    const char* const texels = lowest_.texels;
    const auto pair = [&](const Places& left, const Places& right, int32_t i) {
      return load_pair(texels + left.bytes(i), texels + right.bytes(i));
    };
    return gather([&](int32_t i) -> Around<Block> {
      return {block_of(pair(upper_left, upper_right, i), pair(upper_left, upper_right, i + 1)),
              block_of(pair(lower_left, lower_right, i), pair(lower_left, lower_right, i + 1))};
    });
  }

  LowestRow lowest_;
  Extent extent_;
  V32 kept_, set_;
};

template <bool kFour>
[[nodiscard]] HWY_INLINE V32 mix_at(const PointVectors& points, const Around<Pairs>& channels) {
  const V32 half = hn::Set(D32(), kTexel_fx8 / 2);
  return mix(channels, kFour ? half : points.u_fx8, kFour ? half : points.v_fx8);
}

// Pixels from points whose four texels are all in a texture of rows.
template <bool kFour>
class Inside {
 public:
  explicit Inside(const selvage_texture& texture)
      : upper_(LowestRow(texture).texels),
        lower_(upper_ + texture.pitch),
        first_(hn::Set(D32(), LowestRow(texture).first_texel)),
        pitch_texel_(hn::Set(D32(), static_cast<int32_t>(pitch_texel_of(texture)))) {}

  HWY_INLINE V32 operator()(const PointVectors& points) const {
    const V32 s = hn::ShiftRight<kGridBits>(points.u_fx8);
    const V32 t = hn::ShiftRight<kGridBits>(points.v_fx8);
    const Places places(hn::Add(hn::Add(hn::Mul(t, pitch_texel_), first_), s));
    const Around<Pairs> texels = gather([&](int32_t i) -> Around<Block> {
      const ptrdiff_t one = places.bytes(i), next = places.bytes(i + 1);
      return {load_block(upper_ + one, upper_ + next), load_block(lower_ + one, lower_ + next)};
    });
    return mix_at<kFour>(points, channels_of(texels));
  }

 private:
  const char *upper_, *lower_;
  V32 first_, pitch_texel_;
};

// ---- Spans --------------------------------------------------------------------------------------

HWY_INLINE void store_blended(V32 pixels, char* row, int32_t px) {
  hn::StoreU(pixels, D32(), reinterpret_cast<int32_t*>(row + px * ptrdiff_t{kTexelBytes}));
}

// Columns [from, to) of a span of kLanes pixels or more, and maybe some of it beyond: what is left
// over is drawn by the last whole vector of the span. The blend is copied: what is not reachable
// from outside needs no reloading after each store.
template <class Steps, class Blend>
HWY_NOINLINE void draw_columns(const Steps& steps, const Span& span, int32_t from_px, int32_t to_px,
                               const Surface& surface, RowOfTies* ties, const Blend& of) {
  if (from_px >= to_px) return;
  const Blend blend = of;
  char* const pixels = first_pixel(surface, {span.row, 0, 0});
  const int32_t last_px = span.right_px - kLanes, row = span.row;
  int32_t px = HWY_MIN(from_px, last_px);
  typename Steps::Points points(steps, px, row, ties);
  while (true) {
    store_blended(blend(points.points()), pixels, px);
    px += kLanes;
    if (px > HWY_MIN(last_px, to_px - 1)) break;
    points.advance();
  }
  if (px >= to_px) return;
  const typename Steps::Points rest(steps, last_px, row, ties);
  store_blended(blend(rest.points()), pixels, last_px);
}

// A span of less than kLanes pixels.
template <class Steps, class Blend>
HWY_INLINE void draw_few(const Steps& steps, const Span& span, const Surface& surface,
                         RowOfTies* ties, const Blend& blend) {
  const typename Steps::Points points(steps, span.left_px, span.row, ties);
  store_pixels(blend(points.points()), span.width_px(),
               reinterpret_cast<uint32_t*>(first_pixel(surface, span)));
}

// The blend of the inside for the pixels that are there, and the other for those at both ends.
template <class BlendAnywhere, class BlendInside>
HWY_INLINE void draw_span(const AffineSteps& steps, const Span& span, const Span& inner,
                          const Surface& surface, RowOfTies* ties, const BlendAnywhere& anywhere,
                          const BlendInside& inside) {
  if (inner.width_px() < kLanes) {
    return draw_columns(steps, span, span.left_px, span.right_px, surface, ties, anywhere);
  }
  draw_columns(steps, span, span.left_px, inner.left_px, surface, ties, anywhere);
  draw_columns(steps, inner, inner.left_px, inner.right_px, surface, ties, inside);
  draw_columns(steps, span, inner.right_px, span.right_px, surface, ties, anywhere);
}

template <bool kFour, class Address>
void blend_affine(const AffineSpans& spans, const Surface& surface) {
  const Anywhere<Address> anywhere(surface.texture, kFour);
  int32_t first_row = 0;
  if (const auto windows = blend_windows_for<kFour>(spans, surface)) {
    first_row = draw_by_windows(spans, surface, windows, anywhere);
    if (HWY_LIKELY(first_row == spans.batch.rows)) return;
  }
  const Inside<kFour> inside(surface.texture);
  const Interior interior(spans.field, surface.texture);
  const AffineSteps steps(spans);
  for (int32_t i = first_row; i < spans.batch.rows; ++i) {
    const Span span = spans.batch.span(i);
    RowOfTies ties(spans.exact, span, kGridBits, 0);
    if (span.width_px() >= kLanes) {
      draw_span(steps, span, interior.of(span), surface, &ties, anywhere, inside);
    } else if (!span.empty()) {
      draw_few(steps, span, surface, &ties, anywhere);
    }
  }
}

template <bool kFour>
HWY_INLINE void draw_blended_affine(const AffineSpans& spans, const Surface& surface) {
  with_address(surface,
               [&](auto address) { blend_affine<kFour, decltype(address)>(spans, surface); });
}

// Lanes lack less than a step of the grid, so that one decision is enough.
static_assert(2 * (int64_t{kMostReach} + kProjectiveTruncations_fx32) >> kGridFraction == 0);

// One body for both filters: it is large, and there is one for each address mode.
template <class Address>
HWY_NOINLINE void blend_projective(const ProjectiveSpans& spans, const Surface& surface,
                                   bool four) {
  const Anywhere<Address> anywhere(surface.texture, four);
  const BlendWindows<ProjectiveSpans> windows =
      four ? blend_windows_for<true>(spans, surface) : blend_windows_for<false>(spans, surface);
  const int32_t first_row =
      windows == nullptr ? 0 : draw_by_windows(spans, surface, windows, anywhere);
  for (int32_t i = first_row; i < spans.batch.rows; ++i) {
    const Span span = spans.batch.span(i);
    const ProjectiveSteps steps(spans, span);
    RowOfTies ties(spans.exact, span, kGridBits, 0);
    if (span.width_px() >= kLanes) {
      draw_columns(steps, span, span.left_px, span.right_px, surface, &ties, anywhere);
    } else if (!span.empty()) {
      draw_few(steps, span, surface, &ties, anywhere);
    }
  }
}

HWY_INLINE void draw_blended_projective(const ProjectiveSpans& spans, const Surface& surface,
                                        bool four) {
  with_address(surface,
               [&](auto address) { blend_projective<decltype(address)>(spans, surface, four); });
}

}  // namespace

void draw_four_affine(const AffineSpans& spans, const Surface& surface) {
  draw_blended_affine<true>(spans, surface);
}
void draw_bilinear_affine(const AffineSpans& spans, const Surface& surface) {
  draw_blended_affine<false>(spans, surface);
}
void draw_four_projective(const ProjectiveSpans& spans, const Surface& surface) {
  draw_blended_projective(spans, surface, true);
}
void draw_bilinear_projective(const ProjectiveSpans& spans, const Surface& surface) {
  draw_blended_projective(spans, surface, false);
}

}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
