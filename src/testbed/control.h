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
  kIdle,  // it waits for a call; what it did last is in `answer`
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
  bool has_left_stack = false;  // the stack pointer was where no memory is
  bool was_sent = false;        // by a process: it tells of no fault
  bool threw = false;           // an exception came out of the call
  int fork_error = 0;           // as in errno: there was no worker at all
  int wait_status = 0;          // as by waitpid
  uint64_t memory_bytes = 0;    // the most that were in use at a time
};

inline constexpr uint64_t kMostMemoryBytes = uint64_t{1} << 30;  // that a library may take

enum class Function : uint32_t {
  kDraw,
  kDrawMany,
  kDrawManyBytes,
  kPrepare,
  kPrepareBytes,
  kChoose
};
inline constexpr std::array<const char*, 6> kFunctionNames = {
    "selvage_draw",    "selvage_draw_many",     "selvage_draw_many_bytes",
    "selvage_prepare", "selvage_prepare_bytes", "selvage_choose"};

[[nodiscard]] constexpr const char* name_of(Function function) {
  return kFunctionNames[static_cast<size_t>(function)];
}
[[nodiscard]] constexpr uint32_t bit_of(Function function) {
  return uint32_t{1} << static_cast<uint32_t>(function);
}

// The arguments of any of them; each looks at its own.
struct Call {
  Function function = Function::kDraw;
  const selvage_image* target = nullptr;
  const selvage_rect* clip = nullptr;
  const selvage_polygon* polygons = nullptr;  // draw and choose: one; prepare: one's texture
  size_t count = 0;                           // of them
  const selvage_options* options = nullptr;
  int32_t threads = 0;
  selvage_layout layout = SELVAGE_LAYOUT_ROWS;
  int32_t with_sums = 0;
  void* memory = nullptr;  // to prepare in, or scratch
  size_t bytes = 0;        // of it
  size_t* failed = nullptr;
  selvage_choice* choice = nullptr;
  selvage_texture* prepared = nullptr;
};

// Each function gives one of them.
struct Answer {
  selvage_status status = SELVAGE_OK;
  size_t bytes = 0;
  bool changed_arithmetic = false;  // it left floating-point numbers to be rounded otherwise
};

struct Control {
  std::atomic<uint32_t> state{static_cast<uint32_t>(State::kLoading)};
  std::atomic<uint32_t> step{static_cast<uint32_t>(Step::kLoad)};
  std::array<char, 1024> refusal{};
  uint32_t exported = 0;  // sum of bit_of()
  bool has_claims = false;
  selvage_claims claims{};  // its texts are below
  std::array<char, 128> name{}, version{};
  std::atomic<pid_t> keeper{0}, worker{0};
  uintptr_t stack = 0;  // an address near the beginning of the worker's
  Call call{};
  Answer answer{};
  End end{};
};

// Sets the state and wakes whoever waits for it.
void set_state(Control& control, State state);
void wake(const Control& control);
// Waits until the state is not `state`, or the time is over; tells what it is then.
[[nodiscard]] State wait_while(Control& control, State state,
                               std::optional<std::chrono::nanoseconds> most = std::nullopt);

}  // namespace selvage::testbed
