#include "scene/texture_sums.h"

#include <utility>

namespace selvage::scene {

selvage_texture TextureSums::of(size_t number, const selvage_texture& texture,
                                double spared_texels) {
  Copy& copy = copies_[number];
  if (!copy.memory) {
    copy.lost_texels += spared_texels;
    const double texels = static_cast<double>(texture.width) * texture.height;
    if (copy.lost_texels >= kMakingSums_texels * texels) make(texture, copy);
  }
  return copy.memory ? copy.texture : texture;
}

// What does not fit is not made, nor is it an error: the picture is the same.
void TextureSums::make(const selvage_texture& texture, Copy& copy) {
  const size_t bytes = selvage_prepare_bytes(&texture, SELVAGE_LAYOUT_ROWS, 1);
  if (bytes > most_bytes_ - bytes_) return;
  const int64_t start_ns = now_ns_();
  auto memory = std::make_unique_for_overwrite<Block[]>((bytes - 1) / sizeof(Block) + 1);
  if (selvage_prepare(&texture, SELVAGE_LAYOUT_ROWS, 1, memory.get(), bytes, &copy.texture) ==
      SELVAGE_OK) {
    copy.memory = std::move(memory);
    bytes_ += bytes;
  }
  ns_ += now_ns_() - start_ns;
}

}  // namespace selvage::scene
