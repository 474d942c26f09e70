// A run of `selvage verify` as JSON, and back.
#pragma once

#include <string>

#include "cli/verdict.h"

namespace selvage::cli {

[[nodiscard]] std::string verdict_json(const VerifyRun& run);

// What verdict_json has written, by this version of the program. Throws UserError.
[[nodiscard]] VerifyRun read_verdict(const std::string& json);

}  // namespace selvage::cli
