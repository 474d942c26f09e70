#include "testbed/ending.h"

#include <sys/resource.h>
#include <sys/wait.h>

#include <csignal>
#include <cstdio>
#include <cstring>

namespace selvage::testbed {
namespace {

inline constexpr uintptr_t kNearNull = 65536;

[[nodiscard]] std::string verb(Access access) {
  return access == Access::kWrite ? "wrote " : access == Access::kRead ? "read " : "touched ";
}

[[nodiscard]] std::string hexadecimal(uintptr_t address) {
  char text[32];
  std::snprintf(text, sizeof text, "0x%llx", static_cast<unsigned long long>(address));
  return text;
}

// The stack grows downward from there, at most as far as its limit.
[[nodiscard]] bool is_below_stack(uintptr_t address, uintptr_t stack) {
  rlimit limit{};
  getrlimit(RLIMIT_STACK, &limit);
  const uintptr_t most = limit.rlim_cur == RLIM_INFINITY ? uintptr_t{8} << 20 : limit.rlim_cur;
  return address < stack && stack - address < most + (uintptr_t{1} << 20);
}

[[nodiscard]] std::string describe_access(const Control& control, const Placement& placement) {
  const End& end = control.end;
  if (!end.is_address_known) return "used an address that there cannot be";
  const std::string place = placement.place_of(end.address);
  if (!place.empty()) return verb(end.access) + place;
  if (end.address < kNearNull) return verb(end.access) + "through a null pointer";
  if (end.has_left_stack || is_below_stack(end.address, control.stack)) return "ran out of stack";
  return verb(end.access) + "memory that it was not given, at " + hexadecimal(end.address);
}

[[nodiscard]] std::string describe_signal(int signal) {
  switch (signal) {
    case SIGABRT:
      return "aborted";
    case SIGFPE:
      return "divided by zero, or alike";
    case SIGILL:
      return "ran into an illegal instruction";
    case SIGSEGV:
    case SIGBUS:
      return "touched memory that it was not given";
    default:
      return "was ended by a signal";
  }
}

}  // namespace

std::string name_of_signal(int signal) {
  const char* name = sigabbrev_np(signal);
  return " (" + (name != nullptr ? "SIG" + std::string(name) : std::to_string(signal)) + ")";
}

std::string describe_status(int wait_status) {
  if (!WIFSIGNALED(wait_status)) {
    return "exited with status " + std::to_string(WEXITSTATUS(wait_status));
  }
  const int signal = WTERMSIG(wait_status);
  return describe_signal(signal) + name_of_signal(signal);
}

namespace {

// A lack of memory may be why.
[[nodiscard]] std::string describe_memory(const End& end) {
  constexpr double kMiB = 1 << 20;
  if (end.memory_bytes < kMostMemoryBytes / 2) {
    const bool is_null = end.signal == SIGSEGV && end.is_address_known && end.address < kNearNull;
    if (!is_null) return {};
    return "; if that was for want of memory: it may take " +
           std::to_string(kMostMemoryBytes >> 20) + " MiB";
  }
  char text[96];
  std::snprintf(text, sizeof text, ", with %.0f MiB of memory in use; it may take %.0f",
                static_cast<double>(end.memory_bytes) / kMiB,
                static_cast<double>(kMostMemoryBytes) / kMiB);
  return text;
}

[[nodiscard]] std::string describe_cause(const Control& control, const Placement& placement) {
  const End& end = control.end;
  if (end.fork_error != 0) {
    return std::string("left no process to draw in: ") + std::strerror(end.fork_error);
  }
  if (end.threw) return "threw an exception through the C interface";
  if (const int signal = end.signal; signal != 0 && signal != SIGABRT && end.was_sent) {
    return "was ended by a signal that was sent to it" + name_of_signal(signal);
  } else if (signal == SIGSEGV || signal == SIGBUS) {
    return describe_access(control, placement) + name_of_signal(signal);
  } else if (signal != 0) {
    return describe_signal(signal) + name_of_signal(signal);
  }
  return describe_status(end.wait_status);
}

}  // namespace

std::string describe_end(const Control& control, const Placement& placement) {
  return describe_cause(control, placement) + describe_memory(control.end);
}

std::string describe_hang(std::chrono::nanoseconds limit, std::chrono::nanoseconds waited,
                          const End& end) {
  char more[64] = "";
  if (waited > limit * 3 / 2) {
    std::snprintf(more, sizeof more, ", nor in %.1f s of a busy machine",
                  static_cast<double>(waited.count()) * 1e-9);
  }
  return "hung: no answer in " + in_seconds(limit) + more + describe_memory(end);
}

std::string in_seconds(std::chrono::nanoseconds time) {
  char text[40];
  std::snprintf(text, sizeof text, "%g s", static_cast<double>(time.count()) * 1e-9);
  return text;
}

}  // namespace selvage::testbed
