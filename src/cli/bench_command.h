// `selvage bench`.
#pragma once

#include <string>

#include "cli/console.h"

namespace CLI {
class App;
}

namespace selvage::cli {

// As given on the command line; empty means not given.
struct BenchOptions {
  std::string filter;   // empty: everything
  std::string compare;  // empty: with nothing
  std::string output;   // empty: no file
  std::string seed = "1";
  std::string rows = "64";
  std::string repetitions = "15";
  std::string min_time = "0.03";
  std::string padding = "16";
  std::string near_ties;  // maps to search; empty: no search
  bool curves = false;
  bool kernels = false;
  bool json = false;
  bool brief = false;
  bool list = false;
};

// The command with its options, help and examples.
CLI::App* add_bench(CLI::App& program, BenchOptions& options);

// Checks every answer against the exact model, then measures. Returns kExitFine, or kExitLawFailed
// where a drawing that must be right is not; never for slowness. In a build without Google
// Benchmark it throws a UserError that says what to install.
int run_bench(const BenchOptions& options, const Console& console);

}  // namespace selvage::cli
