// A small picture for each selvage_work, to be drawn again and again.
#pragma once

#include <cstddef>
#include <cstdint>

#include "selvage.h"

namespace selvage::measure {

class WorkPicture {
 public:
  static constexpr int32_t kWidth_px = 256, kHeight_px = 64;
  static constexpr int32_t kSide_texel = 120;
  static constexpr int32_t kPitch_texel = 124;  // no power of two: see selvage_prepare

  // Target and texture lie in SELVAGE_FASTEST_KERNEL_BYTES of memory.
  WorkPicture(selvage_format format, void* memory);

  // Draws all of it.
  void draw(selvage_work work, selvage_filter filter, selvage_kernel kernel) const;

  [[nodiscard]] const selvage_image& target() const { return target_; }

 private:
  void draw_polygon(const selvage_vertex* vertices, size_t count,
                    const selvage_options& options) const;
  void draw_mesh(const selvage_options& options) const;

  selvage_image target_;
  selvage_texture texture_;
};

}  // namespace selvage::measure
