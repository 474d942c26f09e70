// A small picture for each selvage_work, to be drawn again and again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "selvage.h"

namespace selvage::measure {

// A target and a texture that together fit SELVAGE_FASTEST_KERNEL_BYTES of 4 bytes a pixel, and the
// affine map that corners have, 1/65536 texel per 1/256 px. All of the target lies within the
// texture.
struct WorkShape {
  int32_t height_px;
  int32_t texture_width, texture_height, pitch_texel;  // no power of two: see selvage_prepare
  int32_t u_along_x, u_along_y, v_along_x, v_along_y;
  int32_t u_texel, v_texel;  // at the target's corner

  [[nodiscard]] selvage_vertex vertex_at(int32_t x_fx8, int32_t y_fx8, int32_t q) const {
    return {x_fx8, y_fx8, u_along_x * x_fx8 + u_along_y * y_fx8 + u_texel * SELVAGE_SUBTEXELS,
            v_along_x * x_fx8 + v_along_y * y_fx8 + v_texel * SELVAGE_SUBTEXELS, q};
  }
};

class WorkPicture {
 public:
  static constexpr int32_t kWidth_px = 256;

  // Target and texture lie in SELVAGE_FASTEST_KERNEL_BYTES of memory. Of the area filter the
  // texture is minified: its boxes are no bilinear ones.
  WorkPicture(selvage_filter filter, selvage_format format, void* memory);

  // Draws all of it.
  void draw(selvage_work work, selvage_kernel kernel) const;

  [[nodiscard]] const selvage_image& target() const { return target_; }
  [[nodiscard]] const selvage_texture& texture() const { return texture_; }

 private:
  void draw_polygon(std::span<const selvage_vertex> vertices, selvage_kernel kernel) const;
  void draw_mesh(selvage_kernel kernel) const;

  selvage_filter filter_;
  const WorkShape& shape_;
  selvage_image target_;
  selvage_texture texture_;
};

}  // namespace selvage::measure
