// Address modes: a texel index of the plane to one of the texture.
#pragma once

#include <algorithm>
#include <cstdint>

namespace selvage::mapper {

// For spans known to stay inside.
struct Inside {
  [[nodiscard]] static int32_t index(int32_t texel, int32_t /*size_texel*/) { return texel; }
};

struct Clamp {
  [[nodiscard]] static int32_t index(int32_t texel, int32_t size_texel) {
    return std::clamp<int32_t>(texel, 0, size_texel - 1);
  }
};

struct Wrap {
  [[nodiscard]] static int32_t index(int32_t texel, int32_t size_texel) {
    const int32_t remainder = texel % size_texel;
    return remainder < 0 ? remainder + size_texel : remainder;
  }
};

// Wrap without its division, for sizes that are powers of two.
struct WrapMasked {
  [[nodiscard]] static bool fits(int32_t size_texel) {
    return (size_texel & (size_texel - 1)) == 0;
  }
  [[nodiscard]] static int32_t index(int32_t texel, int32_t size_texel) {
    return texel & (size_texel - 1);
  }
};

}  // namespace selvage::mapper
