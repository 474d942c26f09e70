// `selvage merge`: the shards of a run, added up.
#pragma once

#include <string>
#include <vector>

#include "cli/console.h"
#include "cli/verdict.h"

namespace selvage::cli {

struct MergeOptions {
  std::vector<std::string> files;  // as `verify --shard I/N --json` prints them
  std::string corpus{};            // a directory for the violations that are new; empty: none
  std::string junit;
  bool json = false;
};

struct ShardFile {
  std::string name;
  VerifyRun run;
};

// The verdict of the run that was not sharded, whatever the order of the files; times are added up.
// Throws UserError where they are not all shards of one run.
[[nodiscard]] VerifyRun merged(std::vector<ShardFile> files);

// Returns kExitFine, kExitLawFailed or kExitNoTime.
int run_merge(const MergeOptions& options, const Console& console);

}  // namespace selvage::cli
