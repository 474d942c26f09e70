#include "spec/fan.h"

#include <cstdlib>
#include <numeric>

#include "spec/geometry.h"
#include "spec/law_tools.h"

namespace selvage::spec {
namespace {

[[nodiscard]] bool is_counter_clockwise(const std::vector<selvage_vertex>& corners) {
  return doubled_area(position(corners[0]), position(corners[1]), position(corners[2])) < 0;
}

// Its inside, and what is in doubt.
void mark_tile(const Case& tile, const Capabilities& claims, std::vector<bool>* pixels) {
  size_t index = 0;
  for (int32_t y = 0; y < tile.target_height_px; ++y) {
    for (int32_t x = 0; x < tile.target_width_px; ++x, ++index) {
      if (winding_number(sample_point(tile, {x, y}), tile.vertices) != 0 ||
          is_in_doubt(claims.coverage_accuracy_fx16, tile, {x, y})) {
        (*pixels)[index] = true;
      }
    }
  }
}

}  // namespace

bool may_turn_over(const std::vector<selvage_vertex>& triangle, int32_t coverage_accuracy_fx16) {
  constexpr int64_t kFx16PerFx8 = SELVAGE_SUBTEXELS / SELVAGE_SUBPIXELS;
  if (coverage_accuracy_fx16 == 0) return false;
  const Point a = position(triangle[0]), b = position(triangle[1]), c = position(triangle[2]);
  const int64_t area = std::abs(doubled_area(a, b, c)) * kFx16PerFx8;
  const auto is_near = [&](Point from, Point to) {
    const int64_t steps_fx8 = std::abs(to.x - from.x) + std::abs(to.y - from.y);
    return area <= 2 * int64_t{coverage_accuracy_fx16} * steps_fx8;
  };
  return is_near(a, b) || is_near(b, c) || is_near(c, a);
}

Fan draw_fan(const Case& region, const selvage_vertex& centre, const Capabilities& claims,
             const DrawTile& draw_tile) {
  const size_t pixels =
      static_cast<size_t>(region.target_width_px) * static_cast<size_t>(region.target_height_px);
  Fan fan{std::vector<Times>(pixels), std::vector<bool>(pixels)};
  for (size_t k = 0; k < region.vertices.size(); ++k) {
    const selvage_vertex& a = region.vertices[k];
    const selvage_vertex& b = region.vertices[(k + 1) % region.vertices.size()];
    Case tile_case = with_vertices(claims, region, {centre, a, b});
    if (k % 2 == 1 && claims.outside_texels) take_other_texture_size(&tile_case);
    const bool is_reverse = is_counter_clockwise(tile_case.vertices);
    fan.runs_one_way = fan.runs_one_way && !is_reverse;
    make_visible(profile_of(region), claims, &tile_case.vertices);
    if (may_turn_over(tile_case.vertices, claims.coverage_accuracy_fx16)) {
      mark_tile(tile_case, claims, &fan.in_doubt);
    }
    const Picture tile = draw_tile(tile_case);
    for (size_t i = 0; i < fan.times.size(); ++i) {
      int& times = is_reverse ? fan.times[i].counter_clockwise : fan.times[i].clockwise;
      times += tile.pixels[i] ? 1 : 0;
    }
  }
  return fan;
}

selvage_vertex part_centre(const Case& region) {
  Choices choices(region.choice);
  (void)choices.pick(0, 2);  // the region's
  const auto count = static_cast<int32_t>(region.vertices.size());
  const selvage_vertex& a = region.vertices[static_cast<size_t>(choices.pick(0, count))];
  const selvage_vertex& b = region.vertices[static_cast<size_t>(choices.pick(0, count))];
  switch (choices.pick(0, 4)) {
    case 0:
      return a;
    case 1:
      return vertex_at(sample_point(region, choose_pixel(region, choices)), a);
    case 2:
      return vertex_at(
          {sample_point(region, choose_pixel(region, choices)).x + choices.pick(-128, 128),
           sample_point(region, choose_pixel(region, choices)).y + choices.pick(-128, 128)},
          a);
    default:
      return vertex_at({std::midpoint(a.x, b.x), std::midpoint(a.y, b.y)}, a);
  }
}

selvage_vertex pinwheel_centre(const Case& region, int32_t x_px, int32_t y_px) {
  return vertex_at(sample_point(region, {x_px, y_px}), region.vertices.front());
}

std::optional<selvage_vertex> fan_centre(std::string_view law, const Case& region, int32_t x_px,
                                         int32_t y_px) {
  if (x_px < 0 || region.vertices.empty()) return std::nullopt;
  if (law == "PART") return part_centre(region);
  if (law == "PINWHEEL") return pinwheel_centre(region, x_px, y_px);
  return std::nullopt;
}

}  // namespace selvage::spec
