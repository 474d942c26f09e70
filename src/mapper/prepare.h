// Textures laid out anew in memory of the caller's.
#pragma once

#include <cstddef>

#include "selvage.h"

namespace selvage::mapper {

// What a texture will be: texels from the first byte on, and right behind them the sums, if wanted.
struct Preparation {
  selvage_layout layout;
  bool with_sums;
  ptrdiff_t pitch_bytes;
  size_t bytes;  // of texels and sums; SIZE_MAX if they are more than PTRDIFF_MAX
};

// Of a valid texture; with sums only for RGBA8888.
[[nodiscard]] Preparation preparation(const selvage_texture& source, selvage_layout layout,
                                      bool with_sums);

// Writes texels and sums into plan.bytes of memory that is aligned and lies apart from the source.
[[nodiscard]] selvage_texture prepare(const selvage_texture& source, const Preparation& plan,
                                      void* memory);

}  // namespace selvage::mapper
