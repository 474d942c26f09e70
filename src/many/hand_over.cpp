#include "many/hand_over.h"

#include "many/workers.h"

namespace selvage::many {

std::optional<Part> HandOver::take(size_t worker) {
  const size_t count = parts_.size();
  for (size_t i = 0; i < count; ++i) {
    const size_t at = (worker + i) % count;
    if (!taken_[at].exchange(true, std::memory_order_relaxed)) return parts_[at];
  }
  return wait_for_one(worker);
}

std::optional<Part> HandOver::wait_for_one(size_t worker) {
  Slot& slot = slots_[worker];
  waiting_.fetch_add(1, std::memory_order_relaxed);
  slot.state.store(State::kWaits, std::memory_order_release);
  while (undone_.load(std::memory_order_acquire) != 0) {
    if (slot.state.load(std::memory_order_acquire) == State::kHas) return slot.part;
    wait_a_little();
  }
  return std::nullopt;
}

size_t HandOver::give(const Part& part) {
  for (size_t worker = 0; worker < parts_.size(); ++worker) {
    Slot& slot = slots_[worker];
    State waits = State::kWaits;
    if (!slot.state.compare_exchange_strong(waits, State::kWorks, std::memory_order_acquire)) {
      continue;
    }
    waiting_.fetch_sub(1, std::memory_order_relaxed);
    undone_.fetch_add(1, std::memory_order_relaxed);
    slot.part = part;
    slot.state.store(State::kHas, std::memory_order_release);
    return part.bands.first;
  }
  return part.bands.end;
}

}  // namespace selvage::many
