// The whole measurement: answers checked first, then times, as one JSON document.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "cli/console.h"
#include "reports/bench/subject.h"
#include "reports/bench/timing.h"

namespace selvage::reports {

struct BenchOptions {
  uint64_t seed = 1;
  int32_t rows = 64;  // sampled of each workload's 1024
  TimingOptions timing;
};

// What stopped the measurement: a subject that must be right was not.
class WrongAnswer : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Format: { machine, seed, rows, repetitions, min_time_s, subjects: [...], workloads: [...] };
// reports/page reads it.
[[nodiscard]] nlohmann::ordered_json run_benchmark(const BenchOptions& options,
                                                   const std::vector<Subject>& subjects,
                                                   const cli::Console& console);

}  // namespace selvage::reports
