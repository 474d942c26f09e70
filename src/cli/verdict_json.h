// A run of `selvage verify` as JSON, and back.
#pragma once

#include <string>
#include <string_view>

#include "cli/verdict.h"

namespace selvage::cli {

[[nodiscard]] std::string verdict_json(const VerifyRun& run);

// What verdict_json has written, by this version of the program. Errors are UserErrors
// "FILE:LINE: what is wrong".
[[nodiscard]] VerifyRun read_verdict(const std::string& file, std::string_view text);

}  // namespace selvage::cli
