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

template <class Address>
class ProjectiveRow {
 public:
  HWY_INLINE ProjectiveRow(const ProjectiveSpan& each, const ExactMap& map, const Surface& surface)
      : exact_(map),
        span_(each.span),
        extent_(extent_of(surface.texture)),
        u_(in_texels(each.lanes.u_numerator_fx32())),
        v_(in_texels(each.lanes.v_numerator_fx32())),
        denominator_(each.lanes.denominator()),
        error_texel_(static_cast<double>(each.lanes.error_fx32()) * kUnit_texel) {}

  // As AffineBatch::find_places, for kDoubles pixels.
  HWY_INLINE int32_t find_places(int32_t offset_px, int32_t count, int32_t* HWY_RESTRICT place) {
    const DD d;
    const VD i = hn::Add(hn::Iota(d, 0.0), hn::Set(d, static_cast<double>(offset_px)));
    const VD w = hn::Div(hn::Set(d, 1.0), at(denominator_, i));
    const VD u = hn::Mul(at(u_, i), w), v = hn::Mul(at(v_, i), w);
    const VD low_u = low(u), low_v = low(v);
    store_places(hn::DemoteTo(DHalf(), low_u), hn::DemoteTo(DHalf(), low_v), place);
    const auto decided = hn::And(is_decided(low_u, u), is_decided(low_v, v));
    const auto near = hn::AndNot(decided, hn::FirstN(d, static_cast<size_t>(count)));
    if (HWY_LIKELY(hn::AllFalse(d, near))) return 0;
    decide_places(offset_px, u, v, lane_bits(d, near), place);
    return static_cast<int32_t>(hn::CountTrue(d, near));
  }

 private:
  static constexpr double kUnit_texel = 1.0 / (int64_t{1} << kLaneFraction);

  using Linear = ProjectiveLanes::Linear;
  // A power of two less, exactly.
  static Linear in_texels(const Linear& fx32) {
    return {fx32.start * kUnit_texel, fx32.step * kUnit_texel};
  }
  static HWY_INLINE VD at(const Linear& line, VD i) {
    const DD d;
    return hn::MulAdd(i, hn::Set(d, line.step), hn::Set(d, line.start));
  }
  // The texels of the two ends of where the value may be.
  HWY_INLINE VD low(VD estimate) const {
    return hn::Floor(hn::Sub(estimate, hn::Set(DD(), error_texel_)));
  }
  HWY_INLINE hn::Mask<DD> is_decided(VD low, VD estimate) const {
    return hn::Eq(low, hn::Floor(hn::Add(estimate, hn::Set(DD(), error_texel_))));
  }

  HWY_NOINLINE void decide_places(int32_t offset_px, VD u, VD v, uint32_t asked, int32_t* place) {
    const DD d;
    const DHalf d32;
    const ExactRow row = exact_.row_from(span_.left_px + offset_px, span_.row);
    const VD low_u = low(u), low_v = low(v);
    const uint32_t near_u = ~lane_bits(d, is_decided(low_u, u)) & asked;
    const uint32_t near_v = ~lane_bits(d, is_decided(low_v, v)) & asked;
    store_places(decide(d32, hn::DemoteTo(d32, low_u), near_u, row, row.u),
                 decide(d32, hn::DemoteTo(d32, low_v), near_v, row, row.v), place);
  }

  HWY_INLINE void store_places(hn::Vec<DHalf> s, hn::Vec<DHalf> t,
                               int32_t* HWY_RESTRICT place) const {
    hn::StoreU(Address::place(s, t, extent_), DHalf(), place);
  }

  const ExactMap& exact_;
  const Span& span_;
  Extent extent_;
  Linear u_, v_, denominator_;
  double error_texel_;
};

template <class Pixel, class Address>
int32_t draw_projective_row(const ProjectiveSpan& each, const ExactMap& map,
                            const Surface& surface) {
  ProjectiveRow<Address> row(each, map, surface);
  char* pixel = first_pixel<Pixel>(surface, each.span);
  HWY_ALIGN int32_t place[kLanes];
  int32_t decided = 0;
  for (int32_t offset_px = 0; offset_px < each.span.width_px(); offset_px += kLanes) {
    const int32_t count = HWY_MIN(each.span.width_px() - offset_px, kLanes);
    for (int32_t done = 0; done < kLanes; done += kDoubles) {
      decided += row.find_places(offset_px + done, HWY_MAX(count - done, 0), place + done);
    }
    fetch<Pixel>(surface.texture.texels, place, count, pixel);
    pixel += count * ptrdiff_t{sizeof(Pixel)};
  }
  return decided;
}

int32_t draw_projective(const ProjectiveSpans& spans, const Surface& surface) {
  int32_t decided = 0;
  for (const ProjectiveSpan& each : spans.spans) {
    decided += with_pixel(surface.target.format, [&](auto pixel) {
      return with_address(surface, [&](auto address) {
        return draw_projective_row<decltype(pixel), decltype(address)>(each, spans.exact, surface);
      });
    });
  }
  return decided;
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
