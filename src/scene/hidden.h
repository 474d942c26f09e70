// Hidden surfaces: which parts of which faces to draw, two ways.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "scene/screen_face.h"
#include "scene/vectors.h"
#include "selvage.h"

namespace selvage::scene {

enum class Hidden {
  // All of every face, the farthest first, by the mean w of its corners. Right where faces do not
  // overlap, as those of one convex object; elsewhere as right as one number a face can tell.
  kPainter,
  // Row by row only what shows: at every pixel the face of the greatest q there (of equal ones the
  // first), exactly. Faces may cut through each other. No pixel is drawn twice.
  kScanLine
};

// The face, as far as it lies within the clip rectangle.
struct Piece {
  size_t face;
  selvage_rect clip;
};

// To be drawn in this order. The faces' outlines are y-monotone.
[[nodiscard]] std::vector<Piece> visible_pieces(Hidden way, std::span<const ScreenFace> faces,
                                                Size size);

}  // namespace selvage::scene
