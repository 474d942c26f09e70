// The options of `selvage verify` and `selvage merge`.
#pragma once

#include <CLI/App.hpp>

#include "cli/merge_command.h"
#include "cli/verify_command.h"

namespace selvage::cli {

inline constexpr const char* kUsualExitCodes =
    "Exit codes: 0 fine; 1 a law failed; 2 wrong use, or a file that cannot be read or written.";

CLI::App* add_verify(CLI::App& program, VerifyOptions& options);
CLI::App* add_merge(CLI::App& program, MergeOptions& options);

}  // namespace selvage::cli
