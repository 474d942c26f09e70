// Colours and levels of light, 0 .. 255 a channel.
#pragma once

#include <cstdint>

namespace selvage::scene {

struct Colour {
  uint8_t red = 0, green = 0, blue = 0, alpha = 255;
  friend bool operator==(const Colour&, const Colour&) = default;
};

// How much of each channel a face reflects; 255 is all of it.
struct Light {
  uint8_t red = 255, green = 255, blue = 255;
  friend auto operator<=>(const Light&, const Light&) = default;
};

// channel x level / 255, to the nearest: (c l + 127) / 255 rounded down. Exact at both ends.
[[nodiscard]] constexpr uint8_t lit(uint8_t channel, uint8_t level) {
  return static_cast<uint8_t>((channel * level + 127) / 255);
}
[[nodiscard]] constexpr Colour lit(const Colour& c, const Light& light) {
  return {lit(c.red, light.red), lit(c.green, light.green), lit(c.blue, light.blue), c.alpha};
}

}  // namespace selvage::scene
