// Which bytes a call's arguments are.
#pragma once

#include <cstddef>

#include "selvage.h"
#include "testbed/arena.h"

namespace selvage::testbed {

[[nodiscard]] size_t bytes_per_pixel(selvage_format format);

// From the first row or tile to the end of the last. Empty, at its pointer, where an argument is so
// bad that nobody can tell, or more than `most_bytes`.
[[nodiscard]] Range range_of(const selvage_image* image, size_t most_bytes);
[[nodiscard]] Range range_of(const selvage_texture* texture, size_t most_bytes);
[[nodiscard]] Range range_of(const selvage_vertex* vertices, size_t count, size_t most_bytes);

// What texels may start at a multiple of: a tile's bytes, or a texel's.
[[nodiscard]] size_t unit_of(const selvage_texture& texture);

}  // namespace selvage::testbed
