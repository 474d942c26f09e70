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
  HWY_INLINE ProjectiveRow(const ProjectiveSpan& each, const ExactMap& exact,
                           const Surface& surface)
      : span_(each.span),
        exact_(exact),
        width_texel_(surface.texture.width),
        height_texel_(surface.texture.height),
        pitch_texel_(pitch_texel(surface.texture)),
        u_(numerator(each.lanes.u_numerator_fx32())),
        v_(numerator(each.lanes.v_numerator_fx32())),
        denominator_(each.lanes.denominator()),
        error_texel_(static_cast<double>(each.lanes.error_fx32()) * kUnit) {}

  // As AffineBatch::find_places, for kDoubles pixels.
  HWY_INLINE int32_t find_places(int32_t offset_px, int32_t count,
                                 int32_t* HWY_RESTRICT place) const {
    const DD d;
    const DHalf d32;
    const VD i = hn::Add(hn::Iota(d, 0.0), hn::Set(d, static_cast<double>(offset_px)));
    const VD w = hn::Div(hn::Set(d, 1.0), at(denominator_, i));
    const VD u = hn::Mul(at(u_, i), w), v = hn::Mul(at(v_, i), w);
    const VD error = hn::Set(d, error_texel_);
    const VD low_u = hn::Floor(hn::Sub(u, error)), low_v = hn::Floor(hn::Sub(v, error));
    const auto same_u = hn::Eq(low_u, hn::Floor(hn::Add(u, error)));
    const auto same_v = hn::Eq(low_v, hn::Floor(hn::Add(v, error)));
    const auto s = hn::DemoteTo(d32, low_u), t = hn::DemoteTo(d32, low_v);
    hn::StoreU(hn::Add(hn::Mul(Address::index(t, height_texel_), hn::Set(d32, pitch_texel_)),
                       Address::index(s, width_texel_)),
               d32, place);
    const auto near =
        hn::AndNot(hn::And(same_u, same_v), hn::FirstN(d, static_cast<size_t>(count)));
    if (HWY_LIKELY(hn::AllFalse(d, near))) return 0;
    HWY_ALIGN int32_t low_s[kDoubles], low_t[kDoubles];
    hn::Store(s, d32, low_s);
    hn::Store(t, d32, low_t);
    return decide_places(offset_px, lane_bits(d, near), low_s, low_t, place);
  }

 private:
  static constexpr double kUnit = 1.0 / (int64_t{1} << kLaneFraction);

  using Linear = ProjectiveLanes::Linear;
  // In texels: a power of two less, exactly.
  static Linear numerator(const Linear& fx32) { return {fx32.start * kUnit, fx32.step * kUnit}; }
  static HWY_INLINE VD at(const Linear& line, VD i) {
    const DD d;
    return hn::MulAdd(i, hn::Set(d, line.step), hn::Set(d, line.start));
  }

  // Each coordinate is its low texel or the next.
  HWY_NOINLINE int32_t decide_places(int32_t offset_px, uint32_t near, const int32_t* low_s,
                                     const int32_t* low_t, int32_t* place) const {
    const ExactRow exact = exact_.row_from(span_.left_px + offset_px, span_.row);
    int32_t decided = 0;
    for (int32_t i = 0; near >> i != 0; ++i) {
      if ((near >> i & 1U) == 0) continue;
      const int32_t s = exact.u_texel(i, low_s[i]);
      const int32_t t = exact.v_texel(i, low_t[i]);
      place[i] = Address::Scalar::index(t, height_texel_) * pitch_texel_ +
                 Address::Scalar::index(s, width_texel_);
      ++decided;
    }
    return decided;
  }

  const Span& span_;
  const ExactMap& exact_;
  int32_t width_texel_, height_texel_, pitch_texel_;
  Linear u_, v_, denominator_;
  double error_texel_;
};

template <class Pixel, class Address>
int32_t draw_projective_row(const ProjectiveSpan& each, const ExactMap& exact,
                            const Surface& surface) {
  const ProjectiveRow<Address> row(each, exact, surface);
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
