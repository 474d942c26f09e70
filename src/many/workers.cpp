#include "many/workers.h"

#ifdef SELVAGE_WITH_TBB

#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <thread>

#ifdef SELVAGE_TELL_THREAD_SANITIZER
#include <sanitizer/tsan_interface.h>
#endif

namespace selvage::many {
namespace {

// What oneTBB promises and ThreadSanitizer does not see, its library not being instrumented: work
// comes after what its caller did before, and before what its caller does then.
void happened_so_far([[maybe_unused]] void* context) {
#ifdef SELVAGE_TELL_THREAD_SANITIZER
  __tsan_release(context);
#endif
}
void comes_after_that([[maybe_unused]] void* context) {
#ifdef SELVAGE_TELL_THREAD_SANITIZER
  __tsan_acquire(context);
#endif
}

}  // namespace

int32_t worker_count(int32_t threads) {
  return threads == 0 ? std::max(tbb::this_task_arena::max_concurrency(), 1) : threads;
}

// As many tasks as workers, in the arena that the caller is in: making one of its own would cost
// more than a small picture. Isolated twice: while the caller waits it takes up no other work of
// the program, and where the program cancels the task that it is in, these go on. Where oneTBB has
// no memory for its tasks it throws, but not before those that it started have ended; the caller's
// thread then does what is left.
void run_workers(int32_t workers, Work work, void* context) {
  const auto task = [&](int32_t worker) {
    comes_after_that(context);
    work(context, static_cast<size_t>(worker));
    happened_so_far(context);
  };
  happened_so_far(context);
  try {
    tbb::task_group_context group(tbb::task_group_context::isolated);
    tbb::this_task_arena::isolate(
        [&] { tbb::parallel_for(0, workers, task, tbb::simple_partitioner(), group); });
  } catch (...) {
    work(context, 0);
  }
  comes_after_that(context);
}

void wait_a_little() { std::this_thread::yield(); }

}  // namespace selvage::many

#else

namespace selvage::many {

int32_t worker_count(int32_t) { return 1; }

void run_workers(int32_t, Work work, void* context) { work(context, 0); }

void wait_a_little() {}

}  // namespace selvage::many

#endif
