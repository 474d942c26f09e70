// Projective spans by vectors of doubles. Included once for each SIMD target.
//
// The same numerators, denominators and bound as ProjectiveLanes: u lies in (estimate - error,
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

// kLanes pixels of a span: between low and low + 1 are u and v, times the scale.
struct LowTexels {
  V32 s, t;
};
static_assert(kLanes == 2 * kDoubles);

// Numbers are in texels times `scale`, a power of two.
class ProjectiveRow {
 public:
  HWY_INLINE ProjectiveRow(const ProjectiveLanes& lanes, double scale)
      : u_(scaled(lanes.u_numerator_fx32(), scale * kUnit_texel)),
        v_(scaled(lanes.v_numerator_fx32(), scale * kUnit_texel)),
        denominator_(lanes.denominator()),
        error_(static_cast<double>(lanes.error_fx32()) * (scale * kUnit_texel)) {}

  // Of the pixels from an offset in the span on. *near_u and *near_v: some of them may have reached
  // the next whole number.
  HWY_INLINE LowTexels low(int32_t offset_px, bool* near_u, bool* near_v) const {
    const Half first = half(offset_px), second = half(offset_px + kDoubles);
    *near_u = first.near_u || second.near_u;
    *near_v = first.near_v || second.near_v;
    const D32 d;
    return {hn::Combine(d, second.s, first.s), hn::Combine(d, second.t, first.t)};
  }

 private:
  // kDoubles of them.
  struct Half {
    hn::Vec<DHalf> s, t;
    bool near_u, near_v;
  };
  HWY_INLINE Half half(int32_t offset_px) const {
    const DD d;
    const VD i = hn::Add(hn::Iota(d, 0.0), hn::Set(d, static_cast<double>(offset_px)));
    const VD w = hn::Div(hn::Set(d, 1.0), at(denominator_, i));
    Half half;
    half.s = low(hn::Mul(at(u_, i), w), &half.near_u);
    half.t = low(hn::Mul(at(v_, i), w), &half.near_v);
    return half;
  }

  static constexpr double kUnit_texel = 1.0 / (int64_t{1} << kLaneFraction);

  using Linear = ProjectiveLanes::Linear;
  static Linear scaled(const Linear& fx32, double factor) {
    return {fx32.start * factor, fx32.step * factor};
  }
  static HWY_INLINE VD at(const Linear& line, VD i) {
    const DD d;
    return hn::MulAdd(i, hn::Set(d, line.step), hn::Set(d, line.start));
  }
  // Floors of the two ends of where the value may be.
  HWY_INLINE hn::Vec<DHalf> low(VD estimate, bool* near) const {
    const DD d;
    const VD error = hn::Set(d, error_);
    const VD floor = hn::Floor(hn::Sub(estimate, error));
    *near = !hn::AllFalse(d, hn::Ne(floor, hn::Floor(hn::Add(estimate, error))));
    return hn::DemoteTo(DHalf(), floor);
  }

  Linear u_, v_, denominator_;
  double error_;
};

// Where both ends have one floor, that is the texel; the exact map decides between two.
template <class Address>
HWY_INLINE V32 find_places(const ProjectiveRow& row, RowOfTies& ties, int32_t offset_px,
                           const Extent& extent) {
  bool near_u, near_v;
  LowTexels texel = row.low(offset_px, &near_u, &near_v);
  if (HWY_UNLIKELY(near_u || near_v)) {
    ties.decide(D32(), offset_px, near_u, near_v, &texel.s, &texel.t);
  }
  return Address::place(texel.s, texel.t, extent);
}

template <class Address>
void draw_projective_row(const ProjectiveSpan& each, const ExactMap& map, const Surface& surface) {
  const ProjectiveRow row(each.lanes, 1);
  const Extent extent = extent_of(surface.texture);
  char* pixel = first_pixel(surface, each.span);
  RowOfTies ties(map, each.span, 0);
  HWY_ALIGN int32_t place[kLanes];
  for (int32_t offset_px = 0; offset_px < each.span.width_px(); offset_px += kLanes) {
    hn::Store(find_places<Address>(row, ties, offset_px, extent), D32(), place);
    const int32_t count = HWY_MIN(each.span.width_px() - offset_px, kLanes);
    fetch(surface.texture, place, count, pixel);
    pixel += count * bytes_per_pixel(surface.target.format);
  }
}

void draw_projective(const ProjectiveSpans& spans, const Surface& surface) {
  with_address(surface, [&](auto address) {
    for (const ProjectiveSpan& each : spans.spans) {
      draw_projective_row<decltype(address)>(each, spans.exact, surface);
    }
  });
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
