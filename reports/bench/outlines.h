// Shapes of the workloads, on the grid of vertices.
#pragma once

#include <cstdint>
#include <vector>

#include "selvage.h"

namespace selvage::reports {

using Polygon = std::vector<selvage_vertex>;

inline constexpr double kTurn_degree = 23;

// Round to the nearest unit of the grid.
[[nodiscard]] int32_t px_to_fx8(double px);
[[nodiscard]] int32_t texel_to_fx16(double texel);

// A square turned by 23 degrees, `texels` of the texture along each of its sides. The fourth corner
// is the sum of its neighbours less the first, so that the snapped map is affine without an error.
[[nodiscard]] Polygon turned_square(double middle_x_px, double middle_y_px, double side_px,
                                    double texels);

// The triangle that covers the target from its top left pixel on, with an affine map given by
// u and v, in units of 1/65536 texel, at (0, 0), (kFar_px, 0) and (0, kFar_px).
inline constexpr int32_t kFar_px = 32766;
struct CornerMap {
  int32_t origin_fx16, right_fx16, below_fx16;
};
[[nodiscard]] Polygon far_triangle(const CornerMap& u, const CornerMap& v);

// Two triangles for each cell of a jittered grid over most of the target: its inner vertices are
// moved by up to 0.3 cells, the texture coordinates stay those of the grid before that.
// Tilted, it lies on one plane in space: q goes from 2^20 to 2^21 over the target, half as fast to
// the right as down.
enum class MeshDepth { kFlat, kTilted };
[[nodiscard]] std::vector<Polygon> jittered_mesh(int32_t columns, int32_t rows, int32_t target_px,
                                                 int32_t texture_side_texel, uint64_t seed,
                                                 MeshDepth depth = MeshDepth::kFlat);

}  // namespace selvage::reports
