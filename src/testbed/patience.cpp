#include "testbed/patience.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

namespace selvage::testbed {
namespace {

using std::chrono::nanoseconds;

constexpr int kFirstPart = 8;    // of the limit: 1/8
constexpr int kMostStretch = 8;  // times the limit, on whatever machine
constexpr int kLeastGain = 64;   // of the limit: no less is waited for again

}  // namespace

// proc(5): /proc/PID/task/TID/schedstat has the time on a processor and the time that the thread
// was ready and none was free, in nanoseconds. Where there is no such file, nothing is made good.
Patience::Waits Patience::waits(pid_t worker) {
  Waits waits;
  std::error_code error;
  const std::string folder = "/proc/" + std::to_string(worker) + "/task";
  for (std::filesystem::directory_iterator at(folder, error), end; !error && at != end;
       at.increment(error)) {
    int64_t ran_ns = 0, waited_ns = 0;
    if (std::ifstream(at->path() / "schedstat") >> ran_ns >> waited_ns) {
      waits[std::stoi(at->path().filename().string())] = nanoseconds(waited_ns);
    }
  }
  return waits;
}

nanoseconds Patience::lost(pid_t worker) const {
  nanoseconds most{0};
  for (const auto& [thread, wait] : waits(worker)) {
    const auto before = before_.find(thread);
    most = std::max(most, before == before_.end() ? wait : wait - before->second);
  }
  return most;
}

nanoseconds Patience::next(pid_t worker) {
  const auto now = std::chrono::steady_clock::now();
  if (stage_ == Stage::kFirstPart) {
    stage_ = Stage::kRest;
    return limit_ / kFirstPart;
  }
  if (stage_ == Stage::kRest) {
    stage_ = Stage::kMore;
    before_ = waits(worker);
    return begin_ + limit_ - now;
  }
  const nanoseconds most = std::min(limit_ + lost(worker), limit_ * kMostStretch);
  const nanoseconds left = begin_ + most - now;
  return left * kLeastGain < limit_ ? nanoseconds{0} : left;
}

}  // namespace selvage::testbed
