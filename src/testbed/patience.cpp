#include "testbed/patience.h"

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace selvage::testbed {
namespace {

using std::chrono::nanoseconds;

constexpr int kFirstPart = 8;    // of the limit: 1/8
constexpr int kMostStretch = 8;  // times the limit, on whatever machine
constexpr int kLeastGain = 64;   // of the limit: no less is waited for again

// Of all its threads together; nothing where there is no such process.
[[nodiscard]] nanoseconds processor_time(pid_t process) {
  clockid_t clock{};
  timespec time{};
  if (clock_getcpuclockid(process, &clock) != 0 || clock_gettime(clock, &time) != 0) return {};
  return std::chrono::seconds(time.tv_sec) + nanoseconds(time.tv_nsec);
}

// proc(5): in /proc/PID/task/TID/stat, behind the name in parentheses, R: it runs, or could.
[[nodiscard]] bool has_ready_thread(pid_t process) {
  std::error_code error;
  const std::string folder = "/proc/" + std::to_string(process) + "/task";
  for (std::filesystem::directory_iterator at(folder, error), end; !error && at != end;
       at.increment(error)) {
    std::ifstream file(at->path() / "stat");
    const std::string text(std::istreambuf_iterator<char>(file), {});
    const size_t name_end = text.rfind(") ");
    if (name_end != std::string::npos && text.compare(name_end + 2, 1, "R") == 0) return true;
  }
  return false;
}

}  // namespace

nanoseconds Patience::lost(pid_t worker) const {
  if (!has_ready_thread(worker)) return {};
  const nanoseconds since = waited() - seen_, had = processor_time(worker) - had_;
  return std::clamp(since - had, nanoseconds{0}, since);
}

nanoseconds Patience::next(pid_t worker) {
  if (stage_ == Stage::kFirstPart) {
    stage_ = Stage::kRest;
    return limit_ / kFirstPart;
  }
  if (stage_ == Stage::kRest) {
    stage_ = Stage::kMore;
    seen_ = waited();
    had_ = processor_time(worker);
    return limit_ - seen_;
  }
  const nanoseconds most = std::min(limit_ + lost(worker), limit_ * kMostStretch);
  const nanoseconds left = most - waited();
  return left * kLeastGain < limit_ ? nanoseconds{0} : left;
}

}  // namespace selvage::testbed
