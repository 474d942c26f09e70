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
