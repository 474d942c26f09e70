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
    steps_px_[bands.first] += cost_px;
    steps_px_[bands.end] -= cost_px;
  }

  // Calls visit(band, cost_px) for each band below `end`.
  template <class Visit>
  void for_each(size_t end, const Visit& visit) const {
    double of_band_px = 0;
    for (size_t band = 0; band < end; ++band) {
      of_band_px += steps_px_[band];
      // Where many costs were rounded, of_band_px may be a little below 0.
      visit(band, std::max(of_band_px, 0.0));
    }
  }

 private:
  // By how much a band has more than the one before.
  std::array<double, kMostBands + 1> steps_px_{};
};

// Some bands, cut into parts with about as much work as each other.
class BandShares {
 public:
  BandShares(const BandWork& work, BandRange bands) : bands_(bands) {
    work.for_each(bands.end, [&](size_t band, double cost_px) {
      before_px_[band + 1] = before_px_[band] + (band < bands.first ? 0 : cost_px);
    });
  }

  [[nodiscard]] double all_px() const { return before_px_[bands_.end]; }
  // One of `count` parts, which may be empty. All of them together are all bands, in order.
  [[nodiscard]] BandRange part(size_t at, size_t count) const {
    return {begin_of(at, count), at + 1 == count ? bands_.end : begin_of(at + 1, count)};
  }

 private:
  [[nodiscard]] size_t begin_of(size_t part, size_t count) const {
    const double part_px = all_px() / static_cast<double>(count);
    const auto first = before_px_.begin() + static_cast<ptrdiff_t>(bands_.first),
               end = before_px_.begin() + static_cast<ptrdiff_t>(bands_.end);
    const auto at = std::lower_bound(first, end, part_px * static_cast<double>(part));
    return static_cast<size_t>(at - before_px_.begin());
  }

  BandRange bands_;
  std::array<double, kMostBands + 1> before_px_{};  // the work of these bands up to each
};

}  // namespace selvage::many
