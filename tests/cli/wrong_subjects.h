// Mappers that are wrong on purpose, to see the program report them.
#pragma once

#include <vector>

#include "spec/subject.h"

namespace selvage::cli::test {

// Draws what the built-in mapper would with every u larger by `du_texel` texels.
[[nodiscard]] inline spec::Subject shifted_texture(int32_t du_texel) {
  return {"shifted", [du_texel](const selvage_image* target, const selvage_rect* clip,
                                const selvage_vertex* vertices, size_t count,
                                const selvage_texture* texture, const selvage_options* options) {
            if (vertices == nullptr) {
              return selvage_draw(target, clip, vertices, count, texture, options);
            }
            std::vector<selvage_vertex> moved(vertices, vertices + count);
            const auto du = static_cast<uint32_t>(du_texel) * SELVAGE_SUBTEXELS;
            for (selvage_vertex& vertex : moved) {
              vertex.u = static_cast<int32_t>(static_cast<uint32_t>(vertex.u) + du);  // may wrap
            }
            return selvage_draw(target, clip, moved.data(), count, texture, options);
          }};
}

// Does so with triangles in a texture of some widths alone, which few cases have.
[[nodiscard]] inline spec::Subject far_shifted_texture() {
  return {"shifted where rare",
          [shifted = shifted_texture(1)](
              const selvage_image* target, const selvage_rect* clip, const selvage_vertex* vertices,
              size_t count, const selvage_texture* texture, const selvage_options* options) {
            const bool rare = texture != nullptr && texture->width % 8 == 7 && texture->width > 8;
            return (rare && count == 3 ? shifted.draw : selvage_draw)(target, clip, vertices, count,
                                                                      texture, options);
          }};
}

// Accepts everything and draws nothing.
[[nodiscard]] inline spec::Subject blank() {
  return {
      "blank",
      [](const selvage_image*, const selvage_rect*, const selvage_vertex*, size_t,
         const selvage_texture*, const selvage_options*) -> selvage_status { return SELVAGE_OK; }};
}

}  // namespace selvage::cli::test
