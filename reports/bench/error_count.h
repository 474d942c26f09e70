// Counting a drawing's errors against the exact model, on a stated sample of rows.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "reports/bench/image.h"
#include "reports/bench/workloads.h"

namespace selvage::reports {

// What the model draws on the sampled rows.
struct ModelRows {
  std::vector<int32_t> rows_px;               // ascending
  std::vector<std::vector<uint32_t>> pixels;  // a row each; kUntouched where nothing is drawn
};

struct ErrorCount {
  uint64_t judged_px = 0;   // pixels of the sampled rows
  uint64_t covered_px = 0;  // of these, covered by the model
  uint64_t wrong_texels = 0, missing_px = 0, extra_px = 0;

  [[nodiscard]] uint64_t total() const { return wrong_texels + missing_px + extra_px; }
};

// One row of each of `count` equal bands, placed within its band by the seed; all if count is not
// below the height.
[[nodiscard]] std::vector<int32_t> sample_rows(int32_t height_px, int32_t count, uint64_t seed);

// tick is called after each row.
[[nodiscard]] ModelRows model_rows(const Workload& load, std::vector<int32_t> rows_px,
                                   const std::function<void()>& tick);

// With textures false, texels are not compared; else only the bits that the subject carries are.
[[nodiscard]] ErrorCount count_errors(const ModelRows& model, const Target& drawn, bool textures,
                                      uint32_t carried_bits);

}  // namespace selvage::reports
