// How much there is to draw in each band, about.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "many/bands.h"

namespace selvage::many {

class BandWork {
 public:
  // In each of these bands, if there are any; not negative.
  void add(BandRange bands, double cost_px) {
    steps_[bands.first] += cost_px;
    steps_[bands.end] -= cost_px;
  }
  void add(const BandWork& other) {
    for (size_t band = 0; band < steps_.size(); ++band) steps_[band] += other.steps_[band];
  }

  // One of so many parts of these bands, with about as much work as each other; one may be empty.
  // All of them together are all bands, in order.
  [[nodiscard]] BandRange part(BandRange bands, size_t index, size_t parts) const {
    std::array<double, kMostBands + 1> before{};  // the work of these bands up to each
    double of_band = 0;
    for (size_t band = 0; band < bands.end; ++band) {
      of_band += steps_[band];
      // Where many costs were rounded, of_band may be a little below 0.
      before[band + 1] = before[band] + (band < bands.first ? 0 : std::max(of_band, 0.0));
    }
    const double share = before[bands.end] / static_cast<double>(parts);
    const auto boundary = [&](size_t i) {
      const auto first = before.begin() + static_cast<ptrdiff_t>(bands.first),
                 end = before.begin() + static_cast<ptrdiff_t>(bands.end);
      const double wanted = share * static_cast<double>(i);
      return static_cast<size_t>(std::lower_bound(first, end, wanted) - before.begin());
    };
    return {boundary(index), index + 1 == parts ? bands.end : boundary(index + 1)};
  }

 private:
  std::array<double, kMostBands + 1> steps_{};  // by how much a band has more than the one before
};

}  // namespace selvage::many
