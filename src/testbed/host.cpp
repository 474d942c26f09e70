#include "testbed/host.h"

#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fcntl.h>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <new>

#include "testbed/ending.h"
#include "testbed/host_state.h"
#include "testbed/keeper.h"
#include "testbed/printable.h"

namespace selvage::testbed {
namespace {

inline constexpr auto kLookAfterKeeper = std::chrono::milliseconds(100);
inline constexpr auto kForkLimit = std::chrono::seconds(60);  // a machine may be very busy

[[nodiscard]] LibraryError cannot_use(const std::string& name, const std::string& why) {
  return LibraryError("cannot use '" + printable(name) + "' as a subject: " + why);
}

// What is buffered would be printed by each process that inherits it.
void flush_all() {
  std::cout.flush();
  std::cerr.flush();
  std::fflush(nullptr);
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
  const pid_t parent = getpid();
  process = fork();
  if (process < 0) throw std::bad_alloc();
  if (process > 0) {
    setpgid(process, process);  // here, too: either of the two may be first
    return;
  }
  for (const Arena* arena : {&arenas.texture, &arenas.other_textures, &arenas.vertices,
                             &arenas.polygons, &arenas.structures}) {
    arena->make_read_only();
  }
  for (const Arena& arena : arenas.prepared) arena.make_read_only();
  keep(control, library, output, parent, arenas.prepared);
}

// Its group goes first: until the keeper is waited for, the number of the group is no other's.
void Host::Keeper::end() {
  end_worker();
  if (process <= 0) return;
  kill(-process, SIGKILL);
  kill(process, SIGKILL);
  while (waitpid(process, nullptr, 0) < 0 && errno == EINTR) {
  }
  process = -1;
}

bool Host::Keeper::is_alive() {
  if (process <= 0) return false;
  siginfo_t info{};
  waitid(P_PID, static_cast<id_t>(process), &info, WEXITED | WNOHANG | WNOWAIT);
  if (info.si_pid != 0) end();
  return process > 0;
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

void Host::Keeper::end_worker() const {
  const pid_t worker = control.worker;
  if (worker <= 0) return;
  kill(-worker, SIGKILL);  // what it forked itself
  kill(worker, SIGKILL);
}

void Host::Keeper::have_worker() {
  if (state() == State::kIdle) return;
  control.end.signal = 0;
  control.end.threw = control.end.was_sent = control.end.is_address_known = false;
  control.end.access = Access::kUnknown;
  set_state(control, State::kFork);
  if (next(State::kFork, kForkLimit) != State::kIdle) {
    throw LibraryError("the process that holds the subject has ended");
  }
}

Host::Host(const std::filesystem::path& library, std::chrono::nanoseconds call_limit)
    : keeper_(std::make_unique<Keeper>()),
      blocks_(std::make_unique<Blocks>()),
      name_(library.string()),
      call_limit_(call_limit) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(library, error)) {
    throw cannot_use(name_, "there is no such file");
  }
  load();
}

void Host::load() {
  Control& control = *new (&keeper_->control) Control;
  keeper_->start(std::filesystem::absolute(name_).string());
  const State state = keeper_->next(State::kLoading, call_limit_);
  if (state == State::kNoWorker) return;
  if (state == State::kRefused) throw cannot_use(name_, control.refusal.data());
  const bool is_described = static_cast<Step>(control.step.load()) == Step::kDescribe;
  const std::string what = is_described ? "its selvage_subject()" : "loading it";
  const bool has_ended = !keeper_->is_alive();
  throw cannot_use(name_, what + (has_ended ? " ends the process that does so"
                                            : " takes longer than a call may"));
}

Host::~Host() = default;

void Host::begin_case() { at_end_ = blocks_->at_end = true; }

const Arenas& Host::arenas() const { return keeper_->arenas; }
const Control& Host::control() const { return keeper_->control; }

Answer Host::call(const Call& call) {
  Control& control = keeper_->control;
  keeper_->have_worker();
  const Placement placement(keeper_->arenas, call, blocks_->placed, at_end_);
  if (call.function == Function::kDraw || call.function == Function::kDrawMany) at_end_ = !at_end_;
  control.call = placement.copy_in();
  set_state(control, State::kCall);
  State state = keeper_->next(State::kCall, call_limit_);
  const bool is_held = keeper_->is_alive();
  const bool hung = is_held && state == State::kCall;
  if (hung) {
    keeper_->end_worker();
    state = keeper_->next(State::kCall, kForkLimit);
    if (state == State::kIdle) state = keeper_->next(State::kIdle, kForkLimit);  // a tie
  }
  placement.copy_out();
  const auto failure = [&](const std::string& happened) {
    const bool is_draw = call.function == Function::kDraw;
    return spec::SubjectFailure{happened, hung, is_draw ? "" : name_of(call.function)};
  };
  if (!is_held) {
    load();
    throw failure("ended the process that holds it");
  }
  if (hung) throw failure(describe_hang(call_limit_));
  if (state == State::kGone) throw failure(describe_end(control, placement));
  if (control.answer.status == SELVAGE_STATUS_BEYOND_CLAIMS)
    throw spec::NotClaimed{"what it says itself is beyond it"};
  return control.answer;
}

std::string Host::printed() const {
  std::string text(static_cast<size_t>(lseek(keeper_->output, 0, SEEK_END)), '\0');
  const ssize_t got = pread(keeper_->output, text.data(), text.size(), 0);
  text.resize(got > 0 ? static_cast<size_t>(got) : 0);
  return text;
}

}  // namespace selvage::testbed
