// The host's side of the keeper: its beginning, its end, and waiting for it.
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <new>

#include "testbed/ending.h"
#include "testbed/host_state.h"
#include "testbed/keeper.h"
#include "testbed/patience.h"
#include "testbed/reaper.h"

namespace selvage::testbed {
namespace {

inline constexpr auto kLookAfterKeeper = std::chrono::milliseconds(20);
inline constexpr useconds_t kLookAfterEnd_us = 200;

// What is buffered would be printed by each process that inherits it.
void flush_all() {
  std::cout.flush();
  std::cerr.flush();
  std::fflush(nullptr);
}

// The status of a child that is about to end, by waitpid; of one that does not in time, too.
[[nodiscard]] int wait_for(pid_t child) {
  int status = 0;
  const auto end = std::chrono::steady_clock::now() + kLeastForkLimit;
  while (std::chrono::steady_clock::now() < end) {
    if (waitpid(child, &status, WNOHANG) != 0) return status;
    usleep(kLookAfterEnd_us);
  }
  kill(child, SIGKILL);
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

}  // namespace

Host::Keeper::Keeper()
    : control(*new (reinterpret_cast<void*>(control_memory.range().begin)) Control),
      output(memfd_create("selvage-subject-output", MFD_CLOEXEC)) {}

Host::Keeper::~Keeper() {
  end();
  if (output >= 0) close(output);
}

void Host::Keeper::start(const std::string& library) {
  fcntl(output, F_SETFL, O_APPEND);
  flush_all();
  stopped_by = wait_status = 0;
  const pid_t parent = getpid();
  sigset_t all{}, usual{};
  sigfillset(&all);
  pthread_sigmask(SIG_BLOCK, &all, &usual);  // a reaper that is not ready yet is told all the same
  process = fork();
  const bool is_child = process == 0;
  const pid_t reaper = is_child ? stay_behind_as_reaper(parent) : process;
  pthread_sigmask(SIG_SETMASK, &usual, nullptr);
  if (process < 0) throw std::bad_alloc();
  if (!is_child) return;
  for (const Arena* arena : {&arenas.texture, &arenas.other_textures, &arenas.vertices,
                             &arenas.polygons, &arenas.structures}) {
    arena->make_read_only();
  }
  for (const Arena& arena : arenas.prepared) arena.make_read_only();
  keep(control, library, output, reaper, arenas.prepared);
}

void Host::Keeper::end() {
  kill_worker();
  if (process <= 0) return;
  kill(process, kEndAll);
  kill(process, SIGCONT);  // it may have been stopped
  wait_status = wait_for(process);
  process = -1;
}

bool Host::Keeper::is_alive() {
  if (process <= 0) return false;
  siginfo_t info{};
  const int options = WEXITED | WSTOPPED | WNOHANG | WNOWAIT;
  const bool is_child = waitid(P_PID, static_cast<id_t>(process), &info, options) == 0;
  if (is_child && info.si_pid == 0) return true;
  if (info.si_code == CLD_STOPPED || info.si_code == CLD_TRAPPED) stopped_by = info.si_status;
  end();
  return false;
}

std::string Host::Keeper::describe_loss(const std::string& ended, const std::string& stopped,
                                        const std::string& which) const {
  if (stopped_by != 0) return stopped + " " + which + name_of_signal(stopped_by);
  return ended + " " + which + ", which " + describe_status(wait_status);
}

State Host::Keeper::next(State state, std::chrono::nanoseconds most) {
  const auto end = std::chrono::steady_clock::now() + most;
  for (;;) {
    const std::chrono::nanoseconds left = end - std::chrono::steady_clock::now();
    if (left.count() <= 0) return state;
    const State now =
        wait_while(control, state, std::min<std::chrono::nanoseconds>(left, kLookAfterKeeper));
    if (now != state || !is_alive()) return now;
  }
}

State Host::Keeper::next_after_call(std::chrono::nanoseconds limit,
                                    std::chrono::nanoseconds* waited) {
  State state = State::kCall;
  Patience patience(limit);
  while (state == State::kCall && is_alive()) {
    const std::chrono::nanoseconds most = patience.next(control.worker);
    if (most.count() <= 0) break;
    state = next(State::kCall, most);
  }
  *waited = patience.waited();
  return state;
}

// A subject can write there: no number must become a group of all processes.
void Host::Keeper::kill_worker() const {
  const pid_t worker = control.worker;
  if (worker <= 1) return;
  kill(-worker, SIGKILL);  // what it forked itself
  kill(worker, SIGKILL);
}

void Host::Keeper::end_worker() {
  const auto end = std::chrono::steady_clock::now() + kLeastForkLimit;
  for (State now = state(); now == State::kCall || now == State::kIdle;) {
    kill_worker();
    const std::chrono::nanoseconds left = end - std::chrono::steady_clock::now();
    now = next(now, std::min<std::chrono::nanoseconds>(left, kLookAfterKeeper));
    if (left.count() <= 0 || process <= 0) return this->end();
  }
}

bool Host::Keeper::hand_over() {
  auto idle = static_cast<uint32_t>(State::kIdle);
  const auto call = static_cast<uint32_t>(State::kCall);
  if (!control.state.compare_exchange_strong(idle, call)) return false;
  wake(control);
  return true;
}

}  // namespace selvage::testbed
