#include "spec/sample_place.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

#include "spec/model.h"
#include "spec/profiles.h"

namespace selvage::spec {
namespace {

inline constexpr double kSubpixels = static_cast<double>(SELVAGE_SUBPIXELS);
// Of a distance below it only a mapper that rounds positions takes notice.
inline constexpr double kNear_px = 1.0 / kSubpixels;

[[nodiscard]] bool is_within(int64_t value, int64_t one, int64_t other) {
  return std::min(one, other) <= value && value <= std::max(one, other);
}

// Along the row to the edge, along the column to a horizontal one; empty where it is not met.
[[nodiscard]] std::optional<double> distance_px(Point p, Point a, Point b) {
  const bool is_level = a.y == b.y;
  if (is_level ? !is_within(p.x, a.x, b.x) : !is_within(p.y, a.y, b.y)) return std::nullopt;
  const double fx8 =
      is_level ? static_cast<double>(p.y - a.y)
               : static_cast<double>(doubled_area(a, b, p)) / static_cast<double>(b.y - a.y);
  return std::abs(fx8) / kSubpixels;
}

// The vertex or edge that it lies on, or else the edge next to it; empty where none is near.
[[nodiscard]] std::string describe_nearest(Point p, const std::vector<selvage_vertex>& vertices) {
  std::pair<double, std::string> nearest{kNear_px, ""};
  for (size_t i = 0; i < vertices.size(); ++i) {
    const Point a = position(vertices[i]), b = position(vertices[(i + 1) % vertices.size()]);
    if (a == p) return "on the vertex " + describe_px(a);
    const std::optional<double> distance = distance_px(p, a, b);
    if (!distance || *distance >= nearest.first) continue;
    std::ostringstream beside;
    beside << std::setprecision(2) << *distance << " px beside";
    nearest = {*distance, (*distance > 0 ? beside.str() : "on") + " the edge from " +
                              describe_px(a) + " to " + describe_px(b)};
  }
  return nearest.second;
}

[[nodiscard]] bool is_in_clip(const selvage_rect& clip, int32_t x_px, int32_t y_px) {
  return clip.left <= x_px && x_px < clip.right && clip.top <= y_px && y_px < clip.bottom;
}

}  // namespace

// 13 digits tell any position of the grid.
std::string describe_px(Point p) {
  std::ostringstream text;
  text << std::setprecision(13) << '(' << static_cast<double>(p.x) / kSubpixels << ", "
       << static_cast<double>(p.y) / kSubpixels << ')';
  return text.str();
}

std::string describe_sample(const Case& shown, int32_t x_px, int32_t y_px) {
  const Point p = sample_point(profile_of(shown), x_px, y_px);
  const bool is_in = is_valid(shown) ? ModelRow(shown, y_px).coordinates(x_px).has_value()
                                     : winding_number(p, shown.vertices) != 0;
  std::string told = describe_px(p) + " px, " + (is_in ? "in the polygon" : "not in the polygon");
  const std::string nearest = describe_nearest(p, shown.vertices);
  if (!nearest.empty()) told += ": " + nearest;
  if (shown.profile == SELVAGE_PROFILE_EXACT && on_outline(p, shown.vertices)) {
    told += " (left and top edges are in it, others are not)";
  }
  if (shown.has_clip && !is_in_clip(shown.clip, x_px, y_px)) told += "; outside of the clip";
  return told;
}

}  // namespace selvage::spec
