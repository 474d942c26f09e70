// What a machine that is busy with other things takes from a call's time.
#include "testbed/patience.h"

#include <gtest/gtest.h>
#include <sched.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <ctime>
#include <thread>
#include <vector>

#include "spec/generate_historic.h"
#include "spec/picture.h"
#include "spec/subject.h"
#include "support.h"

namespace selvage::testbed::test {
namespace {

using std::chrono::milliseconds;

// One processor for this process, what it forks, and some that are busy.
class OnABusyProcessor : public testing::Test {
 protected:
  void SetUp() override {
    sched_getaffinity(0, sizeof before_, &before_);
    cpu_set_t one;
    CPU_ZERO(&one);
    for (int cpu = 0; CPU_COUNT(&one) == 0; ++cpu) {
      if (CPU_ISSET(cpu, &before_)) CPU_SET(cpu, &one);
    }
    ASSERT_EQ(sched_setaffinity(0, sizeof one, &one), 0);
  }
  void TearDown() override {
    for (const pid_t child : children_) {
      kill(child, SIGKILL);
      waitpid(child, nullptr, 0);
    }
    sched_setaffinity(0, sizeof before_, &before_);
  }

  pid_t forked(void (*work)()) {
    const pid_t child = fork();
    if (child != 0) return children_.emplace_back(child);
    for (;;) work();
  }
  pid_t busy() {
    return forked([] { (void)std::clock(); });
  }

 private:
  cpu_set_t before_{};
  std::vector<pid_t> children_;
};

// Half of the processor is another's, or more.
TEST_F(OnABusyProcessor, WhatWaitsForItIsGivenMore) {
  busy();
  const pid_t worker = busy();
  Patience patience(milliseconds(400));
  EXPECT_EQ(patience.next(worker), milliseconds(50));
  std::this_thread::sleep_for(milliseconds(50));
  std::this_thread::sleep_for(patience.next(worker));
  EXPECT_GT(patience.next(worker), milliseconds(20));
}

// It sleeps until what it forked has an answer, as a mapper does that is a program behind a pipe.
TEST_F(OnABusyProcessor, WhatWaitsForWhatItForkedIsGivenMore) {
  busy();
  const pid_t worker = forked([] {
    setpgid(0, 0);
    if (fork() == 0) {
      for (;;) (void)std::clock();
    }
    for (;;) pause();
  });
  Patience patience(milliseconds(400));
  std::this_thread::sleep_for(patience.next(worker));
  std::this_thread::sleep_for(patience.next(worker));
  EXPECT_GT(patience.next(worker), milliseconds(20));
  kill(-worker, SIGKILL);
}

TEST_F(OnABusyProcessor, WhatSleepsIsNot) {
  busy();
  const pid_t worker = forked([] { pause(); });
  std::this_thread::sleep_for(milliseconds(20));
  Patience patience(milliseconds(400));
  std::this_thread::sleep_for(patience.next(worker));
  std::this_thread::sleep_for(patience.next(worker));
  EXPECT_LE(patience.next(worker), milliseconds(0));
}

// It gets next to nothing of the processor, and is given eight times its limit all the same.
TEST_F(OnABusyProcessor, WhatIsNeverDoneIsGivenUp) {
  for (int i = 0; i < 10; ++i) busy();
  const pid_t worker = forked([] {
    setpriority(PRIO_PROCESS, 0, 19);
    (void)std::clock();
  });
  Patience patience(milliseconds(200));
  for (milliseconds left{1}; left.count() > 0;) {
    left = std::chrono::duration_cast<milliseconds>(patience.next(worker));
    ASSERT_LT(patience.waited() + left, milliseconds(5000)) << "it is never given up";
    std::this_thread::sleep_for(left);
  }
  EXPECT_GT(patience.waited(), milliseconds(1200));
}

// They keep one another waiting, and nobody else does.
TEST(Patience, IsForNoThreadsThatTakeAllProcessors) {
  const pid_t worker = fork();
  if (worker == 0) {
    std::vector<std::thread> threads;
    for (unsigned i = 0; i < 8 * std::thread::hardware_concurrency(); ++i) {
      threads.emplace_back([] {
        for (;;) (void)std::clock();
      });
    }
    for (;;) pause();
  }
  std::this_thread::sleep_for(milliseconds(50));
  Patience patience(milliseconds(300));
  std::this_thread::sleep_for(patience.next(worker));
  std::this_thread::sleep_for(patience.next(worker));
  const std::chrono::nanoseconds more = patience.next(worker);
  kill(worker, SIGKILL);
  waitpid(worker, nullptr, 0);
  EXPECT_LT(more, milliseconds(150)) << "they had a processor and more, together";
}

TEST_F(OnABusyProcessor, ACallIsJudgedByWhatItDraws) {
  const auto host = host_of("works", milliseconds(600));
  const spec::Subject subject = Host::subject(host);
  for (int i = 0; i < 3; ++i) busy();
  const spec::Case c = spec::generate(1, SELVAGE_PROFILE_EXACT);
  EXPECT_EQ(spec::draw(subject, c).pixels, spec::draw(spec::built_in(), c).pixels);
}

}  // namespace
}  // namespace selvage::testbed::test
