// What the tests of cases share: the ranges that spec/case.h states.
#pragma once

#include <string>

#include "spec/case.h"

namespace selvage::spec {

// What is out of its range, in words; empty if nothing is.
[[nodiscard]] inline std::string out_of_range(const Case& c) {
  const auto bad_size = [](int32_t width, int32_t height) {
    return width < 1 || height < 1 || width > 65536 || height > 65536 ||
           int64_t{width} * height > 65536;
  };
  const auto bad_position = [](int32_t at) { return at < SELVAGE_X_MIN || at >= SELVAGE_X_END; };
  if (c.format < SELVAGE_INDEX8 || c.format > SELVAGE_RGBA8888) return "format";
  if (c.filter < SELVAGE_FILTER_NEAREST || c.filter > SELVAGE_FILTER_AREA) return "filter";
  if (c.address != SELVAGE_ADDRESS_CLAMP && c.address != SELVAGE_ADDRESS_WRAP) return "address";
  if (bad_size(c.target_width_px, c.target_height_px)) return "target size";
  if (bad_size(c.texture_width_texel, c.texture_height_texel)) return "texture size";
  if (c.padding_px < 0 || c.padding_px > 15) return "padding";
  for (const int32_t side : {c.clip.left, c.clip.top, c.clip.right, c.clip.bottom}) {
    if (side < -32768 || side > 32767) return "clip";
  }
  if (c.layout < Layout::kGiven || c.layout > Layout::kTiled) return "layout";
  if (c.vertices.size() > kMaxVertices) return "vertex count";
  for (const selvage_vertex& vertex : c.vertices) {
    if (bad_position(vertex.x) || bad_position(vertex.y)) return "position";
    if (vertex.q < 1 || vertex.q > SELVAGE_Q_MAX) return "q";
  }
  return "";
}

}  // namespace selvage::spec
