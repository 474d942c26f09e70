// `selvage stability`.
#pragma once

#include <string>
#include <vector>

#include "cli/console.h"
#include "spec/subject.h"

namespace selvage::cli {

// As given on the command line; empty means not given.
struct StabilityOptions {
  std::vector<std::string> families;     // empty: all
  std::vector<std::string> arithmetics;  // empty: all
  std::string cases = "20";
  std::string seed;     // empty: a fresh one
  std::string picture;  // empty: none
  bool json = false;
  bool list = false;
};

// Measures arithmetics on the hard families; the subject is the mapper whose profiles are among
// them. Returns kExitFine, or kExitLawFailed where a promise is broken: a texel beyond its derived
// bound, or a pixel of `exact` that is not the model's.
int run_stability(const StabilityOptions& options, const spec::Subject& subject,
                  const Console& console);

}  // namespace selvage::cli
