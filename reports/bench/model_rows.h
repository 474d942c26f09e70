// What the exact model draws on a stated sample of a workload's rows.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "reports/bench/image.h"
#include "reports/bench/workloads.h"

namespace selvage::reports {

struct ModelPixel {
  uint32_t colour = kUntouched;  // kUntouched where nothing is drawn
  double u = 0, v = 0;           // the exact coordinates within the texture, texels, to 53 bits
};

struct ModelRows {
  std::vector<int32_t> rows_px;                 // ascending
  std::vector<std::vector<ModelPixel>> pixels;  // a row each
};

// One row of each of `count` equal bands, placed within its band by the seed; all if count is not
// below the height.
[[nodiscard]] std::vector<int32_t> sample_rows(int32_t height_px, int32_t count, uint64_t seed);

// tick is called after each row.
[[nodiscard]] ModelRows model_rows(const Workload& load, std::vector<int32_t> rows_px,
                                   const std::function<void()>& tick);

}  // namespace selvage::reports
