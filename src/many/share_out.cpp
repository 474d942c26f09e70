#include "many/share_out.h"

#include <algorithm>
#include <array>
#include <atomic>

#include "many/workers.h"

namespace selvage::many {
namespace {

constexpr size_t kMostStretches = 64;
constexpr size_t kCacheLine_bytes = 64;

// The tasks in a stretch for each worker, as far as there are stretches. Each begins with its own,
// and when that is done helps with the one after it, and so on round: where oneTBB gives a thread
// the same number again, it meets what it has in its cache.
class Queue {
 public:
  Queue(size_t count, size_t workers, Task task, const void* context)
      : count_(count),
        stretches_(std::min(workers, kMostStretches)),
        task_(task),
        context_(context) {}

  void work(size_t worker) {
    for (size_t i = 0; i < stretches_; ++i) do_stretch((worker + i) % stretches_);
  }

 private:
  // Two workers that count in one line would wait for each other.
  struct alignas(kCacheLine_bytes) Counter {
    std::atomic<size_t> taken{0};
  };

  void do_stretch(size_t stretch) {
    const size_t first = begin_of(stretch), count = begin_of(stretch + 1) - first;
    std::atomic<size_t>& taken = counters_[stretch].taken;
    for (size_t i; (i = taken.fetch_add(1, std::memory_order_relaxed)) < count;) {
      task_(context_, first + i);
    }
  }

  [[nodiscard]] size_t begin_of(size_t stretch) const {
    return count_ / stretches_ * stretch + std::min(stretch, count_ % stretches_);
  }

  size_t count_, stretches_;
  Task task_;
  const void* context_;
  std::array<Counter, kMostStretches> counters_{};
};

}  // namespace

void share_out(size_t count, int32_t workers, Task task, const void* context) {
  const size_t useful = std::min(count, static_cast<size_t>(workers));
  if (useful > 1) {
    Queue queue(count, useful, task, context);
    run_workers(
        static_cast<int32_t>(useful),
        [](void* of, size_t worker) { static_cast<Queue*>(of)->work(worker); }, &queue);
  } else {
    for (size_t i = 0; i < count; ++i) task(context, i);
  }
}

}  // namespace selvage::many
