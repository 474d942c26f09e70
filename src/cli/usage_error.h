// What was typed and cannot be meant.
#pragma once

#include <CLI/App.hpp>

#include "cli/error.h"

namespace selvage::cli {

// Of an error that parsing has met: the word that is no command, or what else is wrong and what was
// not expected, in the order in which it was given; and where help is.
[[nodiscard]] UserError usage_error(const CLI::App& program, const CLI::ParseError& error);

}  // namespace selvage::cli
