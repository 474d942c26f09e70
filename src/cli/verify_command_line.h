// The options of `selvage verify` and `selvage merge`.
#pragma once

#include <CLI/App.hpp>

#include "cli/merge_command.h"
#include "cli/verify_command.h"

namespace selvage::cli {

CLI::App* add_verify(CLI::App& program, VerifyOptions& options);
CLI::App* add_merge(CLI::App& program, MergeOptions& options);

}  // namespace selvage::cli
