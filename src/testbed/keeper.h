// The processes that the subject runs in.
#pragma once

#include <span>
#include <string>

#include "testbed/arena.h"
#include "testbed/control.h"

namespace selvage::testbed {

// The keeper's whole life, in a process forked for it: loads the library, then forks a worker
// whenever it is told to, and tells how each ended. `reaper` is its parent; `output` is a
// descriptor that takes what the subject prints; textures are prepared in the arenas
// `to_prepare_in`. Never returns.
[[noreturn]] void keep(Control& control, const std::string& library, int output, pid_t reaper,
                       std::span<const Arena> to_prepare_in);

}  // namespace selvage::testbed
