#include "spec/filter_texture.h"

#include "spec/random.h"

namespace selvage::spec {

TexelAt filter_texture(const Case& c) {
  const uint64_t choice = c.choice;
  return [choice](Texel texel) {
    const auto place = static_cast<uint64_t>(texel.s) << 17 | static_cast<uint64_t>(texel.t);
    Random random(place << 30 ^ choice);
    const auto bits = static_cast<uint32_t>(random.bits());
    if (choice % 2 == 0) return bits;
    uint32_t extremes = 0;
    for (int i = 0; i < 4; ++i) extremes |= in_channel(bits >> i & 1 ? 255 : 0, i);
    return extremes;
  };
}

}  // namespace selvage::spec
