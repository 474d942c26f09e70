// The process between the program and the keeper, to which everything comes that loses its parent.
#pragma once

#include <sys/types.h>

#include <csignal>

namespace selvage::testbed {

inline constexpr int kEndAll = SIGTERM;      // what the program tells it
inline constexpr int kEndOrphans = SIGUSR1;  // what the keeper does, when a worker has ended

// In a process forked by `parent`, with all signals blocked. Forks, and returns in the new process
// alone, which is to be the keeper. The calling one stays behind as its reaper: told kEndOrphans,
// it ends what the library has forked and left; told kEndAll, or when the keeper or `parent` ends,
// the keeper as well, and then itself, in the way that the keeper did. Returns the reaper's number.
[[nodiscard]] pid_t stay_behind_as_reaper(pid_t parent);

}  // namespace selvage::testbed
