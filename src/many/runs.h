// Runs: the list of polygons cut into stretches, which are checked and listed side by side.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "many/share_out.h"

namespace selvage::many {

inline constexpr size_t kMostRuns = 16;

class Runs {
 public:
  // One run where a worker would be awake too late for its share.
  Runs(size_t polygons, int32_t workers)
      : polygons_(polygons),
        workers_(workers),
        count_(workers == 1 ? 1 : std::clamp<size_t>(polygons / kLeastLength, 1, kMostRuns)) {}

  [[nodiscard]] size_t count() const { return count_; }

  // Calls body(run, first, end) for each, side by side; the polygons of a run are [first, end).
  template <class Body>
  void for_each(const Body& body) const {
    share_out(count_, workers_, [&](size_t run) { body(run, boundary(run), boundary(run + 1)); });
  }

 private:
  static constexpr size_t kLeastLength = 512;

  [[nodiscard]] size_t boundary(size_t run) const {
    return polygons_ / count_ * run + std::min(run, polygons_ % count_);
  }

  size_t polygons_;
  int32_t workers_;
  size_t count_;
};

}  // namespace selvage::many
