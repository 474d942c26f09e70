// The processes that the subject runs in.
#pragma once

#include <string>

#include "testbed/control.h"

namespace selvage::testbed {

// The keeper's whole life, in a process forked for it: loads the library, then forks a worker
// whenever it is told to, and tells how each ended. `output` is a descriptor that takes what the
// subject prints. Never returns.
[[noreturn]] void keep(Control& control, const std::string& library, int output, pid_t parent);

}  // namespace selvage::testbed
