// `selvage stability`.
#pragma once

#include <string>
#include <vector>

#include "cli/console.h"
#include "cli/subject_options.h"
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
  SubjectOptions subject;  // a library to measure, too
};

// Measures arithmetics on the hard families; the mapper's profiles are among them, and the library
// that the options name. Returns kExitFine, or kExitLawFailed where a promise is broken: a texel
// beyond its derived bound, a pixel of `exact` that is not the model's, a call of the library that
// does not end as calls do.
int run_stability(const StabilityOptions& options, const spec::Subject& mapper,
                  const Console& console);

}  // namespace selvage::cli
