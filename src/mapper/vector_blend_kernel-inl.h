// The filters over four texels by vectors: points, the texels around them, their mean. Included
// once for each SIMD target.
#if defined(SELVAGE_VECTOR_BLEND_KERNEL_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_BLEND_KERNEL_INL_H
#undef SELVAGE_VECTOR_BLEND_KERNEL_INL_H
#else
#define SELVAGE_VECTOR_BLEND_KERNEL_INL_H
#endif

#include "mapper/interior.h"
#include "mapper/vector_blend_mix-inl.h"
#include "mapper/vector_blend_pairs-inl.h"
#include "mapper/vector_blend_points-inl.h"

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
      return mix(adjacent(hn::Add(upper, left), hn::Add(lower, left)), u_fx8, v_fx8);
    }
    return mix(apart(Places(hn::Add(upper, left)), Places(hn::Add(upper, right)),
                     Places(hn::Add(lower, left)), Places(hn::Add(lower, right))),
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

// Pixels from points whose four texels are all in a texture of rows.
template <bool kFour>
class Inside4 {
 public:
  explicit Inside4(const LowestRow& lowest, const selvage_texture& texture)
      : upper_(lowest.texels),
        lower_(lowest.texels + texture.pitch),
        first_(hn::Set(D32(), lowest.first_texel)),
        pitch_texel_(hn::Set(D32(), static_cast<int32_t>(pitch_texel_of(texture)))) {}

  HWY_INLINE V32 operator()(const PointVectors& points) const {
    const V32 s = hn::ShiftRight<kGridBits>(points.u_fx8);
    const V32 t = hn::ShiftRight<kGridBits>(points.v_fx8);
    const Places places(hn::Add(hn::Add(hn::Mul(t, pitch_texel_), first_), s));
    const Around<Pairs> texels = gather([&](int32_t i) -> Around<Block> {
      const ptrdiff_t one = places.bytes(i), next = places.bytes(i + 1);
      return {load_block(upper_ + one, upper_ + next), load_block(lower_ + one, lower_ + next)};
    });
    const V32 half = hn::Set(D32(), kTexel_fx8 / 2);
    return mix(texels, kFour ? half : points.u_fx8, kFour ? half : points.v_fx8);
  }

 private:
  const char *upper_, *lower_;
  V32 first_, pitch_texel_;
};

// ---- Spans --------------------------------------------------------------------------------------

HWY_INLINE void store_pixels(V32 pixels, char* row, int32_t px) {
  hn::StoreU(pixels, D32(), reinterpret_cast<int32_t*>(row + px * ptrdiff_t{kTexelBytes}));
}

// Columns [from, to) of a span of kLanes pixels or more, and maybe some of it beyond: what is left
// over is drawn by the last whole vector of the span.
template <class Points, class Blend>
HWY_INLINE void draw_columns(Points& points, const Span& span, int32_t from_px, int32_t to_px,
                             const Surface& surface, const Blend& blend) {
  if (from_px >= to_px) return;
  const int32_t last_px = span.right_px - kLanes;
  int32_t px = HWY_MIN(from_px, last_px);
  char* const row = first_pixel(surface, {span.row, 0, 0});
  points.seek(px, span.row);
  while (true) {
    store_pixels(blend(points.points(kLanes)), row, px);
    px += kLanes;
    if (px >= to_px) return;
    points.advance();
    if (HWY_UNLIKELY(px > last_px)) points.seek(px = last_px, span.row);
  }
}

// A span of less than kLanes pixels.
template <class Points, class Blend>
HWY_INLINE void draw_few(Points& points, const Span& span, const Surface& surface,
                         const Blend& blend) {
  HWY_ALIGN uint32_t pixels[kLanes];
  points.seek(span.left_px, span.row);
  hn::Store(blend(points.points(span.width_px())), D32(), reinterpret_cast<int32_t*>(pixels));
  store_row<uint32_t>(pixels, span.width_px(), first_pixel(surface, span));
}

// Both are copied, so that the loop keeps them in registers.
template <class Blend>
HWY_NOINLINE void draw_inside(const AffinePoints& start, const Span& span, const Surface& surface,
                              const Blend& inside) {
  AffinePoints points = start;
  const Blend blend = inside;
  draw_columns(points, span, span.left_px, span.right_px, surface, blend);
}

template <class Points, class Blend>
HWY_NOINLINE void draw_anywhere(Points& points, const Span& span, int32_t from_px, int32_t to_px,
                                const Surface& surface, const Blend& blend) {
  draw_columns(points, span, from_px, to_px, surface, blend);
}

template <bool kFour, class Address>
void blend_affine(const AffineSpans& spans, const Surface& surface) {
  const Interior interior(spans.field, surface.texture);
  const Anywhere<Address> anywhere(surface.texture, kFour);
  const Inside4<kFour> inside(LowestRow(surface.texture), surface.texture);
  AffinePoints points(spans);
  for (int32_t i = 0; i < spans.batch.rows; ++i) {
    const Span span = spans.batch.span(i);
    if (span.width_px() < kLanes) {
      if (!span.empty()) draw_few(points, span, surface, anywhere);
      continue;
    }
    const Span inner = interior.of(span);
    const bool any_inside = inner.width_px() >= kLanes;
    draw_anywhere(points, span, span.left_px, any_inside ? inner.left_px : span.right_px, surface,
                  anywhere);
    if (any_inside) {
      draw_inside(points, inner, surface, inside);
      draw_anywhere(points, span, inner.right_px, span.right_px, surface, anywhere);
    }
  }
}

template <bool kFour>
void draw_blended_affine(const AffineSpans& spans, const Surface& surface) {
  with_address(surface,
               [&](auto address) { blend_affine<kFour, decltype(address)>(spans, surface); });
}

// Where lanes may lack more than a step of the grid, one decision is not enough.
[[nodiscard]] inline bool are_fine(const ProjectiveLanes& lanes) {
  return lanes.margin_fx32() < uint32_t{1} << kGridFraction;
}

// One body for both filters: it is large, and there is one for each address mode.
template <class Address>
HWY_NOINLINE void blend_projective(const ProjectiveSpan& each, const ExactMap& exact,
                                   const Surface& surface, bool four) {
  const Anywhere<Address> anywhere(surface.texture, four);
  ProjectivePoints points(each, exact);
  if (each.span.width_px() < kLanes) return draw_few(points, each.span, surface, anywhere);
  draw_columns(points, each.span, each.span.left_px, each.span.right_px, surface, anywhere);
}

template <bool kFour>
void draw_blended_projective(const ProjectiveSpans& spans, const Surface& surface) {
  const auto& scalar = scalar_kernels(kFour ? SELVAGE_FILTER_FOUR : SELVAGE_FILTER_BILINEAR);
  with_address(surface, [&](auto address) {
    for (const ProjectiveSpan& each : spans.spans) {
      if (are_fine(each.lanes)) {
        blend_projective<decltype(address)>(each, spans.exact, surface, kFour);
      } else {
        scalar.draw_projective({{&each, 1}, spans.exact}, surface);
      }
    }
  });
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
