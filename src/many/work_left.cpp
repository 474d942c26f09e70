#include "many/work_left.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "mapper/polygon.h"

namespace selvage::many {
namespace {

// Not in step with what a list repeats. The factor is 2^32 / 1.618...: Knuth, The Art of Computer
// Programming 3, section 6.4.
[[nodiscard]] size_t anywhere_below(size_t end, size_t seed) {
  const uint64_t of_16_bits = static_cast<uint32_t>(seed) * 2654435761U >> 16;
  return static_cast<size_t>(of_16_bits * end >> 16);
}

}  // namespace

BandRange bands_of(const Request& request, const Bands& bands, size_t polygon) {
  return bands.reached_by(reach_of(request.prepared[polygon].polygon, request.options.profile));
}

double cost_of_band_px(const Request& request, const Bands& bands, size_t polygon) {
  constexpr double kSetUp_px = 300;
  const selvage_rect part = mapper::part_of(request.prepared[polygon].polygon, request.visible);
  return kSetUp_px + 0.5 * bands.height() * (std::max(part.left, part.right) - part.left);
}

BandWork work_left(const Request& request, const Bands& bands, const Part& part,
                   BandRange of_first) {
  constexpr size_t kJudged = 256;  // at most, behind the first one, which may be half drawn
  BandWork work;
  const auto add = [&](size_t polygon, BandRange within, size_t times) {
    work.add(bands_of(request, bands, polygon).within(within),
             static_cast<double>(times) * cost_of_band_px(request, bands, polygon));
  };
  add(part.first, of_first, 1);
  const size_t count = request.prepared.size(), times = (count - part.first) / kJudged + 1;
  for (size_t i = part.first + 1; i < count; i += times) {
    add(std::min(i + anywhere_below(times, i), count - 1), part.bands, times);
  }
  return work;
}

}  // namespace selvage::many
