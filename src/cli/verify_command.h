// `selvage verify`.
#pragma once

#include <string>
#include <vector>

#include "cli/console.h"
#include "spec/subject.h"

namespace selvage::cli {

// As given on the command line; empty means not given.
struct VerifyOptions {
  std::vector<std::string> laws;  // empty: all that the profile promises
  std::string profile = "exact";  // of generated cases; a replayed one names its own
  std::string cases = "200";
  std::string seed;       // empty: a fresh one
  std::string case_hex;   // one case to replay,
  std::string case_file;  // or the same from raw bytes
  std::string picture;    // empty: selvage-<law>.png
  bool json = false;
};

// Holds the subject against the laws. Returns kExitFine or kExitLawFailed.
int run_verify(const VerifyOptions& options, const spec::Subject& subject, const Console& console);

}  // namespace selvage::cli
