// The options of `selvage demo`.
#pragma once

#include <CLI/App.hpp>

#include "cli/demo_command.h"

namespace selvage::cli {

CLI::App* add_demo(CLI::App& program, DemoOptions& options);

}  // namespace selvage::cli
