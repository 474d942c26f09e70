#include "reports/gallery/mesh.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "reports/gallery/camera.h"

namespace selvage::reports {

namespace {

// Twice the area in 1/65536 px^2; positive where the vertices run clockwise on the screen.
int64_t doubled_area(const std::vector<selvage_vertex>& v) {
  int64_t sum = 0;
  for (size_t i = 0; i < v.size(); ++i) {
    const selvage_vertex& a = v[i];
    const selvage_vertex& b = v[(i + 1) % v.size()];
    sum += int64_t{a.x} * b.y - int64_t{b.x} * a.y;
  }
  return sum;
}

void append_if_seen(std::vector<Polygon>& polygons, std::vector<selvage_vertex> vertices,
                    const cli::Raster& picture) {
  if (doubled_area(vertices) > 0)
    polygons.push_back({std::move(vertices), &picture, SELVAGE_ADDRESS_CLAMP});
}

using GridPoint = std::pair<int32_t, int32_t>;

Polygon strip(const GridPoint& from, const GridPoint& to, double width_px,
              const cli::Raster& colour) {
  const double x0 = from.first / 256.0, y0 = from.second / 256.0;
  const double x1 = to.first / 256.0, y1 = to.second / 256.0;
  const double scale = width_px / 2 / std::hypot(x1 - x0, y1 - y0);
  const double ox = (y0 - y1) * scale, oy = (x1 - x0) * scale;
  return {{flat_vertex(x0 + ox, y0 + oy, 0, 0), flat_vertex(x1 + ox, y1 + oy, 0, 0),
           flat_vertex(x1 - ox, y1 - oy, 0, 0), flat_vertex(x0 - ox, y0 - oy, 0, 0)},
          &colour,
          SELVAGE_ADDRESS_CLAMP};
}

}  // namespace

const selvage_vertex& Grid::at(int32_t column, int32_t row) const {
  return vertices[static_cast<size_t>(row) * (static_cast<size_t>(columns) + 1) +
                  static_cast<size_t>(column)];
}

Grid Grid::columns_between(int32_t first, int32_t end) const {
  Grid part{end - first, rows, {}};
  for (int32_t j = 0; j <= rows; ++j) {
    for (int32_t i = first; i <= end; ++i) part.vertices.push_back(at(i, j));
  }
  return part;
}

Grid make_grid(int32_t columns, int32_t rows,
               const std::function<selvage_vertex(double, double)>& vertex) {
  Grid grid{columns, rows, {}};
  for (int32_t j = 0; j <= rows; ++j) {
    for (int32_t i = 0; i <= columns; ++i) {
      grid.vertices.push_back(
          vertex(static_cast<double>(i) / columns, static_cast<double>(j) / rows));
    }
  }
  return grid;
}

std::vector<Polygon> quads(const Grid& grid, const cli::Raster& picture) {
  std::vector<Polygon> polygons;
  for (int32_t j = 0; j < grid.rows; ++j) {
    for (int32_t i = 0; i < grid.columns; ++i) {
      append_if_seen(polygons,
                     {grid.at(i, j), grid.at(i + 1, j), grid.at(i + 1, j + 1), grid.at(i, j + 1)},
                     picture);
    }
  }
  return polygons;
}

std::vector<Polygon> triangles(const Grid& grid, const cli::Raster& picture) {
  std::vector<Polygon> polygons;
  for (int32_t j = 0; j < grid.rows; ++j) {
    for (int32_t i = 0; i < grid.columns; ++i) {
      append_if_seen(polygons, {grid.at(i, j), grid.at(i + 1, j), grid.at(i, j + 1)}, picture);
      append_if_seen(polygons, {grid.at(i + 1, j), grid.at(i + 1, j + 1), grid.at(i, j + 1)},
                     picture);
    }
  }
  return polygons;
}

std::vector<Polygon> outlines(const std::vector<Polygon>& polygons, double width_px,
                              const cli::Raster& colour) {
  std::set<std::pair<GridPoint, GridPoint>> edges;
  for (const Polygon& polygon : polygons) {
    for (size_t i = 0; i < polygon.vertices.size(); ++i) {
      const selvage_vertex& a = polygon.vertices[i];
      const selvage_vertex& b = polygon.vertices[(i + 1) % polygon.vertices.size()];
      const GridPoint from{a.x, a.y}, to{b.x, b.y};
      if (from != to) edges.insert(std::minmax(from, to));
    }
  }
  std::vector<Polygon> strips;
  for (const auto& [from, to] : edges) strips.push_back(strip(from, to, width_px, colour));
  return strips;
}

}  // namespace selvage::reports
