#include "testbed/reaper.h"

#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <fstream>
#include <iterator>
#include <vector>

namespace selvage::testbed {
namespace {

inline constexpr auto kMostToEnd = std::chrono::seconds(2);
inline constexpr useconds_t kBetweenLooks_us = 1000;

// By proc(5); none where the kernel does not list them.
[[nodiscard]] std::vector<pid_t> children() {
  std::ifstream file("/proc/thread-self/children");
  return {std::istream_iterator<pid_t>(file), {}};
}

[[nodiscard]] bool has_children() {
  siginfo_t info{};
  return waitid(P_ALL, 0, &info, WEXITED | WNOHANG | WNOWAIT | __WALL) == 0 || errno != ECHILD;
}

// What a child leaves becomes a child in turn. The kernel's list may lack some where others end
// while it is read.
void end_children_but(pid_t spared) {
  const auto end = std::chrono::steady_clock::now() + kMostToEnd;
  while (std::chrono::steady_clock::now() < end) {
    std::vector<pid_t> left = children();
    std::erase(left, spared);
    if (left.empty() && (spared != 0 || !has_children())) return;
    for (const pid_t child : left) {
      kill(child, SIGKILL);
      waitpid(child, nullptr, WNOHANG | __WALL);
    }
    usleep(kBetweenLooks_us);
  }
}

// In the way that `keeper` tells, the program's own child: it learns it from the kernel alone.
[[noreturn]] void end_as(const siginfo_t& keeper) {
  if (keeper.si_pid == 0) _exit(0);
  if (keeper.si_code == CLD_EXITED) _exit(keeper.si_status);
  std::signal(keeper.si_status, SIG_DFL);
  kill(getpid(), keeper.si_status);
  sigset_t none{};
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  _exit(0);
}

[[noreturn]] void watch(pid_t keeper) {
  sigset_t awaited{};
  for (const int signal : {SIGCHLD, kEndAll, kEndOrphans}) sigaddset(&awaited, signal);
  for (;;) {
    const int signal = sigwaitinfo(&awaited, nullptr);
    siginfo_t ended{};  // its number, and that of its group, is no other's until it is waited for
    waitid(P_PID, static_cast<id_t>(keeper), &ended, WEXITED | WSTOPPED | WNOHANG | WNOWAIT);
    if (ended.si_pid != 0 || signal == kEndAll) {
      kill(-keeper, SIGKILL);
      end_children_but(0);
      end_as(ended);
    }
    if (signal == kEndOrphans) end_children_but(keeper);
  }
}

}  // namespace

pid_t stay_behind_as_reaper(pid_t parent) {
  const rlimit none{0, 0};
  setrlimit(RLIMIT_CORE, &none);
  std::signal(SIGCHLD, SIG_DFL);  // else children would not wait to be waited for
  setpgid(0, 0);
  prctl(PR_SET_CHILD_SUBREAPER, 1);
  prctl(PR_SET_PDEATHSIG, kEndAll);
  if (getppid() != parent) _exit(0);
  const pid_t reaper = getpid(), keeper = fork();
  if (keeper == 0) return reaper;
  if (keeper < 0) _exit(1);
  close_range(0, ~0U, 0);
  watch(keeper);
}

}  // namespace selvage::testbed
