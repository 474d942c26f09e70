// The fans that laws PART and PINWHEEL draw: triangles from one point to each side of an outline.
#pragma once

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "spec/capabilities.h"
#include "spec/case.h"
#include "spec/picture.h"

namespace selvage::spec {

// How many tiles draw a pixel: those that run clockwise, and the others.
struct Times {
  int clockwise = 0, counter_clockwise = 0;

  // As often as the outline winds around it: where tiles fold back they cancel each other out.
  [[nodiscard]] int sum() const { return clockwise - counter_clockwise; }
};

// The tiles (centre, v_k, v_k+1) of an outline, drawn one at a time.
struct Fan {
  std::vector<Times> times;    // of each pixel of the target
  std::vector<bool> in_doubt;  // those where a tile is that may turn over
  bool runs_one_way = true;    // no tile is counter-clockwise
};

// Whether a triangle is so thin that it may run the other way round where its outline is so far
// off, in 1/65536 px: a corner is no further than twice that from the other two's line.
[[nodiscard]] bool may_turn_over(const std::vector<selvage_vertex>& triangle,
                                 int32_t coverage_accuracy_fx16);

using DrawTile = std::function<Picture(const Case& tile)>;

// Every second tile shows a texture of another size: which pixels it covers is the same.
[[nodiscard]] Fan draw_fan(const Case& region, const selvage_vertex& centre,
                           const Capabilities& claims, const DrawTile& draw_tile);

// Law PART chooses one by Case::choice, after its choice of the region: a corner of the outline, a
// point between corners, or one near the target.
[[nodiscard]] selvage_vertex part_centre(const Case& region);
// That of law PINWHEEL is the sample point of the pixel.
[[nodiscard]] selvage_vertex pinwheel_centre(const Case& region, int32_t x_px, int32_t y_px);

// The centre of the fan in which a violation of either law was seen at a pixel; none for other laws
// and where no pixel is to blame.
[[nodiscard]] std::optional<selvage_vertex> fan_centre(std::string_view law, const Case& region,
                                                       int32_t x_px, int32_t y_px);

}  // namespace selvage::spec
