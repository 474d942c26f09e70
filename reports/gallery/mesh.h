// Grids of vertices and the polygons between them.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "reports/gallery/scene.h"

namespace selvage::reports {

struct Grid {
  int32_t columns = 0, rows = 0;         // cells
  std::vector<selvage_vertex> vertices;  // (columns + 1) x (rows + 1), row by row

  [[nodiscard]] const selvage_vertex& at(int32_t column, int32_t row) const;
  // The cells of columns [first, end).
  [[nodiscard]] Grid columns_between(int32_t first, int32_t end) const;
};

// vertex(i / columns, j / rows) for every vertex (i, j).
[[nodiscard]] Grid make_grid(int32_t columns, int32_t rows,
                             const std::function<selvage_vertex(double, double)>& vertex);

// Cells whose vertices run clockwise on the screen, as one quad or as two triangles each; the
// others, seen from behind, are left out.
[[nodiscard]] std::vector<Polygon> quads(const Grid& grid, const cli::Raster& picture);
[[nodiscard]] std::vector<Polygon> triangles(const Grid& grid, const cli::Raster& picture);

// The edges of the polygons as strips of that width, each edge once.
[[nodiscard]] std::vector<Polygon> outlines(const std::vector<Polygon>& polygons, double width_px,
                                            const cli::Raster& colour);

}  // namespace selvage::reports
