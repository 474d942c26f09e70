// Processes that a subject leaves behind in a session of their own: none outlives what it came of.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <iterator>
#include <sstream>
#include <thread>
#include <vector>

#include "spec/generate_historic.h"
#include "spec/verify.h"
#include "support.h"

namespace selvage::testbed::test {
namespace {

[[nodiscard]] bool is_there(pid_t process) { return kill(process, 0) == 0 || errno != ESRCH; }

[[nodiscard]] std::vector<pid_t> daemons(const Host& host) {
  std::istringstream text(host.printed());
  return {std::istream_iterator<pid_t>(text), {}};
}

void draw_with(const std::shared_ptr<Host>& host) {
  const spec::Subject subject = Host::subject(host);
  for (uint64_t seed = 1; seed <= 3; ++seed) {
    (void)spec::judge(*spec::find_law("COV"), subject, spec::generate(seed, SELVAGE_PROFILE_EXACT));
  }
}

// Ends those that are there after some time, so that a test that fails leaves none either.
void expect_gone_soon(const std::vector<pid_t>& processes) {
  ASSERT_FALSE(processes.empty());
  for (const pid_t process : processes) {
    for (int i = 0; is_there(process) && i < 500; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    EXPECT_FALSE(is_there(process)) << process;
    kill(process, SIGKILL);
  }
}

TEST(LeftBehind, EndsWithTheHost) {
  for (const char* name : {"daemons_loaded", "daemons_returns"}) {
    auto host = host_of(name);
    draw_with(host);
    const std::vector<pid_t> processes = daemons(*host);
    ASSERT_FALSE(processes.empty()) << name;
    for (const pid_t process : processes) EXPECT_TRUE(is_there(process)) << name;
    host.reset();
    for (const pid_t process : processes) {
      EXPECT_FALSE(is_there(process)) << name;
      kill(process, SIGKILL);
    }
  }
}

TEST(LeftBehind, EndsWithTheProcessThatDraws) {
  const auto host = host_of("daemons_crashes");
  draw_with(host);
  expect_gone_soon(daemons(*host));
}

TEST(LeftBehind, EndsWithTheKeeper) {
  const auto host = host_of("daemons_ends_keeper");
  draw_with(host);
  expect_gone_soon(daemons(*host));
}

// Even where that is killed and can tell nobody.
TEST(LeftBehind, EndsWithTheProgram) {
  int told[2];
  ASSERT_EQ(pipe(told), 0);
  const pid_t program = fork();
  if (program == 0) {
    const auto host = host_of("daemons_returns");
    draw_with(host);
    const std::vector<pid_t> processes = daemons(*host);
    if (!processes.empty() && write(told[1], processes.data(), sizeof(pid_t)) > 0) pause();
    _exit(1);
  }
  close(told[1]);
  pid_t process = 0;
  ASSERT_EQ(read(told[0], &process, sizeof process), static_cast<ssize_t>(sizeof process));
  EXPECT_TRUE(is_there(process));
  kill(program, SIGKILL);
  waitpid(program, nullptr, 0);
  expect_gone_soon({process});
  close(told[0]);
}

}  // namespace
}  // namespace selvage::testbed::test
