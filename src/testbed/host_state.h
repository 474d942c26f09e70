// What a host keeps: the process that loaded the library, and the memory that it shares with it.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <string>
#include <vector>

#include "testbed/control.h"
#include "testbed/host.h"
#include "testbed/placement.h"

namespace selvage::testbed {

struct Host::Keeper {
  Arenas arenas;
  Arena control_memory{sizeof(Control)};
  Control& control;
  int output;
  pid_t process = -1;

  Keeper();
  Keeper(const Keeper&) = delete;
  Keeper& operator=(const Keeper&) = delete;
  ~Keeper();

  void start(const std::string& library);
  void end();  // and all that the library has forked and that is in its group
  [[nodiscard]] bool is_alive();
  // Waits until the state is another; `state` itself where the time is over or the keeper dead.
  [[nodiscard]] State next(State state, std::chrono::nanoseconds most);
  void end_worker() const;
  [[nodiscard]] State state() const { return static_cast<State>(control.state.load()); }
  // A worker that waits for a call.
  void have_worker();
};

// The memory that textures have been prepared in, as the caller and as the subject sees it.
struct Host::Blocks {
  std::vector<Placed> placed;
  bool at_end = true;  // of its arena, the next one
};

}  // namespace selvage::testbed
