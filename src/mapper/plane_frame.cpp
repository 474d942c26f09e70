#include "mapper/plane_frame.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <utility>

namespace selvage::mapper {

PlaneFrame PlaneFrame::of_outline(std::span<const selvage_vertex> vertices) {
  const selvage_vertex& origin = vertices[0];
  size_t second = 1;
  while (second + 1 < vertices.size() && vertices[second].x == origin.x &&
         vertices[second].y == origin.y) {
    ++second;
  }
  for (size_t third = second + 1; third < vertices.size(); ++third) {
    const PlaneFrame frame(origin, vertices[second], vertices[third]);
    if (frame.doubled_area_ != 0) return frame.turned();
  }
  return PlaneFrame(origin, origin, origin);
}

PlaneFrame PlaneFrame::canonical(std::span<const selvage_vertex> vertices) {
  const auto before = [](const selvage_vertex& a, const selvage_vertex& b) {
    return std::pair(a.y, a.x) < std::pair(b.y, b.x);
  };
  const auto [first, last] = std::ranges::minmax_element(vertices, before);
  PlaneFrame best(*first, *last, *first);  // of no area
  for (const selvage_vertex& third : vertices) {
    const PlaneFrame frame(*first, *last, third);
    const int64_t area = std::abs(frame.doubled_area_), most = std::abs(best.doubled_area_);
    if (area > most || (area == most && before(third, *best.third_))) best = frame;
  }
  return best.doubled_area_ >= 0 ? best : PlaneFrame(*first, *best.third_, *last);
}

}  // namespace selvage::mapper
