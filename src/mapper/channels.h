// The four channels of RGBA8888 texels, summed side by side: two numbers of 32 bits in each of two
// words. Bytes keep their places, so the machine's byte order does not matter.
#pragma once

#include <cstdint>
#include <cstring>

namespace selvage::mapper {

struct Channels {
  uint64_t even = 0, odd = 0;  // of the bytes 0 and 2, and of 1 and 3, lowest first

  [[nodiscard]] static Channels of(uint32_t texel) {
    const auto spread = [](uint32_t bytes) {
      return (uint64_t{bytes & 0xFF}) | (uint64_t{bytes & 0xFF0000} << 16);
    };
    return {spread(texel), spread(texel >> 8)};
  }
  [[nodiscard]] static Channels all(uint32_t value) {
    const uint64_t both = uint64_t{value} << 32 | value;
    return {both, both};
  }
  // The low bytes of the numbers.
  [[nodiscard]] uint32_t texel() const {
    const auto join = [](uint64_t numbers) {
      return static_cast<uint32_t>((numbers & 0xFF) | (numbers >> 16 & 0xFF0000));
    };
    return join(even) | join(odd) << 8;
  }

  // No number leaves its 32 bits in what these are used for.
  friend Channels operator+(Channels a, Channels b) { return {a.even + b.even, a.odd + b.odd}; }
  friend Channels operator*(Channels a, uint32_t weight) {
    return {a.even * weight, a.odd * weight};
  }
  // Bits fall from one number into the high ones of the next; texel() reads the low ones.
  friend Channels operator>>(Channels a, int bits) { return {a.even >> bits, a.odd >> bits}; }
};

[[nodiscard]] inline uint32_t load_texel(const char* at) {
  uint32_t texel;
  std::memcpy(&texel, at, sizeof texel);
  return texel;
}

inline void store_pixel(char* at, uint32_t pixel) { std::memcpy(at, &pixel, sizeof pixel); }

inline constexpr int kPixelBytes = sizeof(uint32_t);

}  // namespace selvage::mapper
