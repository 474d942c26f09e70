#include "cli/stability_picture.h"

#include <algorithm>
#include <cmath>

#include "cli/comparison_picture.h"
#include "reports/stability/measure.h"
#include "spec/law_tools.h"

namespace selvage::cli {
namespace {

constexpr Colour kMissing{60, 120, 255};
constexpr Colour kExtra{60, 200, 90};

[[nodiscard]] spec::Picture picture_of(const stability::Reference& model) {
  spec::Picture picture{.width_px = model.scene.target_width_px,
                        .height_px = model.scene.target_height_px};
  for (const auto& texel : model.texels) {
    picture.pixels.push_back(texel ? std::optional(spec::coordinate_texel(texel->s, texel->t))
                                   : std::nullopt);
  }
  return picture;
}

[[nodiscard]] int32_t error_texel(const spec::Case& scene, uint32_t drawn, uint32_t expected) {
  return stability::texel_error(scene, spec::texel_of(drawn), spec::texel_of(expected));
}

// From 0 to 1 in the logarithm: 1 is an error of the whole texture.
[[nodiscard]] Colour heat(int32_t error, int32_t side_texel) {
  const double part = std::min(
      1.0, std::log2(double{1} * error) / std::log2(std::max(2.0, double{1} * side_texel)));
  const auto ramp = [&](double from, double to) {
    return static_cast<uint8_t>(std::lround(from + (to - from) * part));
  };
  return {ramp(150, 255), ramp(0, 250), ramp(0, 180)};
}

// The pixel of the largest texel error; -1, -1 if there is none.
void find_worst(PictureComparison& c) {
  int32_t largest = 0;
  for (int32_t y = 0; y < c.drawn.height_px; ++y) {
    for (int32_t x = 0; x < c.drawn.width_px; ++x) {
      const auto& drawn = c.drawn.at(x, y);
      const auto& expected = c.expected.at(x, y);
      const int32_t error = drawn && expected ? error_texel(c.scene, *drawn, *expected) : 0;
      if (error <= largest) continue;
      largest = error;
      c.x_px = x;
      c.y_px = y;
    }
  }
}

}  // namespace

Raster stability_picture(const stability::Contender& contender, const stability::Reference& model) {
  const spec::Case& scene = model.scene;
  PictureComparison comparison{.scene = scene,
                               .drawn = stability::drawing_of(contender, model),
                               .expected = picture_of(model)};
  comparison.difference = [&](const auto& drawn, const auto& expected) {
    if (!drawn) return kMissing;
    if (!expected) return kExtra;
    return heat(error_texel(scene, *drawn, *expected),
                std::max(scene.texture_width_texel, scene.texture_height_texel));
  };
  find_worst(comparison);
  return comparison_picture(comparison);
}

}  // namespace selvage::cli
