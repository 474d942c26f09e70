// Order statistics of repeated measurements.
#pragma once

#include <vector>

namespace selvage::reports {

struct Spread {
  double median = 0, lower_quartile = 0, upper_quartile = 0;
};

// Quantiles interpolated between order statistics; values must not be empty.
[[nodiscard]] Spread spread_of(std::vector<double> values);

}  // namespace selvage::reports
