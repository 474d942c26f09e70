// Runs: the list of polygons cut into stretches, which are checked and listed side by side.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "many/band_index.h"
#include "many/share_out.h"

namespace selvage::many {

inline constexpr size_t kMostRuns = 16;

// Each begins where a group of the index begins.
class Runs {
 public:
  // One run where a worker would be awake too late for its share.
  Runs(size_t polygons, int32_t workers)
      : polygons_(polygons),
        workers_(workers),
        length_(workers == 1 || polygons < kLeastShared ? polygons : length_of(polygons)) {}

  [[nodiscard]] size_t count() const { return (polygons_ + length_ - 1) / length_; }

  // Calls body(run, first, end) for each, side by side; the polygons of a run are [first, end).
  template <class Body>
  void for_each(const Body& body) const {
    share_out(count(), workers_, [&](size_t run) {
      body(run, run * length_, std::min((run + 1) * length_, polygons_));
    });
  }

 private:
  static constexpr size_t kLeastShared = 1024;
  static constexpr size_t kLeastLength = 2 * BandIndex::kPolygonsPerGroup;

  [[nodiscard]] static size_t length_of(size_t polygons) {
    const size_t least = std::max((polygons + kMostRuns - 1) / kMostRuns, kLeastLength);
    constexpr size_t kUnit = BandIndex::kPolygonsPerGroup;
    return (least + kUnit - 1) / kUnit * kUnit;
  }

  size_t polygons_;
  int32_t workers_;
  size_t length_;
};

}  // namespace selvage::many
