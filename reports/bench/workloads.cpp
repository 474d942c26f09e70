#include "reports/bench/workloads.h"

#include <array>
#include <cmath>
#include <random>
#include <stdexcept>

namespace selvage::reports {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kTurn_degree = 23;
constexpr int32_t kTargetSide_px = 1024;

int32_t to_fx8(double px) {
  constexpr double subpixels = SELVAGE_SUBPIXELS;
  return static_cast<int32_t>(std::lround(px * subpixels));
}
int32_t to_fx16(int32_t texel) { return texel * SELVAGE_SUBTEXELS; }

// A square of that side about the middle of the target. The fourth corner is the sum of its
// neighbours less the first, so that the snapped map is affine without an error.
std::vector<selvage_vertex> turned_square(double side_px, int32_t texture_side) {
  const double c = std::cos(kTurn_degree * kPi / 180) * side_px;
  const double s = std::sin(kTurn_degree * kPi / 180) * side_px;
  const double middle = kTargetSide_px / 2.0 + 0.37;  // off the pixel grid
  const int32_t x0 = to_fx8(middle - (c - s) / 2), y0 = to_fx8(middle - (s + c) / 2);
  const int32_t cx = to_fx8(c), sx = to_fx8(s);
  const int32_t end = to_fx16(texture_side);
  return {{x0, y0, 0, 0, 1},
          {x0 + cx, y0 + sx, end, 0, 1},
          {x0 + cx - sx, y0 + sx + cx, end, end, 1},
          {x0 - sx, y0 + cx, 0, end, 1}};
}

Workload square(std::string id, std::string title, std::string description, double side_px,
                int32_t texture_side) {
  Workload w;
  w.id = std::move(id);
  w.title = std::move(title);
  w.description = std::move(description);
  w.texture_side_texel = texture_side;
  w.polygons = {turned_square(side_px, texture_side)};
  return w;
}

// A quad's map is one projective map when, over corners with distances w (q = 1/w), the sums of
// opposite corners agree: w0 + w2 = w1 + w3, and so for w x and w y. Here 12 + 6 = 8 + 10.
Workload tilted_quad() {
  constexpr std::array<int32_t, 4> w{12, 8, 6, 10};
  constexpr std::array<int32_t, 4> x_px{190, 880, 960, 100}, y_px{150, 95, 960, 680};
  static_assert(w[0] + w[2] == w[1] + w[3]);
  static_assert(w[0] * x_px[0] + w[2] * x_px[2] == w[1] * x_px[1] + w[3] * x_px[3]);
  static_assert(w[0] * y_px[0] + w[2] * y_px[2] == w[1] * y_px[1] + w[3] * y_px[3]);
  constexpr int32_t numerator = 120 << 19;  // a multiple of every w; q < 2^24
  static_assert(numerator / 6 <= SELVAGE_Q_MAX);
  constexpr int32_t x_off_fx8 = 83, y_off_fx8 = 39;  // off the pixel grid

  Workload load;
  load.id = "W4";
  load.title = "perspective quad, 256 x 256";
  load.description =
      "one quad tilted away about an oblique axis, q from 1 to 2 across it, a texture of "
      "256 x 256";
  load.perspective = true;
  const int32_t end = to_fx16(load.texture_side_texel);
  std::vector<selvage_vertex> quad;
  for (size_t i = 0; i < 4; ++i) {
    const bool right = i == 1 || i == 2, bottom = i >= 2;
    quad.push_back({x_px[i] * SELVAGE_SUBPIXELS + x_off_fx8,
                    y_px[i] * SELVAGE_SUBPIXELS + y_off_fx8, right ? end : 0, bottom ? end : 0,
                    numerator / w[i]});
  }
  load.polygons = {quad};
  return load;
}

constexpr int32_t kColumns = 40, kRows = 25;

// The vertices of the mesh, row by row: a grid whose inner vertices are moved by up to 0.3 cells,
// with the texture coordinates of the grid before it was moved.
std::vector<selvage_vertex> jittered_grid(uint64_t seed, int32_t texture_side) {
  constexpr int32_t low_fx8 = 20 * SELVAGE_SUBPIXELS + 31, high_fx8 = 1004 * SELVAGE_SUBPIXELS - 57;
  constexpr int32_t extent_fx8 = high_fx8 - low_fx8;
  std::mt19937_64 random(seed);
  const auto jitter_fx8 = [&](int32_t cell_fx8) {
    const int32_t reach = cell_fx8 * 3 / 10;
    return static_cast<int32_t>(random() % static_cast<uint64_t>(2 * reach + 1)) - reach;
  };
  std::vector<selvage_vertex> grid;
  for (int32_t j = 0; j <= kRows; ++j) {
    for (int32_t i = 0; i <= kColumns; ++i) {
      selvage_vertex vertex{low_fx8 + extent_fx8 * i / kColumns, low_fx8 + extent_fx8 * j / kRows,
                            static_cast<int32_t>(int64_t{to_fx16(texture_side)} * i / kColumns),
                            static_cast<int32_t>(int64_t{to_fx16(texture_side)} * j / kRows), 1};
      const bool inner = i > 0 && i < kColumns && j > 0 && j < kRows;
      if (inner) vertex.x += jitter_fx8(extent_fx8 / kColumns);
      if (inner) vertex.y += jitter_fx8(extent_fx8 / kRows);
      grid.push_back(vertex);
    }
  }
  return grid;
}

Workload mesh(uint64_t seed) {
  Workload load;
  load.id = "W3";
  load.title = "mesh of 2000 triangles, 256 x 256";
  load.description =
      "a jittered grid of 40 x 25 cells, two triangles a cell, about 480 px each, over most of the "
      "target; a texture of 256 x 256";
  const auto grid = jittered_grid(seed, load.texture_side_texel);
  for (int32_t j = 0; j < kRows; ++j) {
    for (int32_t i = 0; i < kColumns; ++i) {
      const size_t at = static_cast<size_t>(j * (kColumns + 1) + i);
      const size_t below = at + static_cast<size_t>(kColumns) + 1;
      load.polygons.push_back({grid[at], grid[at + 1], grid[below]});
      load.polygons.push_back({grid[at + 1], grid[below + 1], grid[below]});
    }
  }
  return load;
}

}  // namespace

std::vector<Workload> workloads(uint64_t seed) {
  const double half_of_target_px = kTargetSide_px * std::sqrt(0.5);
  return {
      square("W1", "rotated quad, 256 x 256",
             "one square turned by 23 degrees over half of the target, a texture of 256 x 256",
             half_of_target_px, 256),
      square("W1-2048", "rotated quad, 2048 x 2048",
             "the same square with a texture of 2048 x 2048 (16 MB)", half_of_target_px, 2048),
      square("W2", "minified 4 x, 2048 x 2048",
             "a square of 512 px turned by 23 degrees, four texels a pixel each way", 512, 2048),
      mesh(seed),
      tilted_quad(),
      square("W6", "quad of 10 x the target, 256 x 256",
             "a square of 10240 px turned by 23 degrees: all but the middle lies outside",
             10.0 * kTargetSide_px, 256)};
}

}  // namespace selvage::reports
