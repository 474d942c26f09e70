// Visible segments, gathered into rectangles of as many rows as possible.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/hidden.h"
#include "scene/row_span.h"

namespace selvage::scene {

// Where a segment ends with its span no clip is needed: the face ends there itself. So a face that
// nothing hides is one piece, whatever its outline.
class PieceList {
 public:
  PieceList(size_t face_count, int32_t width_px) : last_of_face_(face_count), width_px_(width_px) {}

  // Rows in order from top to bottom.
  void add(int32_t row, const RowSpan& span, int32_t first_px, int32_t end_px);

  // One face after another, so that what is made ready for it is used up.
  [[nodiscard]] std::vector<Piece> take() &&;

 private:
  std::vector<Piece> pieces_;
  std::vector<std::vector<size_t>>
      last_of_face_;  // the pieces that end in the last row or this one
  int32_t width_px_;
};

}  // namespace selvage::scene
