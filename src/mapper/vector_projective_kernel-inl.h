// Projective spans by vectors of doubles. Included once for each SIMD target.
//
// The same numerators, denominators and bound as DividedLanes: u lies in (estimate - error,
// estimate + error), so where both ends have one floor, that is the texel.
#if defined(SELVAGE_VECTOR_PROJECTIVE_KERNEL_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_PROJECTIVE_KERNEL_INL_H
#undef SELVAGE_VECTOR_PROJECTIVE_KERNEL_INL_H
#else
#define SELVAGE_VECTOR_PROJECTIVE_KERNEL_INL_H
#endif

#include "mapper/vector_kernel-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

using DD = hn::CappedTag<double, kMostLanes / 2>;
using VD = hn::Vec<DD>;
using DHalf = hn::Rebind<int32_t, DD>;
inline constexpr int32_t kDoubles = static_cast<int32_t>(hn::MaxLanes(DD()));

// kDoubles pixels of a span: between low and low + 1 are u and v, times the scale.
struct LowTexels {
  hn::Vec<DHalf> s, t;
};

inline constexpr double kUnit_texel = 1.0 / (int64_t{1} << kLaneFraction);

// What u and v are quotients of.
struct ProjectiveParts {
  VD u, v, denominator;
};

// The floors of the two ends of where a value may be. Bits are set where they differ.
[[nodiscard]] HWY_INLINE hn::Vec<DHalf> low_texel(VD estimate, double error, uint32_t* near) {
  const DD d;
  const VD floor = hn::Floor(hn::Sub(estimate, hn::Set(d, error)));
  const auto differs = hn::Ne(floor, hn::Floor(hn::Add(estimate, hn::Set(d, error))));
  *near = HWY_LIKELY(hn::AllFalse(d, differs)) ? 0 : lane_bits(d, differs);
  return hn::DemoteTo(DHalf(), floor);
}

// Bits are set in *near_u and *near_v where the next whole number may have been reached.
[[nodiscard]] HWY_INLINE LowTexels low_texels(const ProjectiveParts& parts, double error,
                                              uint32_t* near_u, uint32_t* near_v) {
  const VD w = hn::Div(hn::Set(DD(), 1.0), parts.denominator);
  return {low_texel(hn::Mul(parts.u, w), error, near_u),
          low_texel(hn::Mul(parts.v, w), error, near_v)};
}

// Numbers are in texels times `scale`, a power of two.
class ProjectiveRow {
 public:
  HWY_INLINE ProjectiveRow(const DividedLanes& lanes, double scale)
      : u_(scaled(lanes.u_numerator_fx32(), scale * kUnit_texel)),
        v_(scaled(lanes.v_numerator_fx32(), scale * kUnit_texel)),
        denominator_(lanes.denominator()),
        error_(static_cast<double>(lanes.error_fx32()) * (scale * kUnit_texel)) {}

  // Of kDoubles pixels from an offset in the span on.
  HWY_INLINE ProjectiveParts parts(int32_t offset_px) const {
    const DD d;
    const VD i = hn::Add(hn::Iota(d, 0.0), hn::Set(d, static_cast<double>(offset_px)));
    return {at(u_, i), at(v_, i), at(denominator_, i)};
  }
  HWY_INLINE LowTexels low(int32_t offset_px, uint32_t* near_u, uint32_t* near_v) const {
    return low_texels(parts(offset_px), error_, near_u, near_v);
  }

 private:
  using Linear = DividedLanes::Linear;
  static Linear scaled(const Linear& fx32, double factor) {
    return {fx32.start * factor, fx32.step * factor};
  }
  static HWY_INLINE VD at(const Linear& line, VD i) {
    const DD d;
    return hn::MulAdd(i, hn::Set(d, line.step), hn::Set(d, line.start));
  }

  Linear u_, v_, denominator_;
  double error_;
};

// Where both ends have one floor, that is the texel; the exact map decides between two.
template <class Address>
HWY_INLINE void find_places(const ProjectiveRow& row, const ExactMap& map, const Span& span,
                            int32_t offset_px, const Extent& extent, int32_t* HWY_RESTRICT place) {
  const DHalf d;
  uint32_t near_u, near_v;
  LowTexels texel = row.low(offset_px, &near_u, &near_v);
  const uint32_t asked = first_bits(HWY_MIN(HWY_MAX(span.width_px() - offset_px, 0), kDoubles));
  near_u &= asked;
  near_v &= asked;
  if (HWY_UNLIKELY((near_u | near_v) != 0)) {
    const ExactRow exact = map.row_from(span.left_px + offset_px, span.row);
    texel.s = decide(d, texel.s, near_u, exact, exact.u);
    texel.t = decide(d, texel.t, near_v, exact, exact.v);
  }
  hn::StoreU(Address::place(texel.s, texel.t, extent), d, place);
}

template <class Address>
void draw_projective_row(const DividedLanes& lanes, const ExactMap& map, const Span& span,
                         const Surface& surface) {
  const ProjectiveRow row(lanes, 1);
  const Extent extent = extent_of(surface.texture);
  char* pixel = first_pixel(surface, span);
  HWY_ALIGN int32_t place[kLanes];
  for (int32_t offset_px = 0; offset_px < span.width_px(); offset_px += kLanes) {
    const int32_t count = HWY_MIN(span.width_px() - offset_px, kLanes);
    for (int32_t done = 0; done < count; done += kDoubles) {
      find_places<Address>(row, map, span, offset_px + done, extent, place + done);
    }
    fetch(surface.texture, place, count, pixel);
    pixel += count * bytes_per_pixel(surface.target.format);
  }
}

template <class Address>
void draw_wide_projective(const ProjectiveSpans& spans, const Surface& surface) {
  for (int32_t i = 0; i < spans.batch.rows; ++i) {
    const Span span = spans.batch.span(i);
    draw_projective_row<Address>(spans.field.of(span), spans.exact, span, surface);
  }
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
