// How much there is to draw in each band, about.
#pragma once

#include <array>
#include <cstddef>

#include "many/bands.h"

namespace selvage::many {

class BandWork {
 public:
  // In each of these bands.
  void add(BandRange bands, double cost_px) {
    for (size_t band = bands.first; band < bands.end; ++band) work_[band] += cost_px;
  }
  void add(const BandWork& other) {
    for (size_t band = 0; band < kMostBands; ++band) work_[band] += other.work_[band];
  }

  // One of so many parts of these bands, with about as much work as each other; one may be empty.
  // All of them together are all bands, in order.
  [[nodiscard]] BandRange part(BandRange bands, size_t index, size_t parts) const {
    double all = 0;
    for (size_t band = bands.first; band < bands.end; ++band) all += work_[band];
    const double share = all / static_cast<double>(parts);
    const auto boundary = [&](size_t i) {
      double before = 0;
      size_t band = bands.first;
      for (; band < bands.end && before < share * static_cast<double>(i); ++band) {
        before += work_[band];
      }
      return band;
    };
    return {boundary(index), index + 1 == parts ? bands.end : boundary(index + 1)};
  }

 private:
  std::array<double, kMostBands> work_{};
};

}  // namespace selvage::many
