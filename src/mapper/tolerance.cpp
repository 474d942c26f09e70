#include "mapper/tolerance.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace selvage::mapper {

int32_t choose_segment_px(const RowBend& row, int64_t margin_fx32, int32_t width_px,
                          int32_t tolerance_fx16, const Stepping& stepping) {
  if (width_px < stepping.least_row_px) return 0;
  const Chords chords(row);
  const double room = chords.room_fx16(tolerance_fx16 - roundings_fx16(margin_fx32, width_px));
  if (chords.off_fx16(width_px - 1) <= room) return width_px;
  if (chords.off_fx16(stepping.least_segment_px) > room) return 0;
  // Times a power of two is exact: the root is not below it.
  static_assert(std::has_single_bit(static_cast<uint32_t>(kUsualStepping.least_segment_px)));
  static_assert(std::has_single_bit(static_cast<uint32_t>(kWideStepping.least_segment_px)));
  const auto longest_px = static_cast<int32_t>(std::sqrt(room / chords.one_px_fx16));
  return longest_px - longest_px % kStepGroup_px;
}

RowChoice choose_row(const RowBend& row, int64_t margin_fx32, int32_t width_px,
                     int32_t tolerance_fx16, const Stepping& stepping) {
  const int32_t segment_px =
      choose_segment_px(row, margin_fx32, width_px, tolerance_fx16, stepping);
  if (segment_px == 0) return {SELVAGE_METHOD_EXACT_PERSPECTIVE, 0, 0};
  const Chords chords(row);
  const double off = chords.off_fx16(std::min(segment_px, width_px - 1)) / chords.cube;
  const int32_t bound_fx16 =
      roundings_fx16(margin_fx32, width_px) + static_cast<int32_t>(std::ceil(off));
  if (segment_px == width_px) return {SELVAGE_METHOD_AFFINE_FOR_PERSPECTIVE, 0, bound_fx16};
  return {SELVAGE_METHOD_SUBDIVIDED, segment_px, bound_fx16};
}

}  // namespace selvage::mapper
