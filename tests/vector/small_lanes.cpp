// Highway includes this file again for each SIMD target.
#include "tests/vector/small_lanes.h"

#include "mapper/vector/targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/vector/small_lanes.cpp"
#include <hwy/foreach_target.h>
// after foreach_target.h, which chooses the target
#include <hwy/highway.h>

#if HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128
#include "mapper/vector/small_set_up-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
#if SELVAGE_DRAWS_SMALL
namespace {

// As the target draws them: by AVX-512 from each row's first pixel on, else from the part's.
template <class Kind>
void find_lanes_of(const SmallSetUp<Kind>& set_up, size_t i, const SmallBegins& begins,
                   SmallLanes* to) {
  const D32 d;
#if HWY_TARGET == HWY_AVX3
  const V32 begin_px = hn::LoadU(d, begins.data());
  const typename Kind::Rows rows(set_up.maps, i, {begin_px, hn::Iota(d, 0)});
  const typename Kind::Rows::Walk walk(set_up.maps, i);
#else
  const typename Kind::Lanes lanes(set_up.maps, i);
#endif
  for (size_t row = 0; row < kMostSmall_px; ++row) {
    const auto k = static_cast<int32_t>(row);
    for (size_t px = 0; px < kMostSmall_px; px += size_t{kLanes}) {
#if HWY_TARGET == HWY_AVX3
      const LaneVectors found = walk.along(rows, k);
#else
      const PixelSteps steps{hn::Iota(d, begins[row] + static_cast<int32_t>(px)), hn::Set(d, k)};
      const LaneVectors found = lanes.at(steps);
#endif
      hn::StoreU(found.u, d, to->u_fx24[row].data() + px);
      hn::StoreU(found.v, d, to->v_fx24[row].data() + px);
    }
  }
}

template <class Kind>
void find_all(const SmallPolygons& polygons, const selvage_texture& texture,
              std::span<const SmallBegins> begins, std::span<SmallLanes> lanes) {
  for (size_t first = 0; first < polygons.count(); first += size_t{kRows}) {
    const SmallSetUp<Kind> set_up(polygons, first, texture);
    for (size_t i = 0; i < size_t{kRows} && first + i < polygons.count(); ++i) {
      SmallLanes* const to = &lanes[first + i];
      to->has_lanes = set_up.maps.has_lanes(i);
      to->lack_fx24 = set_up.maps.lack_fx24(i);
      to->s_texel = set_up.s_texel[i];
      to->t_texel = set_up.t_texel[i];
      find_lanes_of(set_up, i, begins[first + i], to);
    }
  }
}

}  // namespace

void find_small_lanes(const SmallPolygons& polygons, const selvage_texture& texture,
                      std::span<const SmallBegins> begins, std::span<SmallLanes> lanes) {
  if (!polygons.affine()) return find_all<ProjectiveKind>(polygons, texture, begins, lanes);
  if (!polygons.have_four()) return find_all<AffineKind>(polygons, texture, begins, lanes);
  find_all<AffineParallelogramKind>(polygons, texture, begins, lanes);
}

#endif
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#if HWY_ONCE
namespace selvage::mapper {

std::vector<SmallLanesOf> all_small_lanes() {
  std::vector<SmallLanesOf> all;
  [[maybe_unused]] const auto add = [&](selvage_kernel kernel, FindSmallLanes find) {
    if (vector_kernels(kernel, SELVAGE_FILTER_NEAREST) != nullptr) all.push_back({kernel, find});
  };
#if HWY_TARGETS & HWY_AVX2
  add(SELVAGE_KERNEL_AVX2, N_AVX2::find_small_lanes);
#endif
#if HWY_TARGETS & HWY_AVX3
  add(SELVAGE_KERNEL_AVX512, N_AVX3::find_small_lanes);
#endif
  return all;
}

}  // namespace selvage::mapper
#endif
