// The command line: what the user typed to what is run.
#pragma once

#include <string>
#include <vector>

#include "cli/console.h"
#include "spec/subject.h"

namespace selvage::cli {

// Runs the program on its arguments (without the program's name) and returns its exit code.
// Throws nothing that main would have to know: errors are printed to console.err.
int run_program(std::vector<std::string> arguments, const spec::Subject& subject,
                const Console& console);

}  // namespace selvage::cli
