// What a subject draws for a case, and what the model says it should: the pixels as values.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "spec/case.h"
#include "spec/coordinate_texture.h"
#include "spec/exact.h"
#include "spec/filter.h"
#include "spec/subject.h"

namespace selvage::spec {

struct Picture {
  int32_t width_px = 0, height_px = 0;
  selvage_status status = SELVAGE_OK;
  std::vector<std::optional<uint32_t>> pixels{};  // row by row; empty where nothing was drawn
  std::string memory_fault{};                     // what MEM forbids and was seen; empty if nothing

  [[nodiscard]] const std::optional<uint32_t>& at(int32_t x_px, int32_t y_px) const {
    return pixels[static_cast<size_t>(y_px) * static_cast<size_t>(width_px) +
                  static_cast<size_t>(x_px)];
  }
};

// Draws the case with the coordinate texture, over two complementary backgrounds and between guard
// bytes. A pixel counts as drawn unless it holds its background both times; one that was drawn and
// differs between the two is a memory fault. Where the format cannot hold the coordinates of the
// case's texture it is drawn with their digits, one after the other, and they are put together;
// which pixels are drawn must not depend on the digit, or it is a memory fault.
[[nodiscard]] Picture draw(const Subject& subject, const Case& c);

// The same with another texture, whose values are the pixels.
[[nodiscard]] Picture draw(const Subject& subject, const Case& c, const TexelAt& texel_at);

// The same by the model of the case's profile.
[[nodiscard]] Picture expected(const Case& c);
[[nodiscard]] Picture expected(const Case& c, const TexelAt& texel_at);
// One pixel of what a valid case's coordinate texture shows.
[[nodiscard]] std::optional<uint32_t> expected_pixel(const Case& c, int32_t x_px, int32_t y_px);

// The texels, addressed, that the case's filter makes a pixel of, which its polygon covers.
struct Weights {
  Taps columns, rows;
};
[[nodiscard]] Weights filter_weights(const Case& c, int32_t x_px, int32_t y_px,
                                     const Sample& point);

}  // namespace selvage::spec
