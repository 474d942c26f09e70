#include "many/workers.h"

#include <algorithm>
#include <atomic>

#ifdef SELVAGE_WITH_TBB
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>
#endif

namespace selvage::many {
namespace {

// Taking numbers from one counter, whoever is free goes on with the next.
struct Queue {
  std::atomic<size_t> next{0};
  const size_t count;
  const Task task;
  const void* const context;

  void work() {
    for (size_t i; (i = next.fetch_add(1, std::memory_order_relaxed)) < count;) task(context, i);
  }
};

#ifdef SELVAGE_WITH_TBB

// As many tasks as workers, in the arena that the caller is in: making one of its own would cost
// more than a small picture. Isolated: while the caller waits it takes up no other work of the
// program. Where oneTBB has no memory for its tasks it throws, but returns only when those that it
// started have ended; the caller's thread then does what is left.
void run(Queue& queue, int32_t workers) {
  try {
    tbb::this_task_arena::isolate([&] {
      tbb::parallel_for(
          0, workers, [&](int32_t) { queue.work(); }, tbb::simple_partitioner());
    });
  } catch (...) {
    queue.work();
  }
}

#else

void run(Queue& queue, int32_t) { queue.work(); }

#endif

}  // namespace

int32_t worker_count([[maybe_unused]] int32_t threads) {
#ifdef SELVAGE_WITH_TBB
  return threads == 0 ? std::max(tbb::this_task_arena::max_concurrency(), 1) : threads;
#else
  return 1;
#endif
}

void share_out(size_t count, int32_t workers, Task task, const void* context) {
  Queue queue{.count = count, .task = task, .context = context};
  if (workers > 1 && count > 1) {
    run(queue, static_cast<int32_t>(std::min<size_t>(static_cast<size_t>(workers), count)));
  } else {
    queue.work();
  }
}

}  // namespace selvage::many
