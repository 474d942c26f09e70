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

// What the keeper's own work may take at least: a machine may be very busy.
inline constexpr auto kLeastForkLimit = std::chrono::seconds(5);

struct Host::Keeper {
  Arenas arenas;
  Arena control_memory{sizeof(Control)};
  Control& control;
  int output;
  pid_t process = -1;  // its reaper; -1: none, and these two tell how the last keeper ended
  int stopped_by = 0;  // a signal; 0: it was not stopped
  int wait_status = 0;

  Keeper();
  Keeper(const Keeper&) = delete;
  Keeper& operator=(const Keeper&) = delete;
  ~Keeper();

  void start(const std::string& library);
  void end();  // and all that the library has forked
  // One that was stopped is ended: nobody would wake it.
  [[nodiscard]] bool is_alive();
  // "ended the process that holds it, which exited with status 3", of one that is not alive: each
  // verb for its case, and the process.
  [[nodiscard]] std::string describe_loss(const std::string& ended, const std::string& stopped,
                                          const std::string& which) const;
  // Waits until the state is another; `state` itself where the time is over or the keeper dead.
  [[nodiscard]] State next(State state, std::chrono::nanoseconds most);
  // Waits for a call that has been handed over; State::kCall where its time is over, after
  // `waited`.
  [[nodiscard]] State next_after_call(std::chrono::nanoseconds limit,
                                      std::chrono::nanoseconds* waited);
  // Ends the worker, if there is one, and waits for the keeper to say so. A keeper that does not is
  // ended, too.
  void end_worker();
  [[nodiscard]] State state() const { return static_cast<State>(control.state.load()); }
  // Gives a worker that waits its call; false where it has ended before.
  [[nodiscard]] bool hand_over();

 private:
  void kill_worker() const;
};

// The memory that textures have been prepared in, as the caller and as the subject sees it.
struct Host::Blocks {
  std::vector<Placed> placed;
  bool at_end = true;  // of its arena, the next one
};

}  // namespace selvage::testbed
