#include "coverage/mutation/trial.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <new>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "mapper/mutants.h"

namespace selvage::mutation {
namespace {

inline constexpr double kLeastLimit_s = 1, kLimitPerCost = 20;
inline constexpr rlim_t kMostMemory_bytes = rlim_t{4} << 30;
inline constexpr int kStatusKilled = 42;

// What the process under trial tells of where it is.
struct Progress {
  volatile size_t tried, last;
};

// What an item without a mutant came to.
struct Report {
  bool breaks;
  double cost_s;
  unsigned char reached[mutants::kMost], applies[mutants::kMost];
};

// One for all processes from here on.
template <class Shared>
[[nodiscard]] Shared* shared() {
  static Shared* const it = [] {
    void* const memory =
        mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) throw std::runtime_error("no shared memory: mmap failed");
    return new (memory) Shared{};
  }();
  return it;
}

// Runs it in a process of its own; its status as waitpid() tells it.
template <class Run>
[[nodiscard]] int in_a_process(const Run& run) {
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no process for a trial: fork failed");
  if (child == 0) {
    run();
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return status;
}

[[nodiscard]] bool took_too_long(int status) {
  return WIFSIGNALED(status) && WTERMSIG(status) == SIGPROF;
}

[[nodiscard]] double processor_s() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// SIGPROF ends the process when it has used so much processor time from now on.
void limit_time(double limit_s) {
  itimerval timer{};
  timer.it_value.tv_sec = static_cast<time_t>(limit_s);
  timer.it_value.tv_usec =
      static_cast<suseconds_t>(1e6 * (limit_s - static_cast<double>(timer.it_value.tv_sec)));
  setitimer(ITIMER_PROF, &timer, nullptr);
}

void run_trial(const Mutant& mutant, const std::vector<Item>& items,
               const std::vector<size_t>& order, double most_s, Progress* progress) {
  const rlimit no_core{0, 0}, memory{kMostMemory_bytes, kMostMemory_bytes};
  setrlimit(RLIMIT_CORE, &no_core);
  setrlimit(RLIMIT_AS, &memory);
  const int nowhere = open("/dev/null", O_WRONLY);  // what a failed assertion says is known
  dup2(nowhere, STDERR_FILENO);
  mutants::active = mutant.number;
  for (const size_t i : order) {
    if (!items[i].reaches[static_cast<size_t>(mutant.site)]) continue;
    if (processor_s() > most_s) return;
    progress->last = i;
    progress->tried = progress->tried + 1;
    limit_time(std::max(kLeastLimit_s, kLimitPerCost * items[i].cost_s));
    if (items[i].breaks()) _exit(kStatusKilled);
  }
}

// Whether it costs no more than most_s; it is ended there.
[[nodiscard]] bool run_alone(Item* item, double most_s, bool* is_broken) {
  Report* const report = shared<Report>();
  const int status = in_a_process([&] {
    limit_time(most_s);
    const double start_s = processor_s();
    report->breaks = item->breaks();
    report->cost_s = processor_s() - start_s;
    std::memcpy(report->reached, mutants::reached, sizeof mutants::reached);
    std::memcpy(report->applies, mutants::applies, sizeof mutants::applies);
  });
  if (took_too_long(status)) return false;
  *is_broken = status != 0 || report->breaks;
  item->cost_s = report->cost_s;
  item->reaches.assign(std::begin(report->reached), std::end(report->reached));
  for (size_t i = 0; i < std::size(mutants::applies); ++i) {
    mutants::applies[i] |= report->applies[i];
  }
  return true;
}

}  // namespace

std::vector<std::string> record(std::vector<Item>* items, double most_s) {
  std::vector<std::string> broken;
  std::erase_if(*items, [&](Item& item) {
    bool is_broken = false;
    if (!run_alone(&item, most_s, &is_broken)) return true;
    if (is_broken) broken.push_back(item.killer + " " + item.on);
    return false;
  });
  std::ranges::stable_sort(*items, {}, [](const Item& item) { return std::ilogb(item.cost_s); });
  return broken;
}

Trials::Trials(std::vector<Item> items, double most_s)
    : items_(std::move(items)), order_(items_.size()), most_s_(most_s) {
  std::iota(order_.begin(), order_.end(), size_t{0});
}

void Trials::put_first(size_t item) {
  const auto at = std::ranges::find(order_, item);
  std::rotate(order_.begin(), at, at + 1);
}

Outcome Trials::of(const Mutant& mutant, const Outcome* killed_by) {
  const auto site = static_cast<size_t>(mutant.site);
  if (std::ranges::none_of(items_, [&](const Item& item) { return item.reaches[site]; })) {
    return {"not reached"};
  }
  if (mutants::applies[mutant.number] == 0) return {"does not apply"};
  if (killed_by != nullptr) {
    const auto by = std::ranges::find_if(items_, [&](const Item& item) {
      return item.killer == killed_by->killer && item.on == killed_by->on;
    });
    if (by != items_.end()) put_first(static_cast<size_t>(by - items_.begin()));
  }
  Progress* const progress = shared<Progress>();
  *progress = {};
  const double most_s = most_s_;
  const int status = in_a_process([&] { run_trial(mutant, items_, order_, most_s, progress); });
  Outcome outcome{"survived"};
  outcome.tried = progress->tried;
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return outcome;
  const size_t last = progress->last;
  put_first(last);
  outcome.killer = items_[last].killer;
  outcome.on = items_[last].on;
  if (WIFEXITED(status)) {
    outcome.what = WEXITSTATUS(status) == kStatusKilled ? "killed" : "crashed";
  } else {
    outcome.what = took_too_long(status) ? "hung" : "crashed";
  }
  return outcome;
}

}  // namespace selvage::mutation
