#include "testbed/patience.h"

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

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

// proc(5): /proc/PID/stat, or that of a thread, behind the name in parentheses.
struct Stat {
  char state = 0;  // R: it runs, or could
  pid_t parent = 0, group = 0;

  explicit Stat(const std::filesystem::path& folder) {
    std::ifstream file(folder / "stat");
    const std::string text(std::istreambuf_iterator<char>(file), {});
    const size_t name_end = text.rfind(") ");
    if (name_end == std::string::npos) return;
    std::istringstream(text.substr(name_end + 2)) >> state >> parent >> group;
  }
};

template <class Visit>
void for_each_entry(const std::string& folder, const Visit& visit) {
  std::error_code error;
  for (std::filesystem::directory_iterator at(folder, error), end; !error && at != end;
       at.increment(error)) {
    visit(at->path());
  }
}

[[nodiscard]] bool has_ready_thread(pid_t process) {
  bool is_ready = false;
  for_each_entry("/proc/" + std::to_string(process) + "/task",
                 [&](const auto& thread) { is_ready = is_ready || Stat(thread).state == 'R'; });
  return is_ready;
}

// It and all others of the group that it leads, if it does.
[[nodiscard]] std::vector<pid_t> with_group(pid_t leader) {
  std::vector<pid_t> processes{leader};
  for_each_entry("/proc", [&](const auto& entry) {
    const auto process = static_cast<pid_t>(std::atoi(entry.filename().c_str()));
    if (process > 0 && process != leader && Stat(entry).group == leader) {
      processes.push_back(process);
    }
  });
  return processes;
}

[[nodiscard]] nanoseconds processor_time(const std::vector<pid_t>& processes) {
  nanoseconds time{};
  for (const pid_t process : processes) time += processor_time(process);
  return time;
}

}  // namespace

nanoseconds Patience::lost(pid_t worker) const {
  const std::vector<pid_t> processes = with_group(worker);
  if (std::ranges::none_of(processes, has_ready_thread)) return {};
  const nanoseconds since = waited() - seen_, had = processor_time(processes) - had_;
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
    had_ = processor_time(with_group(worker));
    return limit_ - seen_;
  }
  const nanoseconds most = std::min(limit_ + lost(worker), limit_ * kMostStretch);
  const nanoseconds left = most - waited();
  return left * kLeastGain < limit_ ? nanoseconds{0} : left;
}

}  // namespace selvage::testbed
