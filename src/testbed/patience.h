// How long a call is waited for: a busy machine takes nothing from its time.
#pragma once

#include <sys/types.h>

#include <chrono>

namespace selvage::testbed {

// The limit of a call in real time, moved on by what its process and those of its group, which are
// what it forks, lack of one processor together: where one is ready to run and none does.
class Patience {
 public:
  // The worker has just been given its call, which may take `limit`.
  explicit Patience(std::chrono::nanoseconds limit)
      : begin_(std::chrono::steady_clock::now()), limit_(limit) {}

  // What the call may go on for before it has to be asked again. Nothing is looked up for calls
  // that end in the first part of their time: what these lose is not made good.
  [[nodiscard]] std::chrono::nanoseconds next(pid_t worker);
  // How long it has gone on.
  [[nodiscard]] std::chrono::nanoseconds waited() const {
    return std::chrono::steady_clock::now() - begin_;
  }

 private:
  [[nodiscard]] std::chrono::nanoseconds lost(pid_t worker) const;

  std::chrono::steady_clock::time_point begin_;
  std::chrono::nanoseconds limit_;
  std::chrono::nanoseconds seen_{}, had_{};  // a look at it: when, and its time on processors
  enum class Stage { kFirstPart, kRest, kMore } stage_ = Stage::kFirstPart;
};

}  // namespace selvage::testbed
