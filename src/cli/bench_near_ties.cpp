#include "cli/bench_near_ties.h"

#include <cstdio>
#include <nlohmann/json.hpp>
#include <vector>

#include "cli/file.h"
#include "cli/json_text.h"
#include "cli/status_line.h"
#include "reports/bench/kernels.h"
#include "reports/bench/measurement.h"
#include "reports/bench/statistics.h"

namespace selvage::cli {
namespace {

using nlohmann::ordered_json;
using reports::kMostTimesOrdinary;
using reports::NearTieSearch;
using reports::TimedMap;

[[nodiscard]] std::string table_of(const NearTieSearch& search) {
  char summary[240];
  std::snprintf(summary, sizeof summary,
                "%zu maps from seed %llu on, kernel %s: near-ties take %.2f times as long as the\n"
                "same map without, the median; %zu of them more than %.0f times. The worst:\n\n",
                search.ratios.size(), static_cast<unsigned long long>(search.first_seed),
                reports::kernel_name(search.kernel).c_str(),
                reports::spread_of(search.ratios).median, search.above(kMostTimesOrdinary),
                kMostTimesOrdinary);
  std::string table = summary;
  table += " times         ns   without  seed: map\n";
  for (const TimedMap& map : search.worst) {
    char times[64];
    std::snprintf(times, sizeof times, "%6.2f %10.0f %9.0f", map.ratio(), map.hard_ns,
                  map.ordinary_ns);
    table += std::string(times) + "  " + std::to_string(map.seed) + ": " + map.description + '\n';
  }
  return table + '\n';
}

[[nodiscard]] ordered_json json_of(const NearTieSearch& search) {
  ordered_json worst = ordered_json::array();
  for (const TimedMap& map : search.worst) {
    worst.push_back({{"seed", map.seed},
                     {"map", map.description},
                     {"hard_ns", map.hard_ns},
                     {"ordinary_ns", map.ordinary_ns},
                     {"ratio", map.ratio()}});
  }
  return {{"kernel", reports::kernel_name(search.kernel)},
          {"above", search.above(kMostTimesOrdinary)},
          {"median", reports::spread_of(search.ratios).median},
          {"worst", worst}};
}

}  // namespace

std::string near_ties_table(std::span<const NearTieSearch> searches) {
  std::string table;
  for (const NearTieSearch& search : searches) table += table_of(search);
  return table + "One again: selvage bench --near-ties 1 --seed SEED\n";
}

std::string near_ties_json(std::span<const NearTieSearch> searches,
                           const reports::Machine& machine) {
  ordered_json about;
  for (const auto& [key, value] : machine) about[key] = value;
  ordered_json found = ordered_json::array();
  for (const NearTieSearch& search : searches) found.push_back(json_of(search));
  return json_text({{"machine", about},
                    {"seed", searches.front().first_seed},
                    {"maps", searches.front().ratios.size()},
                    {"most_times_ordinary", kMostTimesOrdinary},
                    {"searches", found}},
                   1);
}

int run_near_ties(const BenchOptions& options, const reports::MapSeeds& seeds,
                  const reports::Machine& machine, const Console& console) {
  if (!options.output.empty()) check_output(options.output);
  std::vector<selvage_kernel> kernels{SELVAGE_KERNEL_FASTEST};
  if (options.kernels) kernels = reports::kernels_here();
  std::vector<NearTieSearch> searches;
  try {
    StatusLine status(console);
    const uint64_t all = kernels.size() * static_cast<uint64_t>(seeds.count);
    uint64_t done = 0;
    for (const selvage_kernel kernel : kernels) {
      searches.push_back(
          reports::search_near_ties(seeds, kernel, [&] { status.count("maps", done++, all); }));
    }
  } catch (const reports::WrongAnswer& error) {
    console.err << "selvage: " << error.what() << '\n';
    return kExitLawFailed;
  }
  const std::string text = near_ties_json(searches, machine);
  if (!options.output.empty())
    write_file(options.output, {reinterpret_cast<const uint8_t*>(text.data()), text.size()});
  console.out << (options.json ? text : near_ties_table(searches));
  return kExitFine;
}

}  // namespace selvage::cli
