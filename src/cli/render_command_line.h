// The options of `selvage render`.
#pragma once

#include <CLI/App.hpp>

#include "cli/render_command.h"

namespace selvage::cli {

CLI::App* add_render(CLI::App& program, RenderOptions& options);

}  // namespace selvage::cli
