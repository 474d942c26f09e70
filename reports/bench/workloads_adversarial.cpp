// Maps that make a mapper doubt at every pixel. All cover the whole target with one triangle that
// reaches kFar_px = 30 000 px: a corner's coordinate changed by its least unit, 1/65536 texel,
// moves the coordinates in the target by as little as 2^-31 texel.
#include <string>

#include "reports/bench/outlines.h"
#include "reports/bench/workloads.h"

namespace selvage::reports {

namespace {

constexpr int32_t kTexel_fx16 = SELVAGE_SUBTEXELS;
constexpr int32_t kTexture_texel = 2048;

// One texel along u for each `along` px to the right and down, v the same to the left and down.
// Sample (i + 1/2, j + 1/2) has u = (i + j + 1) / along + off, and v = (j - i) / along + off + a
// whole number.
// With off = 0 that is whole at each along-th sample; corners lowered by `lowered` units put all
// samples below by lowered 2^-16 (x + y) / 30 000 texel: 2^-31 at the first, 2^-20 at the last.
Polygon diagonal(int32_t along, int32_t off_fx16, int32_t lowered) {
  constexpr int32_t reach_fx16 = kFar_px * kTexel_fx16;
  static_assert(kFar_px % 3 == 0);
  const int32_t far_fx16 = reach_fx16 / along;
  const int32_t middle_fx16 = (along == 1 ? 1024 : 512) * kTexel_fx16 + off_fx16;
  return far_triangle(
      {off_fx16, off_fx16 + far_fx16 - lowered, off_fx16 + far_fx16 - lowered},
      {middle_fx16, middle_fx16 - far_fx16 - lowered, middle_fx16 + far_fx16 - lowered});
}

// u = x and v = 1024 - x, off aside, but for q, which is less at the lower corner by one part in
// 2^24: that moves u up, and v down, by x y / 30 000 / 2^24 texel, 2^-41 to 2^-19.
Polygon upright_in_depth(int32_t off_fx16) {
  constexpr int32_t far_fx16 = kFar_px * kTexel_fx16, half_fx16 = kTexel_fx16 / 2;
  const int32_t u_fx16 = half_fx16 + off_fx16, v_fx16 = 1024 * kTexel_fx16 + half_fx16 + off_fx16;
  Polygon triangle =
      far_triangle({u_fx16, u_fx16 + far_fx16, u_fx16}, {v_fx16, v_fx16 - far_fx16, v_fx16});
  for (selvage_vertex& vertex : triangle) vertex.q = SELVAGE_Q_MAX;
  triangle[2].q = SELVAGE_Q_MAX - 1;
  return triangle;
}

Workload item(const std::string& id, const std::string& title, const std::string& description,
              Polygon polygon) {
  Workload load;
  load.id = id;
  load.title = title;
  load.description = description;
  load.texture_side_texel = kTexture_texel;
  load.perspective = polygon.front().q != polygon.back().q;
  load.polygons = {std::move(polygon)};
  return load;
}

void add_pair(std::vector<Workload>& loads, const std::string& id, const std::string& title,
              const std::string& description, Polygon hard, Polygon ordinary) {
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
           "a triangle at 45 degrees to its texture, u and v of every sample 2^-31 to 2^-20 texel "
           "below a boundary",
           diagonal(1, 0, 1), diagonal(1, half_fx16, 1));
  add_pair(loads, "A2", "near-ties above",
           "the same, u and v of every sample 2^-31 to 2^-20 texel above a boundary",
           diagonal(1, 0, -1), diagonal(1, half_fx16, -1));
  add_pair(loads, "A3", "thirds",
           "a triangle at 45 degrees to its texture, a third of a texel a pixel: each third sample "
           "is exactly on a boundary",
           diagonal(3, 0, 0), diagonal(3, sixth_fx16, 0));
  add_pair(loads, "A4", "near-ties in perspective",
           "a triangle in perspective of one part in 2^24, u of every sample 2^-41 to 2^-19 texel "
           "above a boundary and v as much below one",
           upright_in_depth(0), upright_in_depth(half_fx16));
  return loads;
}

}  // namespace selvage::reports
