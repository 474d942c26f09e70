// The globe's disk: no pixel of it is left out, none is drawn twice.
#include <algorithm>
#include <cmath>
#include <vector>

#include "globe_views.h"

namespace selvage::cli::test {
namespace {

using scene::ScreenFace;

struct Point {
  int64_t x, y;
};

[[nodiscard]] int64_t cross(const Point& a, const Point& b, const Point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Andrew's monotone chain.
[[nodiscard]] std::vector<Point> hull_of(const std::vector<ScreenFace>& faces) {
  std::vector<Point> points;
  for (const ScreenFace& face : faces) {
    for (const selvage_vertex& vertex : face.vertices) points.push_back({vertex.x, vertex.y});
  }
  const auto before = [](const Point& a, const Point& b) {
    return std::pair(a.x, a.y) < std::pair(b.x, b.y);
  };
  std::sort(points.begin(), points.end(), before);
  std::vector<Point> hull;
  for (int chain = 0; chain < 2; ++chain) {
    const size_t start = hull.size();
    for (const Point& point : points) {
      while (hull.size() >= start + 2 && cross(hull[hull.size() - 2], hull.back(), point) <= 0) {
        hull.pop_back();
      }
      hull.push_back(point);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

// How far inside of the hull, in units of the grid; negative outside.
[[nodiscard]] double depth_inside(const std::vector<Point>& hull, const Point& point) {
  double least = 1e9;
  for (size_t i = 0; i < hull.size(); ++i) {
    const Point &a = hull[i], &b = hull[(i + 1) % hull.size()];
    const double length =
        std::hypot(static_cast<double>(b.x - a.x), static_cast<double>(b.y - a.y));
    least = std::min(least, static_cast<double>(cross(a, b, point)) / length);
  }
  return least;
}

// Faces drawn whole, in any order: what is left out shows as 0, what overlaps as 2. The globe is
// convex, so its disk is the hull of its corners. Snapping moves each by less than 0.71 of a unit:
// the outline drawn, and a face that vanished at it, are within 3 units of the hull's.
TEST(GlobeDisk, IsDrawnOnceEverywhere) {
  const scene::Scene globe = read_globe();
  for (uint64_t seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const scene::Scene scene = globe_seen_from(seed, globe);
    const scene::View view = look(scene, 0, kGlobeSize);
    const auto pieces = visible_pieces(scene::Hidden::kPainter, view.faces, kGlobeSize);
    const scene::IndexPicture picture = draw_indices(pieces, view.faces, kGlobeSize);
    const std::vector<Point> hull = hull_of(view.faces);
    int inside = 0;
    for (int32_t y = 0; y < kGlobeSize.height_px; ++y) {
      for (int32_t x = 0; x < kGlobeSize.width_px; ++x) {
        const double depth = depth_inside(hull, {x * 256 + 128, y * 256 + 128});
        if (std::abs(depth) <= 3) continue;
        const int writes = picture.writes[static_cast<size_t>(y * kGlobeSize.width_px + x)];
        EXPECT_EQ(writes, depth > 0 ? 1 : 0) << x << ", " << y;
        inside += depth > 0;
      }
    }
    EXPECT_GT(inside, 1500);
  }
}

}  // namespace
}  // namespace selvage::cli::test
