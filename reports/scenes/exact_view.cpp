#include "reports/scenes/exact_view.h"

#include <cstring>

#include "spec/filter.h"
#include "spec/gradient.h"
#include "spec/visibility.h"

namespace selvage::reports {

ExactView exact_view(const scene::View& view, const scene::Size& size) {
  spec::Polygons polygons;
  for (const scene::ScreenFace& face : view.faces) polygons.push_back(face.vertices);
  const auto shown = spec::visible(polygons, size.width_px, size.height_px);
  ExactView exact{size, {}};
  exact.pixels.reserve(shown.size());
  for (const std::optional<size_t>& face : shown) {
    const auto x_px = static_cast<int32_t>(exact.pixels.size()) % size.width_px;
    const auto y_px = static_cast<int32_t>(exact.pixels.size()) / size.width_px;
    ExactPixel pixel{face, {}};
    if (face && view.faces[*face].paint.texture)
      pixel.at = spec::sample(polygons[*face], x_px, y_px);
    exact.pixels.push_back(std::move(pixel));
  }
  return exact;
}

uint32_t texel_of(const selvage_texture& texture, const spec::Texel& texel) {
  uint32_t value = 0;
  std::memcpy(&value,
              static_cast<const uint8_t*>(texture.texels) + texel.t * texture.pitch +
                  texel.s * static_cast<ptrdiff_t>(sizeof value),
              sizeof value);
  return value;
}

uint32_t model_colour(std::span<const selvage_vertex> vertices, const spec::Sample& at,
                      int32_t x_px, int32_t y_px, const selvage_texture& texture,
                      const selvage_options& options) {
  if (options.filter == SELVAGE_FILTER_NEAREST) {
    return texel_of(texture,
                    spec::nearest_texel(at, texture.width, texture.height, options.address));
  }
  spec::BoxSides sides;
  if (options.filter == SELVAGE_FILTER_AREA)
    sides = spec::box_sides(spec::gradient(vertices, x_px, y_px).value());
  const spec::Taps columns = spec::addressed(spec::taps(options.filter, at.u, sides.u_fx8),
                                             texture.width, options.address);
  const spec::Taps rows = spec::addressed(spec::taps(options.filter, at.v, sides.v_fx8),
                                          texture.height, options.address);
  return spec::weighted_mean(columns, rows,
                             [&](const spec::Texel& texel) { return texel_of(texture, texel); });
}

}  // namespace selvage::reports
