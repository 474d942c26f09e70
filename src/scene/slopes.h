// What is linear on the screen, by its values at a triangle's corners.
#pragma once

#include <span>

#include "scene/screen_face.h"
#include "selvage.h"

namespace selvage::scene {

using Triangle = std::span<const selvage_vertex, 3>;

struct Linear {
  double along_x = 0, along_y = 0;  // changes a pixel
};

[[nodiscard]] inline double px(int32_t fx8) { return fx8 / kSubpixels; }

[[nodiscard]] inline double doubled_area_px(Triangle t) {
  return px(t[1].x - t[0].x) * px(t[2].y - t[0].y) - px(t[2].x - t[0].x) * px(t[1].y - t[0].y);
}

// Of a triangle that has an area.
template <class Value>
[[nodiscard]] Linear slopes(Triangle t, Value value) {
  const double b = value(t[1]) - value(t[0]), c = value(t[2]) - value(t[0]);
  const double bx = px(t[1].x - t[0].x), by = px(t[1].y - t[0].y);
  const double cx = px(t[2].x - t[0].x), cy = px(t[2].y - t[0].y);
  const double area_px = doubled_area_px(t);
  return {(b * cy - c * by) / area_px, (c * bx - b * cx) / area_px};
}

}  // namespace selvage::scene
