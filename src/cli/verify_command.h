// `selvage verify`.
#pragma once

#include <string>
#include <vector>

#include "cli/console.h"
#include "cli/subject_options.h"
#include "spec/subject.h"

namespace selvage::cli {

// As given on the command line; empty means not given.
struct VerifyOptions {
  std::vector<std::string> laws;  // empty: all that the subject promises
  std::string profile;            // of generated cases; a replayed one names its own
  std::string cases = "1000";
  std::string hunt;       // hunted cases; empty: none, or by turns with the others in a time
  std::string seed;       // empty: a fresh one
  std::string shard;      // "2/8"; empty: all
  std::string time;       // seconds, instead of a number of cases
  std::string corpus;     // a directory of known violations
  std::string case_hex;   // one case to replay,
  std::string case_file;  // or the same from raw bytes
  std::string picture;    // empty: selvage-<law>.png
  bool draws_pictures = true;
  std::string junit;    // a file for JUnit XML
  bool shrinks = true;  // the counterexamples
  bool json = false;
  SubjectOptions subject;
};

// Holds the subject, or the one that the options name, against the laws. Returns kExitFine or
// kExitLawFailed, or kExitNoTime.
int run_verify(const VerifyOptions& options, const spec::Subject& built_in, const Console& console);

}  // namespace selvage::cli
