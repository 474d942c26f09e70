#include "reports/bench/error_count.h"

#include <algorithm>
#include <cstdlib>

namespace selvage::reports {

namespace {

// How far u is from the texel [s, s + 1).
double distance_from(double u, int32_t s) {
  return std::max({static_cast<double>(s) - u, u - static_cast<double>(s + 1), 0.0});
}

// What the pixel tells in the carried bits, completed to the place nearest to the expected one.
uint32_t completed(uint32_t drawn, uint32_t expected, uint32_t carried_bits) {
  const auto rows = static_cast<int32_t>(carried_bits >> 16);  // lower bits: t modulo rows + 1
  int32_t distance = (row_of(drawn) - row_of(expected)) & rows;
  if (distance > rows / 2) distance -= rows + 1;
  return place_of(column_of(drawn), row_of(expected) + distance);
}

void count_texel(ErrorCount& count, const ModelPixel& expected, uint32_t drawn) {
  if (drawn == expected.colour) return;
  const int32_t s = column_of(drawn), t = row_of(drawn);
  const int32_t distance =
      std::max(std::abs(s - column_of(expected.colour)), std::abs(t - row_of(expected.colour)));
  ++count.wrong_texels;
  count.sum_texel += static_cast<uint64_t>(distance);
  count.largest_texel = std::max(count.largest_texel, distance);
  count.largest_coordinate_texel = std::max(
      {count.largest_coordinate_texel, distance_from(expected.u, s), distance_from(expected.v, t)});
}

void count_colour(ErrorCount& count, uint32_t expected, uint32_t drawn, uint32_t carried_bits) {
  int32_t worst_level = 0;
  for (const uint32_t channel : {0u, 8u, 16u, 24u}) {
    const auto level = [&](uint32_t colour) {
      return static_cast<int32_t>((colour & carried_bits) >> channel & 0xFF);
    };
    worst_level = std::max(worst_level, std::abs(level(drawn) - level(expected)));
  }
  count.unequal_colours += worst_level > 0;
  count.wrong_colours += worst_level > kRounding_level;
  count.sum_level += static_cast<uint64_t>(worst_level);
  count.largest_level = std::max(count.largest_level, worst_level);
}

uint64_t count_drawn_in_padding(const Target& target) {
  ptrdiff_t count = 0;
  for (int32_t y = 0; y < target.height_px; ++y) {
    const uint32_t* row = target.row(y);
    count += std::count_if(row + target.width_px, row + target.pitch_px,
                           [](uint32_t pixel) { return pixel != kUntouched; });
  }
  return static_cast<uint64_t>(count);
}

}  // namespace

ErrorCount count_errors(const ModelRows& model, const Target& drawn, bool textures,
                        selvage_filter filter, uint32_t carried_bits) {
  ErrorCount count;
  count.extra_px = count.extra_in_padding_px = count_drawn_in_padding(drawn);
  for (size_t r = 0; r < model.rows_px.size(); ++r) {
    const uint32_t* row = drawn.row(model.rows_px[r]);
    for (size_t x = 0; x < model.pixels[r].size(); ++x) {
      const ModelPixel& expected = model.pixels[r][x];
      const bool covered = expected.colour != kUntouched, seen = row[x] != kUntouched;
      ++count.judged_px;
      count.covered_px += covered;
      count.missing_px += covered && !seen;
      count.extra_px += seen && !covered;
      if (!textures || !covered || !seen) continue;
      ++count.compared_px;
      if (filter == SELVAGE_FILTER_NEAREST)
        count_texel(count, expected, completed(row[x], expected.colour, carried_bits));
      else
        count_colour(count, expected.colour, row[x], carried_bits);
    }
  }
  return count;
}

}  // namespace selvage::reports
