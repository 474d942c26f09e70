// Images and textures: what makes one valid, and where its bytes are.
#pragma once

#include <cstddef>
#include <cstdint>

#include "selvage.h"

namespace selvage::mapper {

// The format must be valid.
[[nodiscard]] constexpr ptrdiff_t bytes_per_pixel(selvage_format format) {
  return format == SELVAGE_INDEX8 ? 1 : format == SELVAGE_RGB565 ? 2 : 4;
}

// Addresses of bytes, [begin, end).
struct Memory {
  uintptr_t begin, end;

  [[nodiscard]] bool meets(const Memory& other) const {
    return begin < other.end && other.begin < end;
  }
};
// Of so many values; where they would reach beyond the last address, up to there.
[[nodiscard]] Memory memory_of(const void* values, size_t count, size_t bytes_per_value);
// From the first pixel's byte to the last's. The image must have passed its checks.
[[nodiscard]] Memory memory_of(const selvage_image& image);
[[nodiscard]] Memory memory_of(const selvage_texture& texture);

// Each returns SELVAGE_OK or the error of the first rule that is broken.
[[nodiscard]] selvage_status check_target(const selvage_image* target);
[[nodiscard]] selvage_status check_texture(const selvage_texture* texture);
// Both images must have passed the checks above.
[[nodiscard]] selvage_status check_pair(const selvage_image& target,
                                        const selvage_texture& texture);
[[nodiscard]] selvage_status check_vertices(const selvage_image& target,
                                            const selvage_vertex* vertices, size_t count);

// The clip rectangle within the target; NULL is all of it.
[[nodiscard]] selvage_rect visible_rect(const selvage_image& target, const selvage_rect* clip);

}  // namespace selvage::mapper
