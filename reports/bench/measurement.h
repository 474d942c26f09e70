// Carrying out a plan: every answer is checked first, then everything is timed.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "reports/bench/error_count.h"
#include "reports/bench/plan.h"
#include "reports/bench/statistics.h"
#include "reports/bench/timing.h"

namespace selvage::reports {

struct BenchSettings {
  uint64_t seed = 1;
  int32_t rows = 64;                 // sampled of each target
  int32_t padding_px = kPadding_px;  // of each row of the targets
  TimingOptions timing;
};

// One subject on one item.
struct Cell {
  const Subject* subject = nullptr;
  std::string refusal;               // why it was not measured; empty where it was
  std::optional<ErrorCount> errors;  // nothing where the subject draws no picture
  Spread ns_per_px;                  // of the covered pixels
};

struct ItemResult {
  const Workload* load = nullptr;
  uint64_t covered_px = 0;
  std::vector<Cell> cells;

  [[nodiscard]] const Cell* measured(std::string_view subject_id) const;
};

// What stopped the measurement: a subject that must be right was not.
class WrongAnswer : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// done of total; totals of times are estimates.
using Progress = std::function<void(std::string_view what, uint64_t done, uint64_t total)>;

// A result for each item of the plan, which must outlive them.
[[nodiscard]] std::vector<ItemResult> measure(const Plan& plan, const BenchSettings& settings,
                                              const Progress& progress);

// The medians of an item's two subjects, a / b; nothing where either was not measured.
[[nodiscard]] std::optional<double> ratio(const Cell* a, const Cell* b);

}  // namespace selvage::reports
