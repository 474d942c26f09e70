// A search for near-ties that cost more than the adversarial items: random maps, each timed beside
// the same map moved off them.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "selvage.h"

namespace selvage::reports {

// What near-ties may cost at most, times the same map without them.
inline constexpr double kMostTimesOrdinary = 6;

struct TimedMap {
  uint64_t seed = 0;  // of near_tie_map()
  std::string description;
  double hard_ns = 0, ordinary_ns = 0;  // a drawing; the ordinary one is the median of its three

  [[nodiscard]] double ratio() const { return hard_ns / ordinary_ns; }
};

struct NearTieSearch {
  uint64_t first_seed = 0;
  selvage_kernel kernel = SELVAGE_KERNEL_FASTEST;
  std::vector<double> ratios;   // of all maps, from the least to the greatest
  std::vector<TimedMap> worst;  // the kWorst greatest, the greatest first

  static constexpr size_t kWorst = 10;
  [[nodiscard]] size_t above(double ratio) const;
};

struct MapSeeds {
  uint64_t first;
  int32_t count;  // at least 1
};

// The maps of these seeds by a kernel of this machine. Each drawing is first held against that of
// the scalar kernel; throws WrongAnswer where they differ. tick is called before each map.
[[nodiscard]] NearTieSearch search_near_ties(const MapSeeds& seeds, selvage_kernel kernel,
                                             const std::function<void()>& tick);

}  // namespace selvage::reports
