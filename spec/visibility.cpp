#include "spec/visibility.h"

namespace selvage::spec {
namespace {

[[nodiscard]] std::optional<Rational> nearness(const ScanLine& line, int32_t x_px) {
  const Rational x = x_px + Rational(1, 2);
  if (x < line.left.x || line.right.x <= x) return std::nullopt;
  const Rational part = (x - line.left.x) / (line.right.x - line.left.x);
  return Rational(line.left.q + part * (line.right.q - line.left.q));
}

}  // namespace

std::optional<Rational> nearness(std::span<const selvage_vertex> vertices, int32_t x_px,
                                 int32_t y_px) {
  const std::optional<ScanLine> line = scan_line(vertices, y_px);
  return line ? nearness(*line, x_px) : std::nullopt;
}

std::vector<std::optional<size_t>> visible(const Polygons& polygons, int32_t width_px,
                                           int32_t height_px) {
  std::vector<std::optional<size_t>> shown;
  for (int32_t y = 0; y < height_px; ++y) {
    std::vector<std::optional<ScanLine>> lines;
    for (const auto& polygon : polygons) lines.push_back(scan_line(polygon, y));
    for (int32_t x = 0; x < width_px; ++x) {
      std::optional<size_t> first;
      Rational greatest;
      for (size_t i = 0; i < polygons.size(); ++i) {
        if (!lines[i]) continue;
        const std::optional<Rational> here = nearness(*lines[i], x);
        if (!here || (first && *here <= greatest)) continue;
        first = i;
        greatest = *here;
      }
      shown.push_back(first);
    }
  }
  return shown;
}

}  // namespace selvage::spec
