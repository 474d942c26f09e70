#include "testbed/worker.h"

#include <sys/mman.h>
#include <sys/prctl.h>
#include <ucontext.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>

#include "testbed/float_control.h"

namespace selvage::testbed {
namespace {

Control* noted_in = nullptr;  // a signal handler is given nothing

// Bit 1 of the page fault's error code tells a write (Intel SDM, volume 3, "Page-Fault Exception").
[[nodiscard]] Access access_of([[maybe_unused]] const void* context) {
#if defined(__x86_64__) && defined(REG_ERR)
  const auto& registers = static_cast<const ucontext_t*>(context)->uc_mcontext.gregs;
  return (registers[REG_ERR] & 2) != 0 ? Access::kWrite : Access::kRead;
#else
  return Access::kUnknown;
#endif
}

// 0 where it is not known.
[[nodiscard]] uintptr_t stack_pointer_of([[maybe_unused]] const void* context) {
#if defined(__x86_64__) && defined(REG_RSP)
  const auto& registers = static_cast<const ucontext_t*>(context)->uc_mcontext.gregs;
  return static_cast<uintptr_t>(registers[REG_RSP]);
#elif defined(__aarch64__)
  return static_cast<const ucontext_t*>(context)->uc_mcontext.sp;
#else
  return 0;
#endif
}

// A frame may be far larger than what is left of the stack.
[[nodiscard]] bool is_unmapped(uintptr_t address) {
  const auto page_bytes = static_cast<uintptr_t>(sysconf(_SC_PAGESIZE));
  unsigned char resident = 0;
  return mincore(reinterpret_cast<void*>(address / page_bytes * page_bytes), 1, &resident) != 0 &&
         errno == ENOMEM;
}

void note_fault(int signal, siginfo_t* info, void* context) {
  End& end = noted_in->end;
  int32_t none = 0;
  if (!end.signal.compare_exchange_strong(none, signal)) _exit(1);
  end.was_sent = info->si_code <= 0;  // sigaction(2): the kernel's own are positive
  if (!end.was_sent && (signal == SIGSEGV || signal == SIGBUS)) {
    end.address = reinterpret_cast<uintptr_t>(info->si_addr);
    end.is_address_known = info->si_code != SI_KERNEL;  // else it is no address at all
    end.access = access_of(context);
    const uintptr_t stack_pointer = stack_pointer_of(context);
    end.has_left_stack = stack_pointer != 0 && is_unmapped(stack_pointer);
  }
  _exit(1);
}

// On a stack of its own, for the other one may be what ran out.
void catch_faults() {
  alignas(16) static char stack[size_t{64} << 10];
  const stack_t alternate{.ss_sp = stack, .ss_flags = 0, .ss_size = sizeof stack};
  sigaltstack(&alternate, nullptr);
  struct sigaction action {};
  action.sa_sigaction = note_fault;
  action.sa_flags = SA_SIGINFO | SA_ONSTACK;
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) {
    sigaction(signal, &action, nullptr);
  }
}

// The arena that a texture is prepared in; null where none is.
[[nodiscard]] const Arena* arena_of(const Call& call, std::span<const Arena> to_prepare_in) {
  if (call.function != Function::kPrepare) return nullptr;
  const auto address = reinterpret_cast<uintptr_t>(call.memory);
  for (const Arena& arena : to_prepare_in) {
    if (arena.range().holds(address)) return &arena;
  }
  return nullptr;
}

// A subject that forks goes on twice: only the worker answers.
void answer(Control& control, const Functions& functions, std::span<const Arena> to_prepare_in) {
  const pid_t worker = getpid();
  const Arena* arena = arena_of(control.call, to_prepare_in);
  if (arena != nullptr) arena->make_writable();
  const FloatControl before = float_control();
  try {
    Answer found = carry_out(functions, control.call);
    if (getpid() != worker) _exit(0);
    found.changed_arithmetic = float_control() != before;
    set_float_control(before);
    control.answer = found;
  } catch (...) {
    control.end.threw = true;
    _exit(1);
  }
  if (arena != nullptr) arena->make_read_only();
}

}  // namespace

void die_with(pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(0);
}

void work(Control& control, const Functions& functions, pid_t keeper,
          std::span<const Arena> to_prepare_in) {
  noted_in = &control;
  // A local variable may lie elsewhere, under a sanitizer.
  control.stack = reinterpret_cast<uintptr_t>(__builtin_frame_address(0));
  catch_faults();
  State state = State::kIdle;
  for (set_state(control, state);; state = wait_while(control, state)) {
    if (state != State::kCall) continue;
    answer(control, functions, to_prepare_in);
    die_with(keeper);  // which the subject may have undone
    state = State::kIdle;
    set_state(control, state);
  }
}

}  // namespace selvage::testbed
