// A scene's picture by the exact model, pixel by pixel: which face shows, and at which u and v.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "scene/look.h"
#include "spec/exact.h"

namespace selvage::reports {

struct ExactPixel {
  std::optional<size_t> face;      // of the view; empty where the background shows
  std::optional<spec::Sample> at;  // where that face has a texture
};

struct ExactView {
  scene::Size size;
  std::vector<ExactPixel> pixels;  // row by row, the top one first

  [[nodiscard]] const ExactPixel& pixel(int32_t x_px, int32_t y_px) const {
    return pixels[static_cast<size_t>(y_px) * static_cast<size_t>(size.width_px) +
                  static_cast<size_t>(x_px)];
  }
};

// By asking every face at every pixel.
[[nodiscard]] ExactView exact_view(const scene::View& view, const scene::Size& size);

// What a pixel of a texture shows by the model. (x_px, y_px) is where the polygon shows `at`.
[[nodiscard]] uint32_t model_colour(std::span<const selvage_vertex> vertices,
                                    const spec::Sample& at, int32_t x_px, int32_t y_px,
                                    const selvage_texture& texture, const selvage_options& options);

// A texel of a texture in rows of RGBA8888, as the value of a pixel.
[[nodiscard]] uint32_t texel_of(const selvage_texture& texture, const spec::Texel& texel);

}  // namespace selvage::reports
