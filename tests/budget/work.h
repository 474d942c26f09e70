// Stated workloads for counting instructions.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "selvage.h"

namespace selvage::budget {

using Polygon = std::vector<selvage_vertex>;

struct Rows {
  int32_t begin, end;
};

struct Work {
  std::string_view unit;  // what a budget is per: "triangle" or "px"
  std::vector<Polygon> polygons;
  int32_t target_width_px, target_height_px;
  int32_t texture_side_texel;
  selvage_filter filter;
  selvage_address address = SELVAGE_ADDRESS_CLAMP;
  bool with_sums = false;
  bool flips_texture = false;            // its bottom row is stored first
  bool as_list = false;                  // drawn by one call
  Rows rows_px = {0, target_height_px};  // that are drawn
};

// mesh-52 and mesh-484: a jittered mesh of triangles of about so many pixels; tilted-52 and
// tilted-484: the same in perspective; affine, perspective and bilinear: 64 spans of 1024 px; area,
// area-tilted, area-ruled and area-sums: minified spans, the last by looking boxes up; A1 and so
// on, A1-ordinary and so on: 64 rows of an adversarial item of the report, and of its ordinary
// twin; seed-N and seed-N-ordinary: a map of `selvage bench --near-ties`, and one of its twins.
// With -flipped behind it, from a texture stored bottom row first; with -list, by one call of
// selvage_draw_many. Nothing for another name.
[[nodiscard]] std::optional<Work> work_of(std::string_view kind);

// Less of the same. Of many polygons the first 64 where triangles are the unit, 8 where pixels are;
// of few the 8 rows in their middle, or 2 by the area filter, whose pixels cost the most.
[[nodiscard]] Work excerpt_of(Work work);

}  // namespace selvage::budget
