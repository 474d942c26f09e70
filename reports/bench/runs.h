// Runs of pixels, filled: what writing them costs at least.
#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "reports/bench/image.h"
#include "reports/bench/workloads.h"

namespace selvage::reports {

struct PixelRun {
  uint32_t* first;
  int32_t count_px;  // at least 1
};

// Of the workload's polygons, in their order, row by row.
[[nodiscard]] std::vector<PixelRun> runs_of(const Workload& load, Target& target);

// Overlapping stores of four pixels, or three of one: no run is so short that it wants a loop.
inline void fill_run(const PixelRun& run, uint32_t colour) {
  constexpr int32_t kStore_px = 4;
  uint32_t* to = run.first;
  if (run.count_px < kStore_px) {
    to[0] = to[run.count_px / 2] = to[run.count_px - 1] = colour;
    return;
  }
  using Four [[gnu::vector_size(kStore_px * sizeof(uint32_t))]] = uint32_t;
  const Four four = {colour, colour, colour, colour};
  uint32_t* const last = to + run.count_px - kStore_px;
  for (; to < last; to += kStore_px) std::memcpy(to, &four, sizeof four);
  std::memcpy(last, &four, sizeof four);
}

// A way to fill, by a name for people.
struct Fill {
  const char* name;
  void (*fill)(std::span<const PixelRun> runs, uint32_t colour);
};

// Those that this machine can run.
[[nodiscard]] std::vector<Fill> fills_here();

// The fastest for these runs: each of them fills some times, by turns, and the least time counts.
[[nodiscard]] Fill fastest_fill(std::span<const PixelRun> runs);

}  // namespace selvage::reports
