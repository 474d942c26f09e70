#include "testbed/keeper.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <span>

#include "testbed/printable.h"
#include "testbed/reaper.h"
#include "testbed/worker.h"

namespace selvage::testbed {
namespace {

inline constexpr rlim_t kMostOutputBytes = rlim_t{1} << 20;
// Beyond what is in use at the start. Threads reserve much and use little of it.
inline constexpr rlim_t kMostReservedBytes = rlim_t{4} << 30;

inline constexpr size_t kMostCharacterBytes = 4;

// Of a text that may have no end no more is looked at than decides about the last character.
void copy_text(std::span<char> to, const char* from) {
  const size_t seen = from == nullptr ? 0 : strnlen(from, to.size() + kMostCharacterBytes);
  const std::string text = printable({from == nullptr ? "" : from, seen}, to.size() - 1);
  std::ranges::copy(text, to.begin());
  to[text.size()] = '\0';
}

// Nothing of the program's files is within reach, and what is printed goes to `output` at once: a
// subject mostly ends by a signal, which flushes nothing.
void seal_off(int output) {
  const int nothing = open("/dev/null", O_RDONLY);
  dup2(nothing, STDIN_FILENO);
  dup2(output, STDOUT_FILENO);
  dup2(output, STDERR_FILENO);
  std::setvbuf(stdout, nullptr, _IONBF, 0);
  close_range(STDERR_FILENO + 1, ~0U, 0);
}

void limit(__rlimit_resource resource, rlim_t most) {
  rlimit both{};
  getrlimit(resource, &both);
  both.rlim_cur = std::min(most, both.rlim_max);
  both.rlim_max = both.rlim_cur;
  setrlimit(resource, &both);
}

struct BytesInUse {
  rlim_t reserved = 0, data = 0;
};

[[nodiscard]] BytesInUse bytes_in_use() {
  unsigned long size = 0, data = 0;  // pages: proc(5)
  if (FILE* file = std::fopen("/proc/self/statm", "r")) {
    if (std::fscanf(file, "%lu %*u %*u %*u %*u %lu", &size, &data) != 2) size = data = 0;
    std::fclose(file);
  }
  const auto page_bytes = static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
  return {size * page_bytes, data * page_bytes};
}

void limit_resources() {
  std::signal(SIGXFSZ, SIG_IGN);  // a write beyond the limit fails and nothing more
  limit(RLIMIT_FSIZE, kMostOutputBytes);
  const BytesInUse start = bytes_in_use();
  limit(RLIMIT_AS, start.reserved + kMostReservedBytes);
  limit(RLIMIT_DATA, start.data + kMostMemoryBytes);
}

// Whoever has asked to hear of them before: a sanitizer would end the process in a way of its own.
void let_faults_end_it() {
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) std::signal(signal, SIG_DFL);
}

[[noreturn]] void refuse(Control& control, const std::string& why) {
  copy_text(control.refusal, why.c_str());
  set_state(control, State::kRefused);
  _exit(0);
}

void describe(Control& control, const selvage_claims* claims) {
  if (claims == nullptr) refuse(control, "its selvage_subject() returns NULL");
  // Built with an older header: what a later one has behind is not claimed.
  constexpr size_t kLeastBytes = offsetof(selvage_claims, accuracy);
  if (claims->bytes < kLeastBytes) {
    refuse(control, "its selvage_subject() says that its claims have " +
                        std::to_string(claims->bytes) +
                        " bytes; the field must be set to "
                        "sizeof(selvage_claims), " +
                        std::to_string(sizeof(selvage_claims)));
  }
  // The oldest of them ended with padding, of which nothing is known; no field is taken in part.
  const bool is_oldest = claims->bytes < offsetof(selvage_claims, coverage_accuracy);
  const size_t known_bytes = std::min(claims->bytes, sizeof(selvage_claims));
  std::memcpy(&control.claims, claims,
              is_oldest ? kLeastBytes : known_bytes - known_bytes % sizeof(int32_t));
  copy_text(control.name, claims->name);
  copy_text(control.version, claims->version);
  control.claims.name = control.claims.version = nullptr;
  control.has_claims = true;
}

// A library that forks while it is loaded goes on twice, and a call that jumps back to where it was
// loaded does so in the worker: only the keeper answers. It does not rely on the stack.
void end_copy(const Control& control) {
  if (getpid() != control.keeper) _exit(0);
}

[[nodiscard]] Functions load(Control& control, const std::string& path) {
  void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  end_copy(control);
  if (library == nullptr) {
    const char* why = dlerror();
    refuse(control, why != nullptr ? why : "it cannot be loaded");
  }
  const Functions functions = find_functions(library);
  end_copy(control);  // the address of a function may be found by one of the library's
  if (const std::string fault = fault_of(functions); !fault.empty()) refuse(control, fault);
  control.exported = exported(functions);
  using Describe = const selvage_claims* (*)();
  if (const auto about = reinterpret_cast<Describe>(dlsym(library, "selvage_subject"))) {
    control.step = static_cast<uint32_t>(Step::kDescribe);
    const selvage_claims* claims = about();
    end_copy(control);
    describe(control, claims);
  }
  return functions;
}

// What the library made of this process's signals.
struct Signals {
  sigset_t blocked{};
  struct sigaction on_child {};
};

// No signal but those that cannot be kept off ends the keeper, and it learns how each worker did.
[[nodiscard]] Signals keep_signals_off() {
  Signals before;
  sigset_t all{};
  sigfillset(&all);
  sigprocmask(SIG_BLOCK, &all, &before.blocked);
  struct sigaction usual {};
  usual.sa_handler = SIG_DFL;
  sigaction(SIGCHLD, &usual, &before.on_child);
  return before;
}

void put_back(const Signals& signals) {
  sigaction(SIGCHLD, &signals.on_child, nullptr);
  sigprocmask(SIG_SETMASK, &signals.blocked, nullptr);
}

void fork_worker(Control& control, const Functions& functions, const Signals& signals, pid_t reaper,
                 std::span<const Arena> to_prepare_in) {
  const pid_t keeper = getpid();
  const pid_t worker = fork();
  if (worker == 0) {
    die_with(keeper);
    setpgid(0, 0);
    control.worker = getpid();  // before the host can be told of it, and want it to end
    put_back(signals);
    work(control, functions, keeper, to_prepare_in);
  }
  control.end.fork_error = worker < 0 ? errno : 0;
  int status = 0;
  rusage use{};
  while (worker > 0 && wait4(worker, &status, 0, &use) < 0 && errno == EINTR) {
  }
  if (worker > 0) kill(-worker, SIGKILL);  // what it forked itself
  kill(reaper, kEndOrphans);               // and what of that has left its group
  control.end.wait_status = status;
  control.end.memory_bytes = static_cast<uint64_t>(use.ru_maxrss) * 1024;  // getrusage(2)
  control.worker = 0;
  set_state(control, State::kGone);
}

}  // namespace

void keep(Control& control, const std::string& library, int output, pid_t reaper,
          std::span<const Arena> to_prepare_in) {
  control.keeper = getpid();
  die_with(reaper);
  setpgid(0, 0);
  seal_off(output);
  limit_resources();
  let_faults_end_it();
  const Functions functions = load(control, library);
  die_with(reaper);  // which the library may have undone
  const Signals signals = keep_signals_off();
  control.step = static_cast<uint32_t>(Step::kDone);
  set_state(control, State::kNoWorker);
  for (State state = State::kNoWorker;;) {
    if (state == State::kFork) fork_worker(control, functions, signals, reaper, to_prepare_in);
    state = static_cast<State>(control.state.load());  // which may be kFork again
    if (state != State::kFork) state = wait_while(control, state);
  }
}

}  // namespace selvage::testbed
