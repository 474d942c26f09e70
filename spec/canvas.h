// Memory for one image between guard bytes: whatever a subject writes outside its pixels is seen.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "selvage.h"

namespace selvage::spec {

[[nodiscard]] constexpr int32_t bytes_per_pixel(selvage_format format) {
  return format == SELVAGE_INDEX8 ? 1 : format == SELVAGE_RGB565 ? 2 : 4;
}

// All bits of a pixel's value.
[[nodiscard]] constexpr uint32_t value_bits(selvage_format format) {
  return format == SELVAGE_INDEX8 ? UINT8_MAX : format == SELVAGE_RGB565 ? UINT16_MAX : UINT32_MAX;
}

class Canvas {
 public:
  // All bytes, guards and row padding included, start as `fill`.
  Canvas(selvage_format format, int32_t width_px, int32_t height_px, int32_t padding_px, bool flip,
         uint8_t fill);

  [[nodiscard]] selvage_image image();
  [[nodiscard]] selvage_texture texture() const;

  // The value of a pixel, in the low bytes.
  [[nodiscard]] uint32_t pixel(int32_t x_px, int32_t y_px) const;
  void set_pixel(int32_t x_px, int32_t y_px, uint32_t value);

  // Every byte that is no pixel still is `fill`.
  [[nodiscard]] bool guards_are_intact() const;

  friend bool operator==(const Canvas&, const Canvas&) = default;

 private:
  [[nodiscard]] size_t offset(int32_t x_px, int32_t y_px) const;
  [[nodiscard]] ptrdiff_t pitch() const;

  selvage_format format_;
  int32_t width_px_, height_px_;
  bool flip_;
  uint8_t fill_;
  size_t bytes_per_pixel_, row_bytes_, stride_bytes_, guard_bytes_;
  std::vector<uint32_t> storage_;  // words, so that every format is aligned
};

}  // namespace selvage::spec
