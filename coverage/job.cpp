#include "coverage/job.h"

#include <cstring>
#include <utility>

namespace selvage::coverage {
ptrdiff_t bytes_per_texel(selvage_format format) {
  return format == SELVAGE_INDEX8 ? 1 : format == SELVAGE_RGB565 ? 2 : 4;
}

ptrdiff_t place_of(const selvage_texture& texture, spec::Texel texel) {
  const ptrdiff_t bytes = bytes_per_texel(texture.format);
  const auto& [s, t] = texel;
  if (texture.layout == SELVAGE_LAYOUT_ROWS) return t * texture.pitch + s * bytes;
  return t / 4 * texture.pitch + (s / 4 * 16 + t % 4 * 4 + s % 4) * bytes;
}

bool in_clip(const Job& job, int32_t x, int32_t y) {
  return job.clip.left <= x && x < job.clip.right && job.clip.top <= y && y < job.clip.bottom;
}

void copy_texel(const Job& job, spec::Texel texel, int32_t x, int32_t y) {
  const ptrdiff_t size = bytes_per_texel(job.target.format);
  const char* from = static_cast<const char*>(job.texture.texels) + job.place(job.texture, texel);
  char* pixel = static_cast<char*>(job.target.pixels) + y * job.target.pitch + x * size;
  std::memcpy(pixel, from, static_cast<size_t>(size));
}

uint32_t texel_value(const Job& job, spec::Texel texel) {
  uint32_t value;
  std::memcpy(&value, static_cast<const char*>(job.texture.texels) + job.place(job.texture, texel),
              sizeof value);
  return value;
}

void set_pixel(const Job& job, uint32_t value, int32_t x, int32_t y) {
  char* pixel =
      static_cast<char*>(job.target.pixels) + y * job.target.pitch + x * ptrdiff_t{sizeof value};
  std::memcpy(pixel, &value, sizeof value);
}

spec::Subject subject_of(std::string name, selvage_profile profile, DrawJob draw,
                         EndStatus end_status) {
  const auto call = [draw = std::move(draw), end_status = std::move(end_status)](
                        const selvage_image* target, const selvage_rect* clip,
                        const selvage_vertex* vertices, size_t count,
                        const selvage_texture* texture,
                        const selvage_options* options) -> selvage_status {
    // The checks are not what is wrong here: an empty clip rectangle asks for nothing but them.
    const selvage_rect nothing{0, 0, 0, 0};
    const selvage_status status = selvage_draw(target, &nothing, vertices, count, texture, options);
    if (status != SELVAGE_OK) return end_status(status);
    draw(Job{.target = *target,
             .clip = clip != nullptr ? *clip : selvage_rect{0, 0, target->width, target->height},
             .vertices = {vertices, vertices + count},
             .texture = *texture,
             .address = options != nullptr ? options->address : SELVAGE_ADDRESS_CLAMP,
             .filter = options != nullptr ? options->filter : SELVAGE_FILTER_NEAREST,
             .tolerance = options != nullptr ? options->tolerance : 0});
    return end_status(status);
  };
  return {std::move(name), call, profile};
}

}  // namespace selvage::coverage
