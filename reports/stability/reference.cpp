#include "reports/stability/reference.h"

#include <algorithm>
#include <utility>

namespace selvage::stability {
namespace {

[[nodiscard]] selvage_rect visible(const spec::Case& c) {
  selvage_rect rect{0, 0, c.target_width_px, c.target_height_px};
  if (!c.has_clip) return rect;
  return {std::max(rect.left, c.clip.left), std::max(rect.top, c.clip.top),
          std::min(rect.right, c.clip.right), std::min(rect.bottom, c.clip.bottom)};
}

}  // namespace

Reference reference(spec::Case scene) {
  scene.format = SELVAGE_RGBA8888;
  Reference model{std::move(scene), {}};
  const spec::Case& c = model.scene;
  const auto width = static_cast<size_t>(c.target_width_px);
  model.texels.resize(width * static_cast<size_t>(c.target_height_px));
  if (spec::validity(c.vertices) != SELVAGE_OK) return model;
  const selvage_rect rect = visible(c);
  for (int32_t y = rect.top; y < rect.bottom; ++y) {
    const std::optional<spec::ScanLine> line = spec::scan_line(c.vertices, y);
    if (!line) continue;
    // Only columns that the edges can have between them are asked.
    const int32_t first = std::max(rect.left, spec::floor(line->left.x));
    const int32_t last = std::min(rect.right - 1, spec::floor(line->right.x));
    for (int32_t x = first; x <= last; ++x) {
      const std::optional<spec::Sample> point = spec::sample(*line, x);
      if (!point) continue;
      const spec::Texel texel =
          spec::nearest_texel(*point, c.texture_width_texel, c.texture_height_texel, c.address);
      model.texels[static_cast<size_t>(y) * width + static_cast<size_t>(x)] = texel;
      model.shows_address |= texel.s != spec::floor(point->u) || texel.t != spec::floor(point->v);
      ++model.covered_px;
    }
  }
  return model;
}

}  // namespace selvage::stability
