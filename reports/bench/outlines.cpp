#include "reports/bench/outlines.h"

#include <cmath>
#include <random>

namespace selvage::reports {

namespace {

constexpr double kPi = 3.14159265358979323846;

int32_t tilted_q(const selvage_vertex& vertex, int32_t target_px) {
  constexpr int32_t least = 1 << 20;
  const int64_t down_fx8 = int64_t{vertex.x} + 2 * int64_t{vertex.y};
  return least +
         static_cast<int32_t>(down_fx8 * least / (int64_t{3} * target_px * SELVAGE_SUBPIXELS));
}

// The vertices of the mesh, row by row.
Polygon jittered_grid(int32_t columns, int32_t rows, int32_t target_px, int32_t texture_side_texel,
                      uint64_t seed, MeshDepth depth) {
  const int32_t low_fx8 = 20 * SELVAGE_SUBPIXELS + 31;
  const int32_t high_fx8 = (target_px - 20) * SELVAGE_SUBPIXELS - 57;
  const int32_t extent_fx8 = high_fx8 - low_fx8;
  const int64_t texture_fx16 = int64_t{texture_side_texel} * SELVAGE_SUBTEXELS;
  std::mt19937_64 random(seed);
  const auto jitter_fx8 = [&](int32_t cell_fx8) {
    const int32_t reach = cell_fx8 * 3 / 10;
    return static_cast<int32_t>(random() % static_cast<uint64_t>(2 * reach + 1)) - reach;
  };
  Polygon grid;
  for (int32_t j = 0; j <= rows; ++j) {
    for (int32_t i = 0; i <= columns; ++i) {
      selvage_vertex vertex{low_fx8 + static_cast<int32_t>(int64_t{extent_fx8} * i / columns),
                            low_fx8 + static_cast<int32_t>(int64_t{extent_fx8} * j / rows),
                            static_cast<int32_t>(texture_fx16 * i / columns),
                            static_cast<int32_t>(texture_fx16 * j / rows), 1};
      const bool inner = i > 0 && i < columns && j > 0 && j < rows;
      if (inner) vertex.x += jitter_fx8(extent_fx8 / columns);
      if (inner) vertex.y += jitter_fx8(extent_fx8 / rows);
      if (depth == MeshDepth::kTilted) vertex.q = tilted_q(vertex, target_px);
      grid.push_back(vertex);
    }
  }
  return grid;
}

}  // namespace

int32_t px_to_fx8(double px) {
  return static_cast<int32_t>(std::lround(px * static_cast<double>(SELVAGE_SUBPIXELS)));
}

int32_t texel_to_fx16(double texel) {
  return static_cast<int32_t>(std::lround(texel * static_cast<double>(SELVAGE_SUBTEXELS)));
}

Polygon turned_square(double middle_x_px, double middle_y_px, double side_px, double texels) {
  const double c = std::cos(kTurn_degree * kPi / 180) * side_px;
  const double s = std::sin(kTurn_degree * kPi / 180) * side_px;
  const int32_t x0 = px_to_fx8(middle_x_px - (c - s) / 2);
  const int32_t y0 = px_to_fx8(middle_y_px - (s + c) / 2);
  const int32_t cx = px_to_fx8(c), sx = px_to_fx8(s), end = texel_to_fx16(texels);
  return {{x0, y0, 0, 0, 1},
          {x0 + cx, y0 + sx, end, 0, 1},
          {x0 + cx - sx, y0 + sx + cx, end, end, 1},
          {x0 - sx, y0 + cx, 0, end, 1}};
}

Polygon far_triangle(const CornerMap& u, const CornerMap& v) {
  constexpr int32_t far_fx8 = kFar_px * SELVAGE_SUBPIXELS;
  return {{0, 0, u.origin_fx16, v.origin_fx16, 1},
          {far_fx8, 0, u.right_fx16, v.right_fx16, 1},
          {0, far_fx8, u.below_fx16, v.below_fx16, 1}};
}

std::vector<Polygon> jittered_mesh(int32_t columns, int32_t rows, int32_t target_px,
                                   int32_t texture_side_texel, uint64_t seed, MeshDepth depth) {
  const Polygon grid = jittered_grid(columns, rows, target_px, texture_side_texel, seed, depth);
  std::vector<Polygon> mesh;
  for (int32_t j = 0; j < rows; ++j) {
    for (int32_t i = 0; i < columns; ++i) {
      const size_t at = static_cast<size_t>(j * (columns + 1) + i);
      const size_t below = at + static_cast<size_t>(columns) + 1;
      mesh.push_back({grid[at], grid[at + 1], grid[below]});
      mesh.push_back({grid[at + 1], grid[below + 1], grid[below]});
    }
  }
  return mesh;
}

}  // namespace selvage::reports
