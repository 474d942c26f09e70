// Who is the fastest, from times that other work on the machine has made longer.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "mapper/kernel_preference.h"
#include "selvage.h"

namespace selvage::measure {

// A disturbance makes a time longer, never shorter: of each kernel the shortest counts.
class KernelRace {
 public:
  void record(selvage_kernel kernel, int64_t time_ns);

  // Of those within 1/16 of the shortest time the first in the order. At least one of these was
  // recorded.
  [[nodiscard]] selvage_kernel winner(const mapper::KernelOrder& order) const;

 private:
  std::array<int64_t, std::tuple_size_v<mapper::KernelOrder> + 1> least_ns_{};  // 0: none recorded
};

}  // namespace selvage::measure
