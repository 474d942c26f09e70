// The scan-line algorithm: an edge table, the edges that the current row crosses, and what shows.
#pragma once

#include <span>
#include <vector>

#include "scene/hidden.h"

namespace selvage::scene {

[[nodiscard]] std::vector<Piece> scan_line_pieces(std::span<const ScreenFace> faces, Size size);

}  // namespace selvage::scene
