#include "coverage/mutation/trial.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <new>
#include <stdexcept>

#include "mapper/mutants.h"

namespace selvage::mutation {
namespace {

inline constexpr double kLeastLimit_s = 1, kLimitPerCost = 20;
inline constexpr double kCostly_s = 0.1;
inline constexpr rlim_t kMostMemory_bytes = rlim_t{4} << 30;
inline constexpr int kStatusKilled = 42;

// What the process under trial tells of where it is.
struct Progress {
  volatile size_t tried, last;
};

[[nodiscard]] Progress* shared_progress() {
  static Progress* const progress = [] {
    void* const memory =
        mmap(nullptr, sizeof(Progress), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) throw std::runtime_error("no shared memory: mmap failed");
    return new (memory) Progress{};
  }();
  return progress;
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

[[noreturn]] void run_trial(const Mutant& mutant, const std::vector<Item>& items,
                            Progress* progress) {
  const rlimit no_core{0, 0}, memory{kMostMemory_bytes, kMostMemory_bytes};
  setrlimit(RLIMIT_CORE, &no_core);
  setrlimit(RLIMIT_AS, &memory);
  const int nowhere = open("/dev/null", O_WRONLY);  // what a failed assertion says is known
  dup2(nowhere, STDERR_FILENO);
  mutants::active = mutant.number;
  for (size_t i = 0; i < items.size(); ++i) {
    if (!items[i].reaches[static_cast<size_t>(mutant.site)]) continue;
    progress->last = i;
    progress->tried = progress->tried + 1;
    limit_time(std::max(kLeastLimit_s, kLimitPerCost * items[i].cost_s));
    if (items[i].breaks()) _exit(kStatusKilled);
  }
  _exit(0);
}

}  // namespace

std::vector<std::string> record(std::vector<Item>* items, double most_s) {
  std::vector<std::string> broken;
  for (Item& item : *items) {
    std::memset(mutants::reached, 0, sizeof mutants::reached);
    const double start_s = processor_s();
    if (item.breaks()) broken.push_back(item.killer + " " + item.on);
    item.cost_s = processor_s() - start_s;
    item.reaches.assign(std::begin(mutants::reached), std::end(mutants::reached));
  }
  std::erase_if(*items, [&](const Item& item) { return item.cost_s > most_s; });
  std::ranges::stable_partition(*items, [](const Item& item) { return item.cost_s < kCostly_s; });
  return broken;
}

Outcome try_mutant(const Mutant& mutant, const std::vector<Item>& items) {
  const auto site = static_cast<size_t>(mutant.site);
  if (std::ranges::none_of(items, [&](const Item& item) { return item.reaches[site]; })) {
    return {"not reached"};
  }
  if (mutants::applies[mutant.number] == 0) return {"does not apply"};
  Progress* const progress = shared_progress();
  *progress = {};
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no process for a mutant: fork failed");
  if (child == 0) run_trial(mutant, items, progress);
  int status = 0;
  waitpid(child, &status, 0);

  Outcome outcome{"survived"};
  outcome.tried = progress->tried;
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return outcome;
  const Item& last = items[progress->last];
  outcome.killer = last.killer;
  outcome.on = last.on;
  if (WIFEXITED(status)) {
    outcome.what = WEXITSTATUS(status) == kStatusKilled ? "killed" : "crashed";
  } else {
    outcome.what = WTERMSIG(status) == SIGPROF ? "hung" : "crashed";
  }
  return outcome;
}

}  // namespace selvage::mutation
