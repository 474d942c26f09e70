#include "measure/kernel_race.h"

#include <algorithm>

namespace selvage::measure {
namespace {

// So much shorter must a time be to count as shorter.
inline constexpr int64_t kDistinct = 16;

}  // namespace

void KernelRace::record(selvage_kernel kernel, int64_t time_ns) {
  int64_t& least_ns = least_ns_[static_cast<size_t>(kernel)];
  const int64_t some_ns = std::max<int64_t>(time_ns, 1);  // a clock may tick slowly
  least_ns = least_ns == 0 ? some_ns : std::min(least_ns, some_ns);
}

selvage_kernel KernelRace::winner(const mapper::KernelOrder& order) const {
  int64_t shortest_ns = INT64_MAX;
  for (const int64_t ns : least_ns_) {
    if (ns != 0) shortest_ns = std::min(shortest_ns, ns);
  }
  return *std::ranges::find_if(order, [&](selvage_kernel kernel) {
    const int64_t ns = least_ns_[static_cast<size_t>(kernel)];
    return ns != 0 && ns - shortest_ns <= shortest_ns / kDistinct;
  });
}

}  // namespace selvage::measure
