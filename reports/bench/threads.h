// What more threads are worth: many polygons in one call, by 1, 2, 4 .. threads.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <vector>

#include "reports/bench/timing.h"
#include "reports/bench/workloads.h"

namespace selvage::reports {

// For each workload, selvage_draw once a polygon and selvage_draw_many by each number of threads,
// timed interleaved; the pictures are compared first, and any that differs is a WrongAnswer.
// Format: [{ workload, loop_ns, threads: [{ threads, median_ns, lower_quartile_ns,
// upper_quartile_ns, speed_up }] }], speed_up being over the first of the numbers.
[[nodiscard]] nlohmann::ordered_json measure_threads(const std::vector<Workload>& loads,
                                                     const std::vector<int32_t>& threads,
                                                     const TimingOptions& options);

}  // namespace selvage::reports
