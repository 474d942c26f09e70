// Pictures that tell which face shows, and how often each pixel was written.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <span>
#include <vector>

#include "scene/hidden.h"
#include "selvage.h"

namespace selvage::scene {

struct IndexPicture {
  std::vector<int> face;    // of each pixel; -1 for none
  std::vector<int> writes;  // to each pixel

  friend bool operator==(const IndexPicture&, const IndexPicture&) = default;
};

// Draws the pieces one by one through selvage_draw.
[[nodiscard]] inline IndexPicture draw_indices(std::span<const Piece> pieces,
                                               std::span<const ScreenFace> faces, Size size) {
  const size_t area = static_cast<size_t>(size.width_px) * static_cast<size_t>(size.height_px);
  IndexPicture picture{std::vector<int>(area, -1), std::vector<int>(area)};
  const uint8_t drawn = 1;
  const selvage_texture texture{&drawn, 1, 1, 1, SELVAGE_INDEX8, SELVAGE_LAYOUT_ROWS, nullptr};
  for (const Piece& piece : pieces) {
    std::vector<uint8_t> mask(area);
    const selvage_image image{mask.data(), size.width_px, size.height_px, size.width_px,
                              SELVAGE_INDEX8};
    const std::vector<selvage_vertex>& vertices = faces[piece.face].vertices;
    EXPECT_EQ(
        selvage_draw(&image, &piece.clip, vertices.data(), vertices.size(), &texture, nullptr),
        SELVAGE_OK);
    for (size_t i = 0; i < area; ++i) {
      if (mask[i] != drawn) continue;
      picture.face[i] = static_cast<int>(piece.face);
      ++picture.writes[i];
    }
  }
  return picture;
}

}  // namespace selvage::scene
