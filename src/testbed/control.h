// What the program and the process with the subject tell each other, in memory that both see.
#pragma once

#include <sys/types.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "selvage.h"
#include "selvage_subject.h"

namespace selvage::testbed {

// Who is next, or what has become of it. The keeper has loaded the library and forks workers, one
// at a time; the worker draws.
enum class State : uint32_t {
  kLoading,  // the keeper's turn
  kRefused,  // it could not load the library: `refusal`
  kNoWorker,
  kFork,  // the keeper's turn
  kCall,  // the worker's turn
  kIdle,  // it waits for a call; what it did last is in `status`
  kGone   // it has ended: `end`
};

// What the keeper is at while it loads.
enum class Step : uint32_t { kLoad, kDescribe, kDone };

enum class Access : uint32_t { kUnknown, kRead, kWrite };

// How a worker ended. Its signal handler fills in the fault, the keeper the rest.
struct End {
  std::atomic<int32_t> signal{0};  // that the handler saw; 0: it saw none
  Access access = Access::kUnknown;
  uintptr_t address = 0;  // of the access, where the signal is about one
  bool is_address_known = false;
  bool threw = false;   // an exception came out of the call
  int wait_status = 0;  // as by waitpid
};

struct Call {
  const selvage_image* target;
  const selvage_rect* clip;
  const selvage_vertex* vertices;
  size_t count;
  const selvage_texture* texture;
  const selvage_options* options;
};

struct Control {
  std::atomic<uint32_t> state{static_cast<uint32_t>(State::kLoading)};
  std::atomic<uint32_t> step{static_cast<uint32_t>(Step::kLoad)};
  std::array<char, 1024> refusal{};
  bool has_claims = false;
  selvage_claims claims{};  // its texts are below
  std::array<char, 128> name{}, version{};
  std::atomic<pid_t> worker{0};
  uintptr_t stack = 0;  // an address near the beginning of the worker's
  Call call{};
  selvage_status status = SELVAGE_OK;
  End end{};
};

// Sets the state and wakes whoever waits for it.
void set_state(Control& control, State state);
// Waits until the state is not `state`, or the time is over; tells what it is then.
[[nodiscard]] State wait_while(Control& control, State state,
                               std::optional<std::chrono::nanoseconds> most = std::nullopt);

}  // namespace selvage::testbed
