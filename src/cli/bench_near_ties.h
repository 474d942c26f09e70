// `selvage bench --near-ties`.
#pragma once

#include <span>
#include <string>

#include "cli/bench_command.h"
#include "reports/bench/machine.h"
#include "reports/bench/near_tie_search.h"

namespace selvage::cli {

// Prints what was found. Returns kExitFine, or kExitLawFailed where a drawing is wrong; never for
// slowness.
int run_near_ties(const BenchOptions& options, const reports::MapSeeds& seeds,
                  const reports::Machine& machine, const Console& console);

// At most 100 columns, for each search: the median of all maps, then the worst.
[[nodiscard]] std::string near_ties_table(std::span<const reports::NearTieSearch> searches);

// { machine, seed, maps, most_times_ordinary, searches: [{ kernel, above, median, worst: [{ seed,
// map, hard_ns, ordinary_ns, ratio }] }] }; at least one search.
[[nodiscard]] std::string near_ties_json(std::span<const reports::NearTieSearch> searches,
                                         const reports::Machine& machine);

}  // namespace selvage::cli
