// How long a call is waited for: a busy machine takes nothing from its time.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <map>

namespace selvage::testbed {

// The limit of a call in real time, moved on by as long as the worker was kept waiting for a
// processor: of its threads, the one that waited longest.
class Patience {
 public:
  // The worker has just been given its call, which may take `limit`.
  explicit Patience(std::chrono::nanoseconds limit)
      : begin_(std::chrono::steady_clock::now()), limit_(limit) {}

  // What the call may go on for before it has to be asked again. Nothing is looked up for calls
  // that end in the first part of their time: what these lose is not made good.
  [[nodiscard]] std::chrono::nanoseconds next(pid_t worker);

 private:
  using Waits = std::map<pid_t, std::chrono::nanoseconds>;  // by thread, since each began
  [[nodiscard]] static Waits waits(pid_t worker);
  [[nodiscard]] std::chrono::nanoseconds lost(pid_t worker) const;

  std::chrono::steady_clock::time_point begin_;
  std::chrono::nanoseconds limit_;
  Waits before_{};
  enum class Stage { kFirstPart, kRest, kMore } stage_ = Stage::kFirstPart;
};

}  // namespace selvage::testbed
