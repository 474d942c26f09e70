// `selvage bench --near-ties`.
#pragma once

#include <string>

#include "cli/bench_command.h"
#include "reports/bench/machine.h"
#include "reports/bench/near_tie_search.h"

namespace selvage::cli {

struct MapSeeds {
  uint64_t first;
  int32_t count;
};

// Prints what was found. Returns kExitFine, or kExitLawFailed where a drawing is wrong; never for
// slowness.
int run_near_ties(const BenchOptions& options, const MapSeeds& seeds,
                  const reports::Machine& machine, const Console& console);

// At most 100 columns: the quantiles of all maps, then the worst.
[[nodiscard]] std::string near_ties_table(const reports::NearTieSearch& search);

// { machine, seed, maps, most_times_ordinary, above, median, worst: [{ seed, map, hard_ns,
// ordinary_ns, ratio }] }
[[nodiscard]] std::string near_ties_json(const reports::NearTieSearch& search,
                                         const reports::Machine& machine);

}  // namespace selvage::cli
