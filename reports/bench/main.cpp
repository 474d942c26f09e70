// selvage_bench: speed against error, measured in one run, as JSON.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <iostream>
#include <string>

#include "cli/error.h"
#include "cli/file.h"
#include "reports/bench/report.h"
#include "reports/bench/threads.h"

namespace {

using namespace selvage;
using namespace selvage::reports;

void run(const BenchOptions& options, const std::string& output_path) {
  cli::check_output(output_path);
  Peers found = peers();
  std::vector<Subject> subjects{subject_exact()};
  for (Subject& usual : subjects_arithmetic()) subjects.push_back(std::move(usual));
  subjects.push_back(subject_subdivided());
  for (Subject& peer : found.subjects) subjects.push_back(std::move(peer));
  subjects.push_back(subject_fill());  // last: the ratios are to it
  auto document =
      run_benchmark(options, subjects, {std::cout, std::cerr, isatty(STDERR_FILENO) != 0});
  std::vector<Workload> loads = workloads(options.seed);
  std::erase_if(loads, [](const Workload& load) { return load.id != "W1" && load.id != "W3"; });
  document["threads"] = measure_threads(loads, {1, 2, 4}, options.timing);
  document["absent_peers"] = found.absent;
  document["build_information"] = found.build_information;
  const std::string text = document.dump(1) + "\n";
  cli::write_file(output_path, {reinterpret_cast<const uint8_t*>(text.data()), text.size()});
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Times our mapper, the usual arithmetics, the peers found by the build and a solid fill in "
      "one run, after holding each drawing against the exact model.");
  app.footer(
      "Example:\n  selvage_bench --seed 1 --output bench.json\n\n"
      "Exit codes: 0 measured, 1 a drawing that must be exact is not (nothing is timed), 2 wrong "
      "use.");
  BenchOptions options;
  std::string output_path;
  app.add_option("--output", output_path, "JSON file to write")->required();
  app.add_option("--seed", options.seed, "moves the mesh and the sampled rows")
      ->capture_default_str();
  app.add_option("--rows", options.rows, "rows of each target held against the exact model")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  app.add_option("--repetitions", options.timing.repetitions, "timings of each drawing")
      ->check(CLI::Range(3, 1000))
      ->capture_default_str();
  app.add_option("--min-time", options.timing.min_time_s, "seconds of one timing")
      ->check(CLI::Range(0.001, 10.0))
      ->capture_default_str();
  try {
    app.parse(argc, argv);
    run(options, output_path);
    return 0;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const WrongAnswer& error) {
    std::fprintf(stderr, "selvage_bench: %s\n", error.what());
    return 1;
  } catch (const cli::UserError& error) {
    std::fprintf(stderr, "selvage_bench: %s\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "selvage_bench: %s\n", error.what());
    return 1;
  }
}
