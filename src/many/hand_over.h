// Parts of a drawing, and workers that hand them over: one that has nothing left to draw waits for
// another one to give it half of its part.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "many/bands.h"

namespace selvage::many {

// What is left to draw in some bands: the polygons from one on.
struct Part {
  size_t first;
  BandRange bands;
};

class HandOver {
 public:
  // Up to kMostBands parts, one for each worker; they stay where they are.
  explicit HandOver(std::span<const Part> parts) : parts_(parts), undone_(parts.size()) {}

  // Something to draw for a worker, below the number of parts: at first what is its own, where
  // oneTBB gives a thread the same number again, it meets what it has in its cache. Waits while
  // others may still give; nothing once all is done. Who gets a part says done() behind it.
  [[nodiscard]] std::optional<Part> take(size_t worker);
  void done() { undone_.fetch_sub(1, std::memory_order_release); }

  // How many wait. Costs no more than to read a word that rarely changes.
  [[nodiscard]] size_t waiting() const { return waiting_.load(std::memory_order_relaxed); }
  // Gives a part to one that waits: who gives has drawn all that comes before in its bands, and
  // draws nothing there any more. Returns where the giver's bands end now: at the part, or behind
  // it, where no one waits any longer.
  [[nodiscard]] size_t give(const Part& part);

 private:
  enum class State : uint8_t { kWorks, kWaits, kHas };

  static constexpr size_t kCacheLine_bytes = 64;
  // Two workers that look at one line would wait for each other.
  struct alignas(kCacheLine_bytes) Slot {
    std::atomic<State> state{State::kWorks};
    Part part{};
  };

  [[nodiscard]] std::optional<Part> wait_for_one(size_t worker);

  std::span<const Part> parts_;
  std::array<std::atomic<bool>, kMostBands> taken_{};  // of parts_
  std::array<Slot, kMostBands> slots_{};               // of each worker
  alignas(kCacheLine_bytes) std::atomic<size_t> waiting_{0};
  // Parts that are not done, taken or not. A part counts before it is given: 0 stays 0.
  alignas(kCacheLine_bytes) std::atomic<size_t> undone_;
};

}  // namespace selvage::many
