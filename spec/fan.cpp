#include "spec/fan.h"

#include <numeric>

#include "spec/geometry.h"
#include "spec/law_tools.h"

namespace selvage::spec {
namespace {

[[nodiscard]] bool is_counter_clockwise(const std::vector<selvage_vertex>& corners) {
  return doubled_area(position(corners[0]), position(corners[1]), position(corners[2])) < 0;
}

}  // namespace

Fan draw_fan(const Case& region, const selvage_vertex& centre, const Capabilities& claims,
             const DrawTile& draw_tile) {
  Fan fan{std::vector<Times>(static_cast<size_t>(region.target_width_px) *
                             static_cast<size_t>(region.target_height_px))};
  for (size_t k = 0; k < region.vertices.size(); ++k) {
    const selvage_vertex& a = region.vertices[k];
    const selvage_vertex& b = region.vertices[(k + 1) % region.vertices.size()];
    Case tile_case = with_vertices(claims, region, {centre, a, b});
    const bool is_reverse = is_counter_clockwise(tile_case.vertices);
    fan.runs_one_way = fan.runs_one_way && !is_reverse;
    make_visible(profile_of(region), claims, &tile_case.vertices);
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
