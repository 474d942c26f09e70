#include "testbed/control.h"

#include <linux/futex.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <climits>
#include <ctime>

namespace selvage::testbed {
namespace {

// Most calls end sooner than a sleeper is woken.
inline constexpr int kLooksBeforeSleep = 2000;

[[nodiscard]] State now(const Control& control) {
  return static_cast<State>(control.state.load(std::memory_order_acquire));
}

void sleep_while(Control& control, State state, const timespec* most) {
  syscall(SYS_futex, reinterpret_cast<uint32_t*>(&control.state), FUTEX_WAIT,
          static_cast<uint32_t>(state), most, nullptr, 0);
}

}  // namespace

void set_state(Control& control, State state) {
  control.state.store(static_cast<uint32_t>(state), std::memory_order_release);
  wake(control);
}

void wake(const Control& control) {
  syscall(SYS_futex, reinterpret_cast<const uint32_t*>(&control.state), FUTEX_WAKE, INT_MAX,
          nullptr, nullptr, 0);
}

State wait_while(Control& control, State state, std::optional<std::chrono::nanoseconds> most) {
  for (int i = 0; i < kLooksBeforeSleep; ++i) {
    if (now(control) != state) return now(control);
  }
  using std::chrono::steady_clock;
  const auto end = steady_clock::now() + most.value_or(std::chrono::nanoseconds(0));
  while (now(control) == state) {
    if (!most) {
      sleep_while(control, state, nullptr);
      continue;
    }
    const auto left = std::chrono::nanoseconds(end - steady_clock::now()).count();
    if (left <= 0) break;
    const timespec time{left / 1'000'000'000, left % 1'000'000'000};
    sleep_while(control, state, &time);
  }
  return now(control);
}

}  // namespace selvage::testbed
