#include "testbed/host.h"

#include <unistd.h>

#include <algorithm>
#include <new>

#include "testbed/ending.h"
#include "testbed/host_state.h"
#include "testbed/printable.h"

namespace selvage::testbed {
namespace {

constexpr const char* kHolder = "the process that holds it";

[[nodiscard]] LibraryError cannot_use(const std::string& name, const std::string& why) {
  return LibraryError("cannot use '" + printable(name) + "' as a subject: " + why);
}

// It may have told itself what is amiss.
[[nodiscard]] std::string quoted(std::string printed) {
  constexpr size_t kMostBytes = 300;
  while (!printed.empty() && printed.back() == '\n') printed.pop_back();
  std::ranges::replace(printed, '\n', ' ');
  return printed.empty() ? "" : "; it printed: " + printable(printed, kMostBytes);
}

// What a call did, in words that follow "it".
[[nodiscard]] spec::SubjectFailure failure(const Call& call, const std::string& happened,
                                           bool hung = false) {
  const bool is_draw = call.function == Function::kDraw;
  return {happened, hung, is_draw ? "" : name_of(call.function)};
}

// Throws where the call ended as calls do, and yet did not what they do.
[[nodiscard]] const Answer& checked(const Call& call, const Answer& answer) {
  if (answer.changed_arithmetic) {
    throw failure(call, "left its caller's floating-point numbers to be rounded otherwise");
  }
  if (answer.status == SELVAGE_STATUS_BEYOND_CLAIMS) {
    throw spec::NotClaimed{"what it says itself is beyond it"};
  }
  return answer;
}

}  // namespace

Host::Host(const std::filesystem::path& library, std::chrono::nanoseconds call_limit)
    : keeper_(std::make_unique<Keeper>()),
      blocks_(std::make_unique<Blocks>()),
      name_(library.string()),
      call_limit_(call_limit) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(library, error);
  if (!std::filesystem::exists(status)) {
    const bool is_missing = status.type() == std::filesystem::file_type::not_found;
    throw cannot_use(name_, is_missing ? "there is no such file" : error.message());
  }
  if (!std::filesystem::is_regular_file(status)) {
    throw cannot_use(name_, (std::filesystem::is_directory(status) ? "it is a directory"
                                                                   : "it is no regular file") +
                                std::string("; the name of a shared library is right"));
  }
  if (const std::string fault = load(); !fault.empty())
    throw cannot_use(name_, fault + quoted(printed()));
}

// Loads the library in a process of its own; tells why it cannot be used, empty if it can.
std::string Host::load() {
  Control& control = *new (&keeper_->control) Control;
  keeper_->start(std::filesystem::absolute(name_).string());
  const State state = keeper_->next(State::kLoading, call_limit_);
  if (state == State::kNoWorker) return {};
  const bool has_ended = !keeper_->is_alive();
  keeper_->end();
  if (state == State::kRefused) return control.refusal.data();
  const bool is_described = static_cast<Step>(control.step.load()) == Step::kDescribe;
  const std::string what = is_described ? "its selvage_subject()" : "loading it";
  if (has_ended)
    return keeper_->describe_loss(what + " ends", what + " stops", "the process that does so");
  return what + " takes longer than a call may, " + in_seconds(call_limit_);
}

Host::~Host() = default;

void Host::begin_case() { at_end_ = blocks_->at_end = true; }

void Host::start_anew() {
  keeper_->end_worker();
  if (keeper_->is_alive()) set_state(keeper_->control, State::kNoWorker);
}

const Arenas& Host::arenas() const { return keeper_->arenas; }
const Control& Host::control() const { return keeper_->control; }

// A worker that waits for a call. Throws spec::SubjectFailure.
void Host::have_worker(const Call& call, const Placement& placement) {
  Control& control = keeper_->control;
  if (!keeper_->is_alive()) {
    if (const std::string fault = load(); !fault.empty()) {
      throw failure(call, "cannot be loaded again: " + fault, /*hung=*/true);
    }
  }
  if (keeper_->state() == State::kIdle) return;
  if (keeper_->state() == State::kGone) {
    set_state(control, State::kNoWorker);
    throw failure(call, describe_end(control, placement) + ", after a call had returned");
  }
  control.end.signal = 0;
  control.end.threw = control.end.was_sent = control.end.is_address_known = false;
  control.end.fork_error = 0;
  control.end.memory_bytes = 0;
  control.end.access = Access::kUnknown;
  set_state(control, State::kFork);
  const auto limit = std::max<std::chrono::nanoseconds>(call_limit_, kLeastForkLimit);
  const State state = keeper_->next(State::kFork, limit);
  if (state == State::kIdle) return;
  if (state == State::kGone) {
    set_state(control, State::kNoWorker);
    throw failure(call, describe_end(control, placement));
  }
  const bool was_lost = !keeper_->is_alive();
  keeper_->end();
  throw failure(call,
                was_lost ? keeper_->describe_loss("ended", "stopped", kHolder)
                         : "left no process to draw in within " + in_seconds(limit),
                !was_lost);
}

Answer Host::call(const Call& call) {
  Control& control = keeper_->control;
  const Placement placement(keeper_->arenas, call, blocks_->placed, at_end_);
  have_worker(call, placement);
  if (call.function == Function::kDraw || call.function == Function::kDrawMany) at_end_ = !at_end_;
  control.call = placement.copy_in();
  if (!keeper_->hand_over()) {
    have_worker(call, placement);  // which tells how it has ended
    if (!keeper_->hand_over()) throw failure(call, "ended while it waited for a call");
  }
  std::chrono::nanoseconds waited{0};
  const State state = keeper_->next_after_call(call_limit_, &waited);
  const bool is_held = keeper_->is_alive();
  const bool hung = is_held && state == State::kCall;
  if (hung) keeper_->end_worker();
  placement.copy_out();
  if (!is_held) throw failure(call, keeper_->describe_loss("ended", "stopped", kHolder));
  if (hung) {
    if (keeper_->is_alive()) set_state(control, State::kNoWorker);
    throw failure(call, describe_hang(call_limit_, waited, control.end), hung);
  }
  if (state == State::kGone) {
    set_state(control, State::kNoWorker);
    throw failure(call, describe_end(control, placement));
  }
  if (state != State::kIdle) {
    keeper_->end();
    throw failure(call, "wrote over what the testbed keeps beside it");
  }
  return checked(call, control.answer);
}

bool Host::tells_claims() const { return control().has_claims; }

std::string Host::printed() const {
  std::string text(static_cast<size_t>(lseek(keeper_->output, 0, SEEK_END)), '\0');
  const ssize_t got = pread(keeper_->output, text.data(), text.size(), 0);
  text.resize(got > 0 ? static_cast<size_t>(got) : 0);
  return text;
}

}  // namespace selvage::testbed
