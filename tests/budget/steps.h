// Counts the instructions of what valgrind does not run, AVX-512's among them.
#pragma once

#include <cstdint>

#if defined(__x86_64__) && defined(__linux__)
#include <x86intrin.h>

#include <atomic>
#include <csignal>

namespace selvage::budget {

inline constexpr bool kCountsSteps = true;

// Instructions of `work` and some ten of the counting itself. The processor's trap flag raises a
// signal behind each (Intel 64 and IA-32 Architectures Software Developer's Manual, 17.3.1.4), up
// to 12 us an instruction. On the calling thread alone; what the system does is not counted, and of
// an instruction with a repeat prefix each repetition is.
template <typename Function>
[[nodiscard]] uint64_t instructions_of(Function&& work) {
  constexpr unsigned long long kTrapFlag = 0x100;
  static std::atomic<uint64_t> count;
  static_assert(std::atomic<uint64_t>::is_always_lock_free);  // a handler of signals may use it
  using Action = struct sigaction;
  Action on_trap{}, before{};
  on_trap.sa_handler = [](int) { count.fetch_add(1, std::memory_order_relaxed); };
  sigaction(SIGTRAP, &on_trap, &before);
  count = 0;
  __writeeflags(__readeflags() | kTrapFlag);
  work();
  __writeeflags(__readeflags() & ~kTrapFlag);
  sigaction(SIGTRAP, &before, nullptr);
  return count;
}

}  // namespace selvage::budget
#else
namespace selvage::budget {

inline constexpr bool kCountsSteps = false;

// Counts nothing.
template <typename Function>
[[nodiscard]] uint64_t instructions_of(Function&& work) {
  work();
  return 0;
}

}  // namespace selvage::budget
#endif
