// The globe: what two faces share they share with its texture, so the map runs on without a seam.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "cli/png.h"
#include "cli/scene_file.h"
#include "scene/draw.h"
#include "spec/random.h"
#include "support.h"
#include "tests/scene/index_picture.h"
#include "tests/scene/plane_face.h"

namespace selvage::cli::test {
namespace {

using scene::ScreenFace;

constexpr const char* kScene = SELVAGE_SCENE_FILES "/globe/globe.json";
constexpr scene::Size kSize{160, 120};
constexpr double kRounding = 1e-6;  // far above that of the arithmetic in double here

[[nodiscard]] scene::Scene globe_seen_from(uint64_t seed, scene::Scene scene) {
  spec::Random random(seed);
  scene.objects[0].motion.axis = scene::direction(random);
  scene.objects[0].motion.angle_deg = scene::real(random, 0, 360);
  scene.camera.position = scene::Vector3(0, 0, scene::real(random, 2, 6));
  scene.camera.up = scene::Vector3(scene::real(random, -1, 1), 1, 0);
  return scene;
}

// (u, v) of a face's corner on the mapper's grid.
[[nodiscard]] std::array<int64_t, 2> grid_texture(const scene::Corner& corner) {
  selvage_vertex vertex;
  const scene::Vector2& at = corner.texture_texel;
  EXPECT_EQ(selvage_snap(0, 0, at.x(), at.y(), 1, 1, &vertex), SELVAGE_OK);
  return {vertex.u, vertex.v};
}

// Every edge is that of two faces, and at both ends v is the same in both, and u but for once
// around. As the mapper's map along an edge is that of its ends, it agrees all along.
void expect_shared_edges_agree(const scene::Scene& scene) {
  struct Side {
    std::array<int64_t, 2> from, to;
  };
  std::map<std::pair<size_t, size_t>, Side> sides;
  for (const scene::Face& face : scene.objects.at(0).faces) {
    for (size_t i = 0; i < face.corners.size(); ++i) {
      const scene::Corner &a = face.corners[i], &b = face.corners[(i + 1) % face.corners.size()];
      if (a.vertex == b.vertex) continue;  // at a pole
      const bool is_new =
          sides.emplace(std::pair(a.vertex, b.vertex), Side{grid_texture(a), grid_texture(b)})
              .second;
      EXPECT_TRUE(is_new) << a.vertex << ", " << b.vertex;
    }
  }
  EXPECT_GT(sides.size(), 1000U);
  const int64_t around = int64_t{scene.textures.at(0).width_texel} * SELVAGE_SUBTEXELS;
  int date_line = 0;
  for (const auto& [ends, side] : sides) {
    const auto other = sides.find({ends.second, ends.first});
    ASSERT_NE(other, sides.end()) << ends.first << ", " << ends.second;
    const Side& back = other->second;
    EXPECT_EQ(side.from[1], back.to[1]);
    EXPECT_EQ(side.to[1], back.from[1]);
    const int64_t shift = side.from[0] - back.to[0];
    EXPECT_EQ(shift % around, 0) << ends.first << ", " << ends.second;
    EXPECT_EQ(side.to[0] - back.from[0], shift) << ends.first << ", " << ends.second;
    date_line += shift != 0;
  }
  EXPECT_EQ(date_line, 2 * 13);  // a side each of 13 faces to the west and to the east
}

class Globe : public InDirectory {};

TEST_F(Globe, SharesTheTextureAlongEveryEdge) {
  expect_shared_edges_agree(read_scene(kScene));
  for (const int32_t width_texel : {64, 1000, 2048}) {
    put("other.png", encode_png(filled(width_texel, width_texel / 2, {})));
    expect_shared_edges_agree(read_scene(kScene, {{{"earth", "other.png"}}, {}}));
  }
}

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
  const scene::Scene globe = read_scene(kScene);
  for (uint64_t seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const scene::Scene scene = globe_seen_from(seed, globe);
    const scene::View view = look(scene, 0, kSize);
    const auto pieces = visible_pieces(scene::Hidden::kPainter, view.faces, kSize);
    const scene::IndexPicture picture = draw_indices(pieces, view.faces, kSize);
    const std::vector<Point> hull = hull_of(view.faces);
    int inside = 0;
    for (int32_t y = 0; y < kSize.height_px; ++y) {
      for (int32_t x = 0; x < kSize.width_px; ++x) {
        const double depth = depth_inside(hull, {x * 256 + 128, y * 256 + 128});
        if (std::abs(depth) <= 3) continue;
        const int writes = picture.writes[static_cast<size_t>(y * kSize.width_px + x)];
        EXPECT_EQ(writes, depth > 0 ? 1 : 0) << x << ", " << y;
        inside += depth > 0;
      }
    }
    EXPECT_GT(inside, 1500);
  }
}

// Where a row meets an outline: x in units of the grid, u and v in texels.
struct Meeting {
  double x, q, u, v;
};
struct RowSpan {
  Meeting left, right;
};

[[nodiscard]] RowSpan row_span(const ScreenFace& face, int32_t y_px) {
  const double y = y_px * 256 + 128;
  std::vector<Meeting> found;
  for (size_t i = 0; i < face.vertices.size(); ++i) {
    const selvage_vertex& a = face.vertices[i];
    const selvage_vertex& b = face.vertices[(i + 1) % face.vertices.size()];
    if ((a.y < y) == (b.y < y)) continue;
    const double t = (y - a.y) / (b.y - a.y);
    const double q = (1 - t) * a.q + t * b.q;
    const auto of = [&](double from, double to) {
      return ((1 - t) * from * a.q + t * to * b.q) / q / scene::kSubtexels;
    };
    found.push_back({(1 - t) * a.x + t * b.x, q, of(a.u, b.u), of(a.v, b.v)});
  }
  EXPECT_EQ(found.size(), 2U);
  if (found.size() != 2) return {};
  return found[0].x <= found[1].x ? RowSpan{found[0], found[1]} : RowSpan{found[1], found[0]};
}

// On a row of a face u = (qa a (1 - s) + qb b s) / (qa (1 - s) + qb s), so s from the end a
//   |u - a| = s qb |b - a| / (qa (1 - s) + qb s) <= s |b - a| max(qa, qb) / min(qa, qb).
struct Reach {
  double u, v;
};
[[nodiscard]] Reach reach(const Meeting& at, const Meeting& far, int32_t x_px) {
  const double s = std::abs((x_px * 256 + 128 - at.x) / (far.x - at.x));
  const double factor = s * std::max(at.q, far.q) / std::min(at.q, far.q);
  return {factor * std::abs(far.u - at.u), factor * std::abs(far.v - at.v)};
}

// The shorter way around.
[[nodiscard]] double apart(double a, double b, double around) {
  return std::abs(std::remainder(a - b, around));
}

// Texels that tell their own place.
void paint_places(scene::TextureImage& image) {
  for (int32_t t = 0; t < image.height_texel; ++t) {
    for (int32_t s = 0; s < image.width_texel; ++s) {
      uint8_t* texel = &image.rgba[static_cast<size_t>(t * image.width_texel + s) * 4];
      texel[0] = static_cast<uint8_t>(s & 0xff);
      texel[1] = static_cast<uint8_t>(s >> 8);
      texel[2] = static_cast<uint8_t>(t & 0xff);
      texel[3] = static_cast<uint8_t>(t >> 8);
    }
  }
}

struct Seams {
  int crossed = 0, at_date_line = 0, left_out = 0;
};

// Pixels side by side on two faces that share the edge between them: each is no farther from what
// is on the edge than its face's row allows, so the two are no farther apart than both together.
// Rounding down to texels adds less than one.
void expect_no_seam(const scene::Scene& scene, Seams& seams) {
  const scene::Drawing drawing =
      compose(scene, 0, kSize, {0, SELVAGE_FILTER_NEAREST}, scene::Hidden::kPainter);
  std::vector<uint8_t> pixels(static_cast<size_t>(kSize.width_px * kSize.height_px) * 4);
  ASSERT_EQ(
      draw(scene, drawing,
           {pixels.data(), kSize.width_px, kSize.height_px, kSize.width_px * 4, SELVAGE_RGBA8888}),
      SELVAGE_OK);
  const scene::IndexPicture index = draw_indices(drawing.pieces, drawing.view.faces, kSize);
  const double around = scene.textures[0].width_texel;
  for (int32_t y = 0; y < kSize.height_px; ++y) {
    for (int32_t x = 0; x + 1 < kSize.width_px; ++x) {
      const size_t at = static_cast<size_t>(y * kSize.width_px + x);
      const int a = index.face[at], b = index.face[at + 1];
      if (a == b || a < 0 || b < 0) continue;
      const RowSpan left = row_span(drawing.view.faces[static_cast<size_t>(a)], y);
      const RowSpan right = row_span(drawing.view.faces[static_cast<size_t>(b)], y);
      if (std::abs(left.right.x - right.left.x) > kRounding) {
        ++seams.left_out;  // a narrow face lies between
        continue;
      }
      EXPECT_LE(apart(left.right.u, right.left.u, around), kRounding) << x << ", " << y;
      EXPECT_LE(std::abs(left.right.v - right.left.v), kRounding) << x << ", " << y;
      const Reach from_a = reach(left.right, left.left, x);
      const Reach from_b = reach(right.left, right.right, x + 1);
      const uint8_t *p = &pixels[at * 4], *n = p + 4;
      const int u_a = p[0] + 256 * p[1], v_a = p[2] + 256 * p[3];
      const int u_b = n[0] + 256 * n[1], v_b = n[2] + 256 * n[3];
      EXPECT_LE(apart(u_a, u_b, around), from_a.u + from_b.u + 1 + kRounding) << x << ", " << y;
      EXPECT_LE(std::abs(v_a - v_b), from_a.v + from_b.v + 1 + kRounding) << x << ", " << y;
      ++seams.crossed;
      seams.at_date_line += std::abs(u_a - u_b) > around / 2;
    }
  }
}

TEST(GlobeTexels, RunOnAcrossEveryEdge) {
  scene::Scene globe = read_scene(kScene);
  paint_places(globe.textures.at(0));
  Seams seams;
  for (uint64_t seed = 1; seed <= 24; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    expect_no_seam(globe_seen_from(seed, globe), seams);
  }
  EXPECT_GT(seams.crossed, 10000);
  EXPECT_GT(seams.at_date_line, 100);
  EXPECT_LT(seams.left_out, seams.crossed / 4);
}

}  // namespace
}  // namespace selvage::cli::test
