// Counting a drawing's errors against the exact model.
#pragma once

#include <cstdint>
#include <optional>

#include "reports/bench/image.h"
#include "reports/bench/model_rows.h"

namespace selvage::reports {

struct ErrorCount {
  uint64_t judged_px = 0;   // pixels of the sampled rows
  uint64_t covered_px = 0;  // of these, covered by the model
  uint64_t missing_px = 0, extra_px = 0;
  uint64_t extra_in_padding_px = 0;   // of the extra ones; looked for behind every row
  std::optional<uint64_t> double_px;  // drawn by two polygons; nothing where there is only one

  uint64_t compared_px = 0;  // that both draw

  // Nearest. A texel's distance is the larger of those along u and along v.
  uint64_t wrong_texels = 0, sum_texel = 0;
  int32_t largest_texel = 0;
  // The least error of u or v that explains the worst texel: the distance of the exact (u, v) from
  // the texel that was drawn.
  double largest_coordinate_texel = 0;

  // Filtered. A colour's distance is that of its worst channel, of those that are carried, in
  // levels of 255. Mappers round their weights as they like, so wrong is what is off by more.
  uint64_t unequal_colours = 0, wrong_colours = 0, sum_level = 0;
  int32_t largest_level = 0;

  // All that is not as the model has it.
  [[nodiscard]] uint64_t total() const {
    return wrong_texels + unequal_colours + missing_px + extra_px + double_px.value_or(0);
  }
  [[nodiscard]] double mean_texel() const { return mean(sum_texel); }
  [[nodiscard]] double mean_level() const { return mean(sum_level); }

 private:
  [[nodiscard]] double mean(uint64_t sum) const {
    return compared_px == 0 ? 0 : static_cast<double>(sum) / static_cast<double>(compared_px);
  }
};

// A filtered colour may be off by this much and count as right.
inline constexpr int32_t kRounding_level = 1;

// With textures false, texels are not compared; else in the bits that the subject carries. Where
// these leave out upper bits of t, a texel is the nearest to the exact one of those that the pixel
// may mean. Leaves double_px alone.
[[nodiscard]] ErrorCount count_errors(const ModelRows& model, const Target& drawn, bool textures,
                                      selvage_filter filter, uint32_t carried_bits = 0xFFFFFFFF);

}  // namespace selvage::reports
