// How a worker ended, in words.
#pragma once

#include <chrono>
#include <string>

#include "testbed/control.h"
#include "testbed/placement.h"

namespace selvage::testbed {

// "wrote just after the end of the target, ... (SIGSEGV)", "exited with status 3": what follows
// "it".
[[nodiscard]] std::string describe_end(const Control& control, const Placement& placement);

// "hung: no answer in 2 s".
[[nodiscard]] std::string describe_hang(std::chrono::nanoseconds limit);

}  // namespace selvage::testbed
