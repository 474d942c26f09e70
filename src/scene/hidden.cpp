#include "scene/hidden.h"

#include <algorithm>
#include <numeric>

#include "scene/scan_line.h"

namespace selvage::scene {
namespace {

[[nodiscard]] std::vector<Piece> painters_order(std::span<const ScreenFace> faces, Size size) {
  std::vector<size_t> order(faces.size());
  std::iota(order.rbegin(), order.rend(), size_t{0});  // of equal ones the first is drawn last
  std::stable_sort(order.begin(), order.end(),
                   [&](size_t a, size_t b) { return faces[a].mean_w > faces[b].mean_w; });
  std::vector<Piece> pieces;
  for (const size_t face : order) {
    pieces.push_back({face, {0, 0, size.width_px, size.height_px}});
  }
  return pieces;
}

}  // namespace

std::vector<Piece> visible_pieces(Hidden way, std::span<const ScreenFace> faces, Size size) {
  return way == Hidden::kPainter ? painters_order(faces, size) : scan_line_pieces(faces, size);
}

}  // namespace selvage::scene
