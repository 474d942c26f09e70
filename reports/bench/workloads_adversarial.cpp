// Maps that make a mapper doubt at every pixel. Most cover the whole target with one triangle that
// reaches kFar_px = 32 766 px: a corner's coordinate changed by its least unit, 1/65536 texel,
// moves the coordinates in the target by as little as 2^-32 texel.
#include <algorithm>
#include <string>

#include "reports/bench/outlines.h"
#include "reports/bench/workloads.h"
#include "spec/vertex_units.h"

namespace selvage::reports {

namespace {

using spec::kTexel_fx16;

constexpr int32_t kTexture_texel = 2048;

// u = x + off and v = y + off, but lowered at the lower corner by `lowered` units: all samples of
// row j are lower by lowered 2^-31 (j + 1/2). With off = 1/2 the others would be whole.
Polygon upright(int32_t off_fx16, int32_t lowered) {
  constexpr int32_t far_fx16 = kFar_px * kTexel_fx16;
  return far_triangle({off_fx16, off_fx16 + far_fx16, off_fx16 - lowered},
                      {off_fx16, off_fx16, off_fx16 + far_fx16 - lowered});
}

// Sample (i + 1/2, j + 1/2) has u = (i + j + 1) / 3 + off and v = 512 + (j - i) / 3 + off: without
// off 5 of 9 samples have one of them on a boundary.
Polygon thirds(int32_t off_fx16) {
  static_assert(kFar_px % 3 == 0);
  constexpr int32_t far_fx16 = kFar_px / 3 * kTexel_fx16;
  const int32_t middle_fx16 = 512 * kTexel_fx16 + off_fx16;
  return far_triangle({off_fx16, off_fx16 + far_fx16, off_fx16 + far_fx16},
                      {middle_fx16, middle_fx16 - far_fx16, middle_fx16 + far_fx16});
}

// In perspective, q falling by half to either far corner, u the same at all samples: whole without
// off, which an approximation of a quotient never tells from a little less. v grows along the rows.
Polygon constant_in_depth(int32_t off_fx16) {
  const int32_t u_fx16 = 1024 * kTexel_fx16 + off_fx16;
  Polygon triangle =
      far_triangle({u_fx16, u_fx16, u_fx16}, {0, kFar_px * kTexel_fx16, 512 * kTexel_fx16});
  triangle[0].q = SELVAGE_Q_MAX;
  triangle[1].q = triangle[2].q = SELVAGE_Q_MAX / 2;
  return triangle;
}

// The same with v as u: nothing about a pixel is certain.
Polygon constant_point_in_depth(int32_t off_fx16) {
  Polygon triangle = constant_in_depth(off_fx16);
  for (selvage_vertex& vertex : triangle) vertex.v = vertex.u;
  return triangle;
}

// Near the origin, a corner's coordinates changed by their least unit move those of q's polygon by
// so little that n - k d has more than 64 bits.
Polygon points_at_the_tip(int32_t off_fx16) {
  Polygon triangle = constant_point_in_depth(off_fx16);
  for (selvage_vertex& vertex : triangle) vertex.v -= (1024 - 32) * kTexel_fx16;
  for (size_t far = 1; far < 3; ++far) {
    --triangle[far].u;
    --triangle[far].v;
  }
  return triangle;
}

struct TexturePoint {
  int32_t u_fx16, v_fx16;
};

// Strips of the target that reach down to bottom_px, `lowered` units lower at the lower corners
// than map(x_px, y_px): rows are short.
template <class Map>
std::vector<Polygon> strips(int32_t strip_px, int32_t bottom_px, int32_t lowered, const Map& map) {
  const auto corner = [&](int32_t x_px, int32_t y_px) {
    const TexturePoint point = map(x_px, y_px);
    const int32_t less_fx16 = y_px == 0 ? 0 : lowered;
    return selvage_vertex{x_px * SELVAGE_SUBPIXELS, y_px * SELVAGE_SUBPIXELS,
                          point.u_fx16 - less_fx16, point.v_fx16 - less_fx16, 1};
  };
  std::vector<Polygon> all;
  for (int32_t x_px = 0; x_px < kTargetSide_px; x_px += strip_px) {
    const int32_t right_px = x_px + strip_px;
    all.push_back({corner(x_px, 0), corner(right_px, 0), corner(right_px, bottom_px),
                   corner(x_px, bottom_px)});
  }
  return all;
}

// The map of upright().
std::vector<Polygon> upright_strips(int32_t off_fx16, int32_t lowered) {
  return strips(16, kFar_px, lowered, [&](int32_t x_px, int32_t y_px) {
    return TexturePoint{x_px * kTexel_fx16 + off_fx16, y_px * kTexel_fx16 + off_fx16};
  });
}

// Sample (i + 1/2, j + 1/2) has u = i + j + 1 + off and v = 1024 + j - i + off, but for what is
// lowered.
std::vector<Polygon> slanted_strips(int32_t off_fx16, int32_t lowered) {
  return strips(8, kFar_px - 2048, lowered, [&](int32_t x_px, int32_t y_px) {
    return TexturePoint{(x_px + y_px) * kTexel_fx16 + off_fx16,
                        (1024 + y_px - x_px) * kTexel_fx16 + off_fx16};
  });
}

// Two triangles in each cell, all on the point (1024, 1024) but for off, with u lowered by
// 1/65536 texel at the corners to the right and v at the lower ones.
std::vector<Polygon> points_in_cells(int32_t cell_px, int32_t off_fx16) {
  const int32_t point_fx16 = 1024 * kTexel_fx16 + off_fx16;
  std::vector<Polygon> triangles;
  for (int32_t y_px = 0; y_px < kTargetSide_px; y_px += cell_px) {
    for (int32_t x_px = 0; x_px < kTargetSide_px; x_px += cell_px) {
      const auto corner = [&](int32_t right, int32_t below) {
        return selvage_vertex{(x_px + right * cell_px) * SELVAGE_SUBPIXELS,
                              (y_px + below * cell_px) * SELVAGE_SUBPIXELS, point_fx16 - right,
                              point_fx16 - below, 1};
      };
      triangles.push_back({corner(0, 0), corner(1, 0), corner(0, 1)});
      triangles.push_back({corner(1, 0), corner(1, 1), corner(0, 1)});
    }
  }
  return triangles;
}

// Two triangles in each cell, in perspective, all on the point (1024, 1024) but for off: q falls by
// a sixteenth to the corners to the right.
std::vector<Polygon> points_in_deep_cells(int32_t cell_px, int32_t off_fx16) {
  std::vector<Polygon> triangles = points_in_cells(cell_px, off_fx16);
  const int32_t point_fx16 = 1024 * kTexel_fx16 + off_fx16;
  for (Polygon& triangle : triangles) {
    for (selvage_vertex& vertex : triangle) {
      const bool right = vertex.u != point_fx16;
      vertex.u = vertex.v = point_fx16;
      vertex.q = right ? SELVAGE_Q_MAX / 16 * 15 : SELVAGE_Q_MAX;
    }
  }
  return triangles;
}

// A quad in each cell, all on the point (1024, 1024) but for off, with u lowered by 1/65536 texel
// at one corner and v at two: in no plane.
std::vector<Polygon> points_in_quads(int32_t cell_px, int32_t off_fx16) {
  const int32_t point_fx16 = 1024 * kTexel_fx16 + off_fx16;
  std::vector<Polygon> quads;
  for (int32_t y_px = 0; y_px < kTargetSide_px; y_px += cell_px) {
    for (int32_t x_px = 0; x_px < kTargetSide_px; x_px += cell_px) {
      const auto corner = [&](int32_t right, int32_t below) {
        return selvage_vertex{(x_px + right * cell_px) * SELVAGE_SUBPIXELS,
                              (y_px + below * cell_px) * SELVAGE_SUBPIXELS,
                              point_fx16 - right * below, point_fx16 - below, 1};
      };
      quads.push_back({corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)});
    }
  }
  return quads;
}

// The same in perspective: q falls by a sixteenth to the corners to the right, to one of them by a
// unit more, which alone takes the quad off its plane.
std::vector<Polygon> points_in_deep_quads(int32_t cell_px, int32_t off_fx16) {
  std::vector<Polygon> quads = points_in_quads(cell_px, off_fx16);
  for (Polygon& quad : quads) {
    for (selvage_vertex& vertex : quad) vertex.u = vertex.v = 1024 * kTexel_fx16 + off_fx16;
    quad[0].q = quad[3].q = SELVAGE_Q_MAX;
    quad[1].q = SELVAGE_Q_MAX / 16 * 15;
    quad[2].q = quad[1].q - 1;
  }
  return quads;
}

// Two triangles in each cell, a sixteenth of a texel a pixel, in perspective that moves no sample
// by more than 2^-23 texel. Without off, every 16th sample of a row and of a column is as near to a
// boundary, of one texel after another.
std::vector<Polygon> magnified_cells(int32_t cell_px, int32_t off_fx16) {
  constexpr int32_t kStep_fx16 = kTexel_fx16 / 16;
  std::vector<Polygon> triangles;
  for (int32_t y_px = 0; y_px < kTargetSide_px; y_px += cell_px) {
    for (int32_t x_px = 0; x_px < kTargetSide_px; x_px += cell_px) {
      const auto corner = [&](int32_t right, int32_t below) {
        const int32_t right_px = x_px + right * cell_px, below_px = y_px + below * cell_px;
        const int32_t first_fx16 = kStep_fx16 / 2 + off_fx16;
        return selvage_vertex{right_px * SELVAGE_SUBPIXELS, below_px * SELVAGE_SUBPIXELS,
                              right_px * kStep_fx16 + first_fx16,
                              below_px * kStep_fx16 + first_fx16, SELVAGE_Q_MAX - right};
      };
      triangles.push_back({corner(0, 0), corner(1, 0), corner(0, 1)});
      triangles.push_back({corner(1, 0), corner(1, 1), corner(0, 1)});
    }
  }
  return triangles;
}

Workload item(const std::string& id, const std::string& title, const std::string& description,
              std::vector<Polygon> polygons) {
  Workload load;
  load.id = id;
  load.title = title;
  load.description = description;
  load.texture_side_texel = kTexture_texel;
  load.perspective = std::ranges::any_of(polygons.front(), [&](const selvage_vertex& vertex) {
    return vertex.q != polygons.front().front().q;
  });
  load.polygons = std::move(polygons);
  return load;
}

void add_pair(std::vector<Workload>& loads, const std::string& id, const std::string& title,
              const std::string& description, std::vector<Polygon> hard,
              std::vector<Polygon> ordinary) {
  const std::string twin = id + "-ordinary";
  loads.push_back(item(twin, title + ": its ordinary twin",
                       "the shape and slopes of " + id + ", its samples within the texels",
                       std::move(ordinary)));
  loads.push_back(item(id, title, description, std::move(hard)));
  loads.back().ordinary_id = twin;
}

}  // namespace

std::vector<Workload> adversarial_workloads() {
  constexpr int32_t half_fx16 = kTexel_fx16 / 2, sixth_fx16 = kTexel_fx16 / 6;
  std::vector<Workload> loads;
  add_pair(loads, "A1", "near-ties below",
           "an upright triangle, a texel a pixel, u and v of every sample 2^-32 to 2^-21 texel "
           "below a boundary",
           {upright(half_fx16, 1)}, {upright(0, 1)});
  add_pair(loads, "A2", "near-ties above",
           "the same, u and v of every sample 2^-32 to 2^-21 texel above a boundary",
           {upright(half_fx16, -1)}, {upright(0, -1)});
  add_pair(loads, "A3", "thirds",
           "a triangle at 45 degrees to its texture, a third of a texel a pixel: u or v of 5 "
           "samples in 9 is exactly on a boundary",
           {thirds(0)}, {thirds(sixth_fx16)});
  add_pair(loads, "A4", "ties in perspective",
           "a triangle in perspective, u of every sample exactly on one boundary, v growing along "
           "the rows",
           {constant_in_depth(0)}, {constant_in_depth(half_fx16)});
  add_pair(loads, "A5", "ties in perspective, twice",
           "the same with v as u: both of every sample exactly on a boundary",
           {constant_point_in_depth(0)}, {constant_point_in_depth(half_fx16)});
  add_pair(loads, "A6", "near-ties in short rows", "the map of A1 in strips 16 pixels wide",
           upright_strips(half_fx16, 1), upright_strips(0, 1));
  add_pair(loads, "A7", "near-ties in small triangles",
           "triangles of half a cell of 32 px, of one texel each, u and v of every sample 2^-22 to "
           "2^-16 texel below a boundary",
           points_in_cells(32, 0), points_in_cells(32, half_fx16));
  add_pair(loads, "A8", "near-ties in large triangles of a texel",
           "the same with one cell of 1024 px: 2^-27 to 2^-16 texel below a boundary",
           points_in_cells(1024, 0), points_in_cells(1024, half_fx16));
  add_pair(loads, "A9", "ties in perspective in small triangles",
           "triangles of half a cell of 64 px, in perspective, of one texel each, u and v of every "
           "sample exactly on a boundary",
           points_in_deep_cells(64, 0), points_in_deep_cells(64, half_fx16));
  add_pair(loads, "A10", "near-ties in small magnified triangles",
           "triangles of half a cell of 64 px, a sixteenth of a texel a pixel, slightly in "
           "perspective, every 16th sample of a row and of a column next to a boundary, another "
           "one each time",
           magnified_cells(64, 0), magnified_cells(64, kTexel_fx16 / 32));
  add_pair(
      loads, "A11", "near-ties at the tip of a huge triangle in perspective",
      "64 x 64 pixels at the corner of a triangle of 32 766 px, of one texel, u and v of every "
      "sample 2^-32 to 2^-25 texel below a boundary",
      {points_at_the_tip(0)}, {points_at_the_tip(half_fx16)});
  for (size_t i = loads.size() - 2; i < loads.size(); ++i) loads[i].target_side_px = 64;
  add_pair(loads, "A12", "near-ties in narrow rows",
           "strips 8 pixels wide at 45 degrees to their texture, 1.4 texels a pixel, u and v of "
           "every sample 2^-32 to 2^-20 texel below a boundary",
           slanted_strips(0, 1), slanted_strips(half_fx16, 1));
  add_pair(loads, "A13", "near-ties in quads in no plane",
           "quads of 64 px, of one texel each, whose rows have each a map of their own, u and v of "
           "every sample 2^-23 to 2^-16 texel below a boundary",
           points_in_quads(64, 0), points_in_quads(64, half_fx16));
  add_pair(loads, "A14", "ties in perspective in quads in no plane",
           "the like of A13 in perspective, u and v of every sample exactly on a boundary",
           points_in_deep_quads(64, 0), points_in_deep_quads(64, half_fx16));
  return loads;
}

}  // namespace selvage::reports
