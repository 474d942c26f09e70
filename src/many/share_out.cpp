#include "many/share_out.h"

#include <algorithm>
#include <atomic>

#include "many/workers.h"

namespace selvage::many {
namespace {

// Taking numbers from one counter, whoever is free goes on with the next.
struct Queue {
  const size_t count;
  const Task task;
  const void* const context;
  std::atomic<size_t> next{0};

  void work() {
    for (size_t i; (i = next.fetch_add(1, std::memory_order_relaxed)) < count;) task(context, i);
  }
};

}  // namespace

void share_out(size_t count, int32_t workers, Task task, const void* context) {
  Queue queue{.count = count, .task = task, .context = context};
  const auto useful = static_cast<int32_t>(std::min(count, static_cast<size_t>(workers)));
  if (useful > 1) {
    run_workers(
        useful, [](void* of) { static_cast<Queue*>(of)->work(); }, &queue);
  } else {
    queue.work();
  }
}

}  // namespace selvage::many
