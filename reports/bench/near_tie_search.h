// A search for near-ties that cost more than the adversarial items: random maps, each timed beside
// the same map moved off them.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

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
  std::vector<double> ratios;   // of all maps, from the least to the greatest
  std::vector<TimedMap> worst;  // the kWorst greatest, the greatest first

  static constexpr size_t kWorst = 10;
  [[nodiscard]] size_t above(double ratio) const;
};

// The maps of the seeds from the first one on, at least one. Each drawing is first held against
// that of the scalar kernel; throws WrongAnswer where they differ. tick is called with the number
// of maps that are done.
[[nodiscard]] NearTieSearch search_near_ties(uint64_t first_seed, int32_t maps,
                                             const std::function<void(int32_t)>& tick);

}  // namespace selvage::reports
