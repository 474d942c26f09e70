#include "cli/bench_near_ties.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "cli/file.h"
#include "cli/json_text.h"
#include "cli/status_line.h"
#include "reports/bench/measurement.h"
#include "reports/bench/statistics.h"

namespace selvage::cli {
namespace {

using reports::kMostTimesOrdinary;
using reports::NearTieSearch;
using reports::TimedMap;

[[nodiscard]] std::string line_of(const TimedMap& map) {
  char times[64];
  std::snprintf(times, sizeof times, "%6.2f %10.0f %9.0f", map.ratio(), map.hard_ns,
                map.ordinary_ns);
  return std::string(times) + "  " + std::to_string(map.seed) + ": " + map.description + '\n';
}

}  // namespace

std::string near_ties_table(const NearTieSearch& search) {
  char summary[200];
  std::snprintf(summary, sizeof summary,
                "%zu maps from seed %llu on: near-ties take %.2f times as long as the same map "
                "without,\nthe median; %zu of them more than %.0f times. The worst:\n\n",
                search.ratios.size(), static_cast<unsigned long long>(search.first_seed),
                reports::spread_of(search.ratios).median, search.above(kMostTimesOrdinary),
                kMostTimesOrdinary);
  std::string table = summary;
  table += " times         ns   without  seed: map\n";
  for (const TimedMap& map : search.worst) table += line_of(map);
  return table + "\nOne again: selvage bench --near-ties 1 --seed SEED\n";
}

std::string near_ties_json(const NearTieSearch& search, const reports::Machine& machine) {
  nlohmann::ordered_json about;
  for (const auto& [key, value] : machine) about[key] = value;
  nlohmann::ordered_json worst = nlohmann::ordered_json::array();
  for (const TimedMap& map : search.worst) {
    worst.push_back({{"seed", map.seed},
                     {"map", map.description},
                     {"hard_ns", map.hard_ns},
                     {"ordinary_ns", map.ordinary_ns},
                     {"ratio", map.ratio()}});
  }
  const nlohmann::ordered_json all{{"machine", about},
                                   {"seed", search.first_seed},
                                   {"maps", search.ratios.size()},
                                   {"most_times_ordinary", kMostTimesOrdinary},
                                   {"above", search.above(kMostTimesOrdinary)},
                                   {"median", reports::spread_of(search.ratios).median},
                                   {"worst", worst}};
  return json_text(all, 1);
}

int run_near_ties(const BenchOptions& options, const MapSeeds& seeds,
                  const reports::Machine& machine, const Console& console) {
  if (!options.output.empty()) check_output(options.output);
  NearTieSearch search;
  try {
    StatusLine status(console);
    search = reports::search_near_ties(seeds.first, seeds.count, [&](int32_t done) {
      status.count("maps", static_cast<uint64_t>(done), static_cast<uint64_t>(seeds.count));
    });
  } catch (const reports::WrongAnswer& error) {
    console.err << "selvage: " << error.what() << '\n';
    return kExitLawFailed;
  }
  const std::string text = near_ties_json(search, machine);
  if (!options.output.empty())
    write_file(options.output, {reinterpret_cast<const uint8_t*>(text.data()), text.size()});
  console.out << (options.json ? text : near_ties_table(search));
  return kExitFine;
}

}  // namespace selvage::cli
