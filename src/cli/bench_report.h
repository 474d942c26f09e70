// What a run of `selvage bench` measured, for people and for programs.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/bench_command.h"
#include "cli/bench_comparison.h"
#include "reports/bench/kernels.h"
#include "reports/bench/machine.h"
#include "reports/bench/measurement.h"
#include "reports/bench/plan.h"

namespace selvage::cli {

struct BenchReport {
  reports::BenchSettings settings;
  std::string filter;
  reports::Machine machine;
  std::vector<reports::FastestKernel> fastest_kernels;
  const reports::Plan* plan = nullptr;
  std::vector<reports::ItemResult> results;  // one for each item of the plan
  std::optional<TimeComparison> comparison;
};

// The command on a plan that was made already.
int run_plan(const reports::Plan& plan, const BenchOptions& options, const Console& console);

// At most 100 columns: a block for each item, the curves, and what there was not.
[[nodiscard]] std::string bench_table(const BenchReport& report);

// The items and the subjects of a plan, with their descriptions.
[[nodiscard]] std::string bench_list(const reports::Plan& plan);

// { machine, seed, rows, repetitions, min_time_s, padding_px, fastest_kernels, filter, subjects,
// workloads, curves, unavailable, build_information, comparison }; what was not measured is null.
[[nodiscard]] std::string bench_json(const BenchReport& report);

// { machine, seed, rows, repetitions, min_time_s, padding_px,
// medians_ns_per_px: { item: { subject: ns } } }, without the curves.
[[nodiscard]] std::string bench_brief_json(const BenchReport& report);

}  // namespace selvage::cli
