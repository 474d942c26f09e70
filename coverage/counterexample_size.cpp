#include "coverage/counterexample_size.h"

#include <algorithm>
#include <array>

namespace selvage::coverage {
namespace {

constexpr const char* kOfHighTargets = "it takes a band that begins at row 256";

constexpr std::array kLarge = {
    LargeCounterexample{"rgb565_row_of_eight_bits",
                        {.texture_texel = 258},
                        "it takes 257 rows to have one whose number has more than 8 bits"},
    LargeCounterexample{"abrash57_untransformed_not_copied",
                        {.target_px = 330},
                        "the last of n pixels lies 1/(2 n) texel from the next texel, and n steps, "
                        "each up to 1/65536 texel short, cross that only where n^2 > 32768"},
    LargeCounterexample{"abrash56_rows_in_a_byte", {.target_px = 260}, kOfHighTargets},
    LargeCounterexample{"abrash57_rows_in_a_byte", {.target_px = 260}, kOfHighTargets},
    LargeCounterexample{"dkit_rows_in_a_byte", {.target_px = 260}, kOfHighTargets},
};

}  // namespace

std::span<const LargeCounterexample> large_counterexamples() { return kLarge; }

CounterexampleSize largest_counterexample(std::string_view mapper) {
  const auto large = std::ranges::find(kLarge, mapper, &LargeCounterexample::mapper);
  return large != kLarge.end() ? large->size : CounterexampleSize{};
}

CounterexampleSize size_of(const spec::Case& c) {
  return {c.vertices.size(), c.target_width_px + c.target_height_px,
          c.texture_width_texel + c.texture_height_texel};
}

}  // namespace selvage::coverage
