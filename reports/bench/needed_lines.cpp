#include "reports/bench/needed_lines.h"

#include <stdexcept>

#include "reports/bench/spans.h"

namespace selvage::reports {

namespace {

// Lines that have been needed, by the address of a texel.
class SeenLines {
 public:
  explicit SeenLines(const Texture& texture)
      : first_(line_of(texture.texels.data())),
        seen_(line_of(&texture.texels.back()) - first_ + 1) {}

  [[nodiscard]] bool is_new(const uint32_t* texel) {
    const size_t line = line_of(texel) - first_;
    const bool seen = seen_[line];
    seen_[line] = true;
    return !seen;
  }

 private:
  static size_t line_of(const uint32_t* texel) {
    return reinterpret_cast<uintptr_t>(texel) / kLineBytes;
  }

  size_t first_;
  std::vector<bool> seen_;
};

}  // namespace

NeededLines needed_lines(const Workload& load, const Texture& texture) {
  NeededLines needed;
  SeenLines lines(texture);
  Target target(load.target_side_px, load.target_side_px);
  const selvage_image image = target.image();
  const selvage_texture view = texture.view();
  for (const auto& polygon : load.polygons) {
    const selvage_status status =
        selvage_draw(&image, nullptr, polygon.data(), polygon.size(), &view, nullptr);
    if (status != SELVAGE_OK)
      throw std::runtime_error(load.id + ": selvage_draw: " + selvage_status_text(status));
    for_each_span(polygon, target.width_px, target.height_px, [&](const Span& span) {
      for (int32_t x = span.left_px; x < span.right_px; ++x) {
        const uint32_t place = target.row(span.y_px)[x];
        const int32_t texel = row_of(place) * texture.pitch_texel + column_of(place);
        if (lines.is_new(&texture.texels.at(static_cast<size_t>(texel))))
          needed.texels.push_back(static_cast<uint32_t>(texel));
      }
      needed.end.push_back(needed.texels.size());
    });
  }
  return needed;
}

}  // namespace selvage::reports
