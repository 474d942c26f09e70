// Which cache lines of a texture a picture needs, in the order in which drawing first needs them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "reports/bench/image.h"
#include "reports/bench/workloads.h"

namespace selvage::reports {

inline constexpr size_t kLineBytes = 64;

struct NeededLines {
  std::vector<uint32_t> texels;  // the first one needed of each line, counted in texture.texels
  std::vector<size_t> end;       // for each of the workload's runs, behind those that are new to it
};

// Of the exact picture, nearest, from a texture of places.
[[nodiscard]] NeededLines needed_lines(const Workload& load, const Texture& texture);

}  // namespace selvage::reports
