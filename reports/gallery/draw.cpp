#include "reports/gallery/draw.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "cli/bitmap.h"
#include "spec/exact.h"

namespace selvage::reports {

namespace {

constexpr cli::Colour kNothing{30, 33, 40, 255}, kEqual{120, 128, 140, 255},
    kDifferent{255, 32, 32, 255};

selvage_texture texture_of(const cli::Raster& picture) {
  return {picture.rgba.data(),
          picture.width_px,
          picture.height_px,
          static_cast<ptrdiff_t>(picture.width_px) * 4,
          SELVAGE_RGBA8888,
          SELVAGE_LAYOUT_ROWS,
          nullptr};
}

// Pixels outside cannot be covered.
selvage_rect bounds_of(const Polygon& polygon, const Scene& scene) {
  const auto& vertices = polygon.vertices;
  const auto [left, right] = std::minmax_element(
      vertices.begin(), vertices.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
  const auto [top, bottom] = std::minmax_element(
      vertices.begin(), vertices.end(), [](const auto& a, const auto& b) { return a.y < b.y; });
  const auto x = [&](int32_t fx8) {
    return std::clamp(fx8 / SELVAGE_SUBPIXELS, 0, scene.width_px);
  };
  const auto y = [&](int32_t fx8) {
    return std::clamp(fx8 / SELVAGE_SUBPIXELS, 0, scene.height_px);
  };
  return {x(left->x), y(top->y), x(right->x + SELVAGE_SUBPIXELS), y(bottom->y + SELVAGE_SUBPIXELS)};
}

void draw_by_model(const Polygon& polygon, const Scene& scene, ModelDrawing& drawing) {
  const cli::Raster& picture = *polygon.picture;
  const selvage_rect bounds = bounds_of(polygon, scene);
  for (int32_t y = bounds.top; y < bounds.bottom; ++y) {
    const auto line = spec::scan_line(polygon.vertices, y);
    if (!line) continue;
    for (int32_t x = bounds.left; x < bounds.right; ++x) {
      const auto sample = spec::sample(*line, x);
      if (!sample) continue;
      const spec::Texel texel =
          spec::nearest_texel(*sample, picture.width_px, picture.height_px, polygon.address);
      drawing.picture.set(x, y, picture.at(texel.s, texel.t));
      uint8_t& covers =
          drawing.covers[static_cast<size_t>(y) * static_cast<size_t>(scene.width_px) +
                         static_cast<size_t>(x)];
      if (covers < UINT8_MAX) ++covers;
    }
  }
}

}  // namespace

cli::Raster draw_by_mapper(const Scene& scene) {
  cli::Raster raster = cli::filled(scene.width_px, scene.height_px, scene.background);
  const selvage_image image{raster.rgba.data(), raster.width_px, raster.height_px,
                            static_cast<ptrdiff_t>(raster.width_px) * 4, SELVAGE_RGBA8888};
  for (size_t i = 0; i < scene.polygons.size(); ++i) {
    const Polygon& polygon = scene.polygons[i];
    const selvage_texture texture = texture_of(*polygon.picture);
    selvage_options options{};
    options.address = polygon.address;
    const selvage_status status = selvage_draw(&image, nullptr, polygon.vertices.data(),
                                               polygon.vertices.size(), &texture, &options);
    if (status != SELVAGE_OK) {
      throw std::runtime_error(scene.id + ", polygon " + std::to_string(i) + ": " +
                               selvage_status_text(status));
    }
  }
  return raster;
}

ModelDrawing draw_by_model(const Scene& scene) {
  ModelDrawing drawing;
  drawing.picture = cli::filled(scene.width_px, scene.height_px, scene.background);
  drawing.covers.resize(static_cast<size_t>(scene.width_px) * static_cast<size_t>(scene.height_px));
  for (const Polygon& polygon : scene.polygons) draw_by_model(polygon, scene, drawing);
  return drawing;
}

Difference compare(const cli::Raster& drawn, const ModelDrawing& model) {
  Difference difference;
  difference.map = cli::filled(drawn.width_px, drawn.height_px, kNothing);
  size_t at = 0;
  for (int32_t y = 0; y < drawn.height_px; ++y) {
    for (int32_t x = 0; x < drawn.width_px; ++x, ++at) {
      const uint8_t covers = model.covers[at];
      difference.covered_px += covers > 0;
      difference.covered_twice_px += covers > 1;
      if (drawn.at(x, y) != model.picture.at(x, y)) {
        ++difference.differing_px;
        difference.map.set(x, y, kDifferent);
      } else if (covers > 0) {
        difference.map.set(x, y, kEqual);
      }
    }
  }
  return difference;
}

}  // namespace selvage::reports
