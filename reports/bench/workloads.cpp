#include "reports/bench/workloads.h"

#include <array>
#include <cmath>
#include <random>

#include "reports/bench/outlines.h"

namespace selvage::reports {

namespace {

constexpr double kMiddle_px = kTargetSide_px / 2.0 + 0.37;  // off the pixel grid

Workload square(std::string id, std::string title, std::string description, double side_px,
                int32_t texture_side) {
  Workload w;
  w.id = std::move(id);
  w.title = std::move(title);
  w.description = std::move(description);
  w.texture_side_texel = texture_side;
  w.polygons = {turned_square(kMiddle_px, kMiddle_px, side_px, texture_side)};
  return w;
}

Workload mesh(std::string id, int32_t columns, int32_t rows, const std::string& triangles,
              const std::string& size, uint64_t seed, MeshDepth depth) {
  Workload load;
  load.id = std::move(id);
  load.perspective = depth == MeshDepth::kTilted;
  load.title = std::string(load.perspective ? "perspective mesh" : "mesh") + " of " + triangles +
               " triangles, 256 x 256";
  load.description =
      "a jittered grid of " + std::to_string(columns) + " x " + std::to_string(rows) +
      " cells, two triangles a cell, about " + size + " px each, over most of the target" +
      (load.perspective ? ", q from 1 to 2 across it" : "") + "; a texture of 256 x 256";
  load.polygons =
      jittered_mesh(columns, rows, kTargetSide_px, load.texture_side_texel, seed, depth);
  return load;
}

// A quad's map is one projective map when, over corners with distances w (q = 1/w), the sums of
// opposite corners agree: w0 + w2 = w1 + w3, and so for w x and w y. Here 12 + 6 = 8 + 10.
Workload tilted_quad(int32_t texture_side_texel) {
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
  const std::string side = std::to_string(texture_side_texel);
  load.title = "perspective quad, " + side + " x " + side;
  load.description =
      "one quad tilted away about an oblique axis, q from 1 to 2 across it, a texture of " + side +
      " x " + side;
  load.texture_side_texel = texture_side_texel;
  load.perspective = true;
  const int32_t end = texel_to_fx16(load.texture_side_texel);
  Polygon quad;
  for (size_t i = 0; i < 4; ++i) {
    const bool right = i == 1 || i == 2, bottom = i >= 2;
    quad.push_back({x_px[i] * SELVAGE_SUBPIXELS + x_off_fx8,
                    y_px[i] * SELVAGE_SUBPIXELS + y_off_fx8, right ? end : 0, bottom ? end : 0,
                    numerator / w[i]});
  }
  load.polygons = {quad};
  return load;
}

// W4 as a scene has it: a plane in space between fractions of the grid, of which the corners and
// their q are rounded, each by itself. No one projective map is left for all of it.
Workload rounded_quad() {
  constexpr std::array<double, 4> w{12.1, 8.07, 6.03, 10.06};
  std::array<double, 4> x_px{190.33, 880.2, 0, 100.7}, y_px{150.15, 95.4, 0, 680.9};
  const auto opposite = [&](const std::array<double, 4>& at) {
    return (w[1] * at[1] + w[3] * at[3] - w[0] * at[0]) / w[2];
  };
  x_px[2] = opposite(x_px);
  y_px[2] = opposite(y_px);
  Workload load = tilted_quad(256);
  load.id = "W4-rounded";
  load.title += ", rounded";
  load.description =
      "the like of W4, its corners and their q rounded to the grid each by itself, so that it lies "
      "in no plane";
  for (size_t i = 0; i < 4; ++i) {
    selvage_vertex& corner = load.polygons[0][i];
    corner.x = px_to_fx8(x_px[i]);
    corner.y = px_to_fx8(y_px[i]);
    corner.q = static_cast<int32_t>(std::lround((1 << 23) * w[2] / w[i]));
  }
  return load;
}

// Parts of the texture as large as the squares are, a texel a pixel, turned by any angle.
Workload small_squares(uint64_t seed) {
  constexpr int32_t kAcross = 24, kSide_px = 28;
  constexpr double kPitch_px = static_cast<double>(kTargetSide_px) / kAcross;
  Workload load;
  load.id = "W9";
  load.title = "576 small squares, 256 x 256";
  load.description =
      "squares of 28 px, turned by any angle, with as many texels of a texture of 256 x 256, their "
      "corners rounded to the grid each by itself, so that half of them lie in no plane";
  std::mt19937_64 random(seed);
  const auto any = [&](double end) { return static_cast<double>(random() >> 11) * 0x1p-53 * end; };
  for (int32_t i = 0; i < kAcross * kAcross; ++i) {
    const double x_px = (i % kAcross + 0.5) * kPitch_px + any(1);
    const double y_px = (i / kAcross + 0.5) * kPitch_px + any(1);
    const double turn = any(6.28318530717958647692);
    const double c = std::cos(turn) * kSide_px / 2, s = std::sin(turn) * kSide_px / 2;
    const int32_t u = texel_to_fx16(std::floor(any(256 - kSide_px)));
    const int32_t v = texel_to_fx16(std::floor(any(256 - kSide_px)));
    const int32_t side_fx16 = texel_to_fx16(kSide_px);
    load.polygons.push_back(
        {{px_to_fx8(x_px - c + s), px_to_fx8(y_px - s - c), u, v, 1},
         {px_to_fx8(x_px + c + s), px_to_fx8(y_px + s - c), u + side_fx16, v, 1},
         {px_to_fx8(x_px + c - s), px_to_fx8(y_px + s + c), u + side_fx16, v + side_fx16, 1},
         {px_to_fx8(x_px - c - s), px_to_fx8(y_px - s + c), u, v + side_fx16, 1}});
  }
  return load;
}

Workload bilinear_square() {
  Workload load = half_covering_square(256);
  load.id = "W5";
  load.title = "bilinear, rotated quad, 256 x 256";
  load.description = "the square of W1, filtered bilinearly; the texture is noise";
  load.filter = kBilinear;
  return load;
}

Workload by_area(Workload load, std::string id) {
  load.id = std::move(id);
  load.title = "area, " + load.title;
  load.description += ", filtered by area; the texture is noise";
  load.filter = kArea;
  return load;
}

}  // namespace

Workload half_covering_square(int32_t texture_side_texel) {
  const std::string side = std::to_string(texture_side_texel);
  return square("W1", "rotated quad, " + side + " x " + side,
                "one square turned by 23 degrees over half of the target, a texture of " + side +
                    " x " + side,
                kTargetSide_px * std::sqrt(0.5), texture_side_texel);
}

std::vector<Workload> workloads(uint64_t seed) {
  Workload large = half_covering_square(2048);
  large.id = "W1-2048";
  large.description = "the same square with a texture of 2048 x 2048 (16 MB)";
  const Workload minified =
      square("W2", "minified 4 x, 2048 x 2048",
             "a square of 512 px turned by 23 degrees, four texels a pixel each way", 512, 2048);
  return {half_covering_square(256),
          large,
          minified,
          mesh("W3", 40, 25, "2 000", "460", seed, MeshDepth::kFlat),
          mesh("W3-20000", 100, 100, "20 000", "48", seed, MeshDepth::kFlat),
          tilted_quad(256),
          mesh("W4-2000", 40, 25, "2 000", "460", seed, MeshDepth::kTilted),
          mesh("W4-20000", 100, 100, "20 000", "48", seed, MeshDepth::kTilted),
          rounded_quad(),
          bilinear_square(),
          square("W6", "quad of 10 x the target, 256 x 256",
                 "a square of 10240 px turned by 23 degrees: all but the middle lies outside",
                 10.0 * kTargetSide_px, 256),
          by_area(minified, "W7"),
          by_area(tilted_quad(2048), "W8"),
          small_squares(seed)};
}

}  // namespace selvage::reports
