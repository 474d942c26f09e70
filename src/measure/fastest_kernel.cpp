// The C interface to measuring, and the only file of the library that looks at a clock.
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>

#include "mapper/kernel.h"
#include "mapper/kernel_choice.h"
#include "mapper/kernel_preference.h"
#include "measure/kernel_race.h"
#include "measure/work_picture.h"
#include "selvage.h"

namespace selvage::measure {
namespace {

inline constexpr size_t kRounds = 16;

[[nodiscard]] selvage_status check_what(selvage_filter filter, selvage_format format,
                                        selvage_work work) {
  if (filter < SELVAGE_FILTER_NEAREST || filter > SELVAGE_FILTER_AREA) return SELVAGE_ERROR_FILTER;
  if (format < SELVAGE_INDEX8 || format > SELVAGE_RGBA8888) return SELVAGE_ERROR_TARGET_FORMAT;
  if (filter != SELVAGE_FILTER_NEAREST && format != SELVAGE_RGBA8888) {
    return SELVAGE_ERROR_FILTER_FORMAT;
  }
  const bool known = work >= SELVAGE_WORK_LARGE && work <= SELVAGE_WORK_PERSPECTIVE;
  return known ? SELVAGE_OK : SELVAGE_ERROR_MEASURE_WORK;
}

[[nodiscard]] selvage_status check_memory(const void* scratch, size_t scratch_bytes,
                                          const selvage_kernel* fastest) {
  if (scratch == nullptr) return SELVAGE_ERROR_MEASURE_NULL;
  const auto first = reinterpret_cast<uintptr_t>(scratch);
  if (first % alignof(std::max_align_t) != 0) return SELVAGE_ERROR_MEASURE_ALIGNMENT;
  if (scratch_bytes < SELVAGE_FASTEST_KERNEL_BYTES) return SELVAGE_ERROR_MEASURE_SIZE;
  if (fastest == nullptr) return SELVAGE_ERROR_MEASURE_NULL;
  // Of addresses only differences count: a sum might pass the end of memory.
  const auto at = reinterpret_cast<uintptr_t>(fastest);
  const bool apart = at < first ? first - at >= sizeof *fastest
                                : at - first >= size_t{SELVAGE_FASTEST_KERNEL_BYTES};
  return apart ? SELVAGE_OK : SELVAGE_ERROR_MEASURE_OVERLAP;
}

[[nodiscard]] selvage_kernel race(const WorkPicture& picture, selvage_filter filter,
                                  selvage_work work) {
  using Clock = std::chrono::steady_clock;
  const mapper::KernelOrder& order = mapper::kernel_order(filter, work);
  KernelRace times;
  for (size_t round = 0; round < kRounds; ++round) {
    // Each round starts with another one: what a kernel leaves to the next disturbs all in turn.
    for (size_t i = 0; i < order.size(); ++i) {
      const selvage_kernel kernel = order[(round + i) % order.size()];
      if (!mapper::is_usable(kernel)) continue;
      const Clock::time_point start = Clock::now();
      picture.draw(work, kernel);
      const auto passed = std::chrono::nanoseconds(Clock::now() - start);
      times.record(kernel, passed.count());
    }
  }
  return times.winner(order);
}

}  // namespace
}  // namespace selvage::measure

selvage_status selvage_fastest_kernel(selvage_filter filter, selvage_format format,
                                      selvage_work work, void* scratch, size_t scratch_bytes,
                                      selvage_kernel* fastest) {
  using namespace selvage::measure;
  selvage_status status = check_what(filter, format, work);
  if (status == SELVAGE_OK) status = check_memory(scratch, scratch_bytes, fastest);
  if (status != SELVAGE_OK) return status;
  *fastest = race(WorkPicture(filter, format, scratch), filter, work);
  return SELVAGE_OK;
}
