// Projective spans, a vector of pixels of one row at a time. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_PROJECTIVE_WIDE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_PROJECTIVE_WIDE_INL_H
#undef SELVAGE_VECTOR_PROJECTIVE_WIDE_INL_H
#else
#define SELVAGE_VECTOR_PROJECTIVE_WIDE_INL_H
#endif

#include "mapper/steepness.h"
#include "mapper/vector/fetch-inl.h"
#include "mapper/vector/left-inl.h"
#include "mapper/vector/projective_kernel-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// 16.16 lanes of a span in perspective, in units of 2^-16 texel:
//
//     lane <= true value < lane + 2 error + 1                       (spec/proofs/divided_lanes.g)
class DividedVectors {
 public:
  HWY_INLINE explicit DividedVectors(const DividedLanes& lanes)
      : u_(scaled(lanes.u_numerator_fx32())),
        v_(scaled(lanes.v_numerator_fx32())),
        denominator_(lanes.denominator()),
        error_fx16_(static_cast<double>(lanes.error_fx32()) * kUnit_fx16) {}

  [[nodiscard]] static HWY_INLINE int32_t lack_fx16(const DividedLanes& lanes) {
    return static_cast<int32_t>(2 * lanes.error_fx32() >> kFraction) + kDividedTruncations_fx16;
  }

  // Of kLanes pixels.
  HWY_INLINE LaneVectors lanes_from(int32_t offset_px) const {
    const DD d;
    const VD i = hn::Add(hn::Iota(d, 0.0), hn::Set(d, static_cast<double>(offset_px)));
    const VD j = hn::Add(i, hn::Set(d, static_cast<double>(kDoubles)));
    const VD w_i = hn::Div(hn::Set(d, 1.0), at(denominator_, i));
    const VD w_j = hn::Div(hn::Set(d, 1.0), at(denominator_, j));
    return {hn::Combine(D32(), lanes(u_, j, w_j), lanes(u_, i, w_i)),
            hn::Combine(D32(), lanes(v_, j, w_j), lanes(v_, i, w_i))};
  }

 private:
  using Linear = DividedLanes::Linear;
  static constexpr int kFraction = kLaneFraction - kTexelFraction;
  static constexpr double kUnit_fx16 = 1.0 / (1 << kFraction);

  static Linear scaled(const Linear& fx32) {
    return {fx32.start * kUnit_fx16, fx32.step * kUnit_fx16};
  }
  static HWY_INLINE VD at(const Linear& line, VD i) {
    const DD d;
    return hn::MulAdd(i, hn::Set(d, line.step), hn::Set(d, line.start));
  }
  HWY_INLINE hn::Vec<DHalf> lanes(const Linear& numerator, VD i, VD w) const {
    const VD low = hn::Sub(hn::Mul(at(numerator, i), w), hn::Set(DD(), error_fx16_));
    return hn::DemoteTo(DHalf(), hn::Floor(low));
  }

  Linear u_, v_, denominator_;
  double error_fx16_;
};

inline constexpr double kTooSteep_fx32 = 0x1p33;  // two texels: no window is for that

[[nodiscard]] HWY_INLINE int32_t window_rows(const DividedLanes& lanes, int32_t width_px,
                                             const selvage_texture& texture) {
  if (!kHasWindows || width_px < 2 * kLanes) return 0;  // finding out would cost more than it saves
  const auto step_fx32 = [&](const DividedLanes::Linear& numerator) {
    const double steepest = steepest_fx32(numerator, lanes.denominator(), width_px);
    return static_cast<int64_t>(HWY_MIN(steepest, kTooSteep_fx32)) + 1;
  };
  return window_rows({step_fx32(lanes.u_numerator_fx32()), step_fx32(lanes.v_numerator_fx32())},
                     texture);
}

// What draws some vectors of a span.
struct DividedSpan {
  const DividedLanes& lanes;
  Span span;
};

// Calls draw(px, count_px, lanes) for each vector of pixels from *px on; false from it leaves the
// vector to others. Returns at the end, or where no more can be left.
template <class Draw>
HWY_INLINE void for_each_vector(const DividedSpan& of, int32_t* px, Left* left, const Draw& draw) {
  const DividedVectors vectors(of.lanes);
  const Span span = of.span;
  int32_t at_px = *px, left_count = 0;
  for (; at_px < span.right_px && left_count < Left::kMost; at_px += kLanes) {
    if (HWY_UNLIKELY(
            !draw(at_px, span.right_px - at_px, vectors.lanes_from(at_px - span.left_px)))) {
      left->rest[static_cast<size_t>(left_count++)] = {span.row, at_px, span.right_px};
    }
  }
  *px = at_px;
  left->count = left_count;
}

// Along a span u and v rise or fall all the way: its ends have the least and the most.
template <class Pixel, class Address>
HWY_NOINLINE void draw_windows(const DividedSpan& of, const Surface& surface, int32_t rows,
                               int32_t* px, Left* left) {
  const FixedLanes<Address> fixed(surface.texture, DividedVectors::lack_fx16(of.lanes));
  const Extent extent = extent_of(surface.texture);
  const auto* const texels = static_cast<const Pixel*>(surface.texture.texels);
  const int32_t last_column = extent.width_texel - kLanes, last_row = extent.height_texel - rows;
  Pixel* const pixels = reinterpret_cast<Pixel*>(first_pixel(surface, {of.span.row, 0, 0}));
  for_each_vector(
      of, px, left, [&](int32_t at_px, int32_t count_px, const LaneVectors& lanes) HWY_ATTR {
        HWY_ALIGN int32_t u_fx16[kLanes], v_fx16[kLanes];
        hn::Store(lanes.u, D32(), u_fx16);
        hn::Store(lanes.v, D32(), v_fx16);
        const int32_t end = HWY_MIN(count_px, kLanes) - 1;
        const Origin s = Address::origin(HWY_MIN(u_fx16[0], u_fx16[end]) >> kTexelFraction,
                                         last_column, extent.width_texel);
        const Origin t = Address::origin(HWY_MIN(v_fx16[0], v_fx16[end]) >> kTexelFraction,
                                         last_row, extent.height_texel);
        if (fixed.any_near(lanes) || s.index > last_column || t.index > last_row) return false;
        const auto from = [](V32 lane, int32_t texel) HWY_ATTR {
          return hn::Sub(lane, hn::ShiftLeft<kTexelFraction>(hn::Set(D32(), texel)));
        };
        const V32 index = fixed.template window_index<kWindowColumnBits>(
            {from(lanes.u, s.texel), from(lanes.v, t.texel)}, rows);
        const Pixel* const window = texels + t.index * ptrdiff_t{extent.pitch_texel} + s.index;
        store_pixels(pick<kWindowColumnBits>(window, extent.pitch_texel, rows, index), count_px,
                     pixels + at_px);
        return true;
      });
}

// A load for each pixel of a vector of them.
template <class Pixel, class Address, class Fetch>
HWY_NOINLINE void draw_loads(const DividedSpan& of, const Surface& surface, Fetch* fetch,
                             int32_t* px, Left* left) {
  const FixedLanes<Address> fixed(surface.texture, DividedVectors::lack_fx16(of.lanes));
  Pixel* const pixels = reinterpret_cast<Pixel*>(first_pixel(surface, {of.span.row, 0, 0}));
  for_each_vector(
      of, px, left, [&](int32_t at_px, int32_t count_px, const LaneVectors& lanes) HWY_ATTR {
        if (fixed.any_near(lanes)) return false;
        fetch->add(fixed.places(lanes), count_px, reinterpret_cast<char*>(pixels + at_px));
        return true;
      });
}

// Of pixels that are near-ties for lanes of 16.16, few are for the doubles that these are made of.
HWY_NOINLINE void decide_left(const Left& left, const DividedSpan& of, RowOfTies* ties,
                              LeftTexels* texels) {
  const ProjectiveRow row(of.lanes, 1.0);
  for (int32_t i = 0; i < left.count; ++i) {
    const int32_t offset_px = left.at(i).left_px - of.span.left_px;
    LowTexels low = row.low(offset_px);
    if (low.near_u || low.near_v) {
      ties->decide(offset_px, row.near(offset_px, low), &low.s, &low.t);
    }
    texels->put(i, {low.s, low.t}, 0);
  }
}

template <class Pixel, class Address>
HWY_NOINLINE void draw_left(const Left& left, const DividedSpan& of, const Surface& surface,
                            RowOfTies* ties) {
  LeftTexels texels;
  decide_left(left, of, ties, &texels);
  draw_left<Pixel, Address>(left, texels, surface);
}

template <class Pixel, class Address, class Fetch>
void draw_wide_projective(const ProjectiveSpans& spans, const Surface& surface) {
  Fetch fetch(surface.texture.texels);
  Left left;
  const auto margin_fx32 = static_cast<uint32_t>(2 * spans.field.error_fx32);
  RowOfTies ties(spans.exact, spans.batch.span(0), 0, spare_bits_fx32(margin_fx32));
  for (int32_t i = 0; i < spans.batch.rows; ++i) {
    const Span span = spans.batch.span(i);
    const DividedLanes lanes = spans.field.of(span);
    const DividedSpan of{lanes, span};
    ties.go_to(span);
    const int32_t rows = window_rows(lanes, span.width_px(), surface.texture);
    for (int32_t px = span.left_px; px < span.right_px;) {
      if (kHasWindows && rows != 0) {
        draw_windows<Pixel, Address>(of, surface, rows, &px, &left);
      } else {
        draw_loads<Pixel, Address>(of, surface, &fetch, &px, &left);
      }
      if (left.count != 0) draw_left<Pixel, Address>(left, of, surface, &ties);
    }
  }
  fetch.finish();
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
