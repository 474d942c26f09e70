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

// "exited with status 3", "aborted (SIGABRT)": of a status as by waitpid, what follows "it".
[[nodiscard]] std::string describe_status(int wait_status);
// " (SIGABRT)".
[[nodiscard]] std::string name_of_signal(int signal);

// "hung: no answer in 2 s", of a worker that has been ended; if it was waited for much longer, that
// too.
[[nodiscard]] std::string describe_hang(std::chrono::nanoseconds limit,
                                        std::chrono::nanoseconds waited, const End& end);
// "0.2 s".
[[nodiscard]] std::string in_seconds(std::chrono::nanoseconds time);

}  // namespace selvage::testbed
