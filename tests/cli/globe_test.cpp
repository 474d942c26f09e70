// The globe: what two faces share they share with its texture, so the map runs on without a seam.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "cli/png.h"
#include "globe_views.h"
#include "support.h"

namespace selvage::cli::test {
namespace {

using scene::ScreenFace;

constexpr double kRounding = 1e-6;  // far above that of the arithmetic in double here

// (u, v) of a face's corner on the mapper's grid.
[[nodiscard]] std::array<int64_t, 2> grid_texture(const scene::Corner& corner) {
  selvage_vertex vertex;
  const scene::Vector2& at = corner.texture_texel;
  EXPECT_EQ(selvage_snap(0, 0, at.x(), at.y(), 1, 1, &vertex), SELVAGE_OK);
  return {vertex.u, vertex.v};
}

using Sides = std::map<std::pair<size_t, size_t>, std::array<std::array<int64_t, 2>, 2>>;

// The texture at both ends of each side of each face, by the two vertices.
[[nodiscard]] Sides sides_of(const scene::Object& globe) {
  Sides sides;
  for (const scene::Face& face : globe.faces) {
    for (size_t i = 0; i < face.corners.size(); ++i) {
      const scene::Corner &a = face.corners[i], &b = face.corners[(i + 1) % face.corners.size()];
      if (a.vertex == b.vertex) continue;  // at a pole
      const bool is_new =
          sides.emplace(std::pair(a.vertex, b.vertex), std::array{grid_texture(a), grid_texture(b)})
              .second;
      EXPECT_TRUE(is_new) << a.vertex << ", " << b.vertex;
    }
  }
  return sides;
}

// Every edge is that of two faces, and at both ends v is the same in both, and u but for once
// around. As the mapper's map along an edge is that of its ends, it agrees all along.
struct SharedEdges {
  int agree = 0, at_date_line = 0, differ = 0;
};
[[nodiscard]] SharedEdges shared_edges(const scene::Scene& scene) {
  const int64_t around = int64_t{scene.textures.at(0).width_texel} * SELVAGE_SUBTEXELS;
  const Sides sides = sides_of(scene.objects.at(0));
  SharedEdges edges;
  for (const auto& [ends, side] : sides) {
    const auto other = sides.find({ends.second, ends.first});
    if (other == sides.end()) {
      ++edges.differ;
      continue;
    }
    const auto& [back_from, back_to] = other->second;
    const int64_t shift = side[0][0] - back_to[0];
    const bool agrees = side[0][1] == back_to[1] && side[1][1] == back_from[1] &&
                        shift % around == 0 && side[1][0] - back_from[0] == shift;
    ++(agrees ? edges.agree : edges.differ);
    edges.at_date_line += agrees && shift != 0;
  }
  return edges;
}

void expect_shared_edges_agree(const scene::Scene& scene) {
  const SharedEdges edges = shared_edges(scene);
  EXPECT_EQ(edges.differ, 0);
  EXPECT_GT(edges.agree, 1000);
  EXPECT_EQ(edges.at_date_line, 2 * 13);  // a side each of 13 faces to the west and to the east
}

class Globe : public InDirectory {};

TEST_F(Globe, SharesTheTextureAlongEveryEdge) {
  expect_shared_edges_agree(read_globe());
  for (const int32_t width_texel : {64, 1000, 2048}) {
    put("other.png", encode_png(filled(width_texel, width_texel / 2, {})));
    expect_shared_edges_agree(read_globe("other.png"));
  }
}

// A corner of one face that is off by the least that the grid tells: both laws notice.
TEST_F(Globe, IsNoGlobeWithOneCornerMoved) {
  const scene::Scene globe = read_globe();
  for (const size_t face : {size_t{0}, size_t{30}, size_t{150}, size_t{311}}) {
    for (const scene::Vector2& step : {scene::Vector2(1, 0), scene::Vector2(0, -1)}) {
      scene::Scene moved = globe;
      moved.objects[0].faces[face].corners[1].texture_texel += step / scene::kSubtexels;
      EXPECT_GT(shared_edges(moved).differ, 0) << face;
    }
  }
  scene::Scene torn = globe;  // a vertex of its own, where the other was
  torn.objects[0].vertices.push_back(torn.objects[0].vertices[5]);
  for (scene::Corner& corner : torn.objects[0].faces[40].corners) {
    if (corner.vertex == torn.objects[0].faces[40].corners[0].vertex) {
      corner.vertex = torn.objects[0].vertices.size() - 1;
    }
  }
  EXPECT_GT(shared_edges(torn).differ, 0);
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

struct Seams {
  int crossed = 0, at_date_line = 0, left_out = 0;
  int torn = 0;     // the faces' maps differ on the edge between them
  int too_far = 0;  // texels are farther apart than the faces' maps allow
};

// Pixels side by side on two faces that share the edge between them: each is no farther from what
// is on the edge than its face's row allows, so the two are no farther apart than both together.
// Rounding down to texels adds less than one.
void look_across(const GlobePicture& picture, int32_t x, int32_t y, double around, Seams& seams) {
  const int a = picture.index.face[GlobePicture::at(x, y)];
  const int b = picture.index.face[GlobePicture::at(x + 1, y)];
  if (a == b || a < 0 || b < 0) return;
  const std::vector<ScreenFace>& faces = picture.drawing.view.faces;
  const RowSpan left = row_span(faces[static_cast<size_t>(a)], y);
  const RowSpan right = row_span(faces[static_cast<size_t>(b)], y);
  if (std::abs(left.right.x - right.left.x) > kRounding) {
    ++seams.left_out;  // a narrow face lies between
    return;
  }
  seams.torn += apart(left.right.u, right.left.u, around) > kRounding ||
                std::abs(left.right.v - right.left.v) > kRounding;
  const Reach from_a = reach(left.right, left.left, x);
  const Reach from_b = reach(right.left, right.right, x + 1);
  const GlobePicture::Texel p = picture.texel(x, y), n = picture.texel(x + 1, y);
  seams.too_far += apart(p.u, n.u, around) > from_a.u + from_b.u + 1 + kRounding ||
                   std::abs(p.v - n.v) > from_a.v + from_b.v + 1 + kRounding;
  ++seams.crossed;
  seams.at_date_line += std::abs(p.u - n.u) > around / 2;
}

[[nodiscard]] Seams seams_of(const scene::Scene& globe) {
  Seams seams;
  for (uint64_t seed = 1; seed <= 24; ++seed) {
    const GlobePicture picture(globe_seen_from(seed, globe));
    for (int32_t y = 0; y < kGlobeSize.height_px; ++y) {
      for (int32_t x = 0; x + 1 < kGlobeSize.width_px; ++x) {
        look_across(picture, x, y, globe.textures[0].width_texel, seams);
      }
    }
  }
  return seams;
}

TEST(GlobeTexels, RunOnAcrossEveryEdge) {
  scene::Scene globe = read_globe();
  paint_places(globe.textures.at(0));
  const Seams seams = seams_of(globe);
  EXPECT_EQ(seams.torn, 0);
  EXPECT_EQ(seams.too_far, 0);
  EXPECT_GT(seams.crossed, 10000);
  EXPECT_GT(seams.at_date_line, 100);
  EXPECT_LT(seams.left_out, seams.crossed / 4);
}

TEST(GlobeTexels, DoNotRunOnWhereACornerIsMoved) {
  scene::Scene globe = read_globe();
  paint_places(globe.textures.at(0));
  globe.objects[0].faces[150].corners[2].texture_texel.x() += 1 / scene::kSubtexels;
  EXPECT_GT(seams_of(globe).torn, 10);  // told by the map
  const scene::Scene sound = read_globe();
  globe.objects[0].faces[150] = sound.objects[0].faces[150];
  EXPECT_EQ(seams_of(globe).torn, 0);
}

// Texels tell by themselves what the vertices do not: faces drawn a little beside their place.
TEST(GlobeTexels, DoNotRunOnWhereTheTextureIsTorn) {
  scene::Scene globe = read_globe();
  paint_places(globe.textures.at(0));
  scene::TextureImage& image = globe.textures[0];
  for (size_t i = 1; i < image.rgba.size(); i += 4) {  // half of it is 64 texels farther
    const int u = image.rgba[i - 1] + 256 * image.rgba[i];
    if (u < image.width_texel / 2) continue;
    image.rgba[i - 1] = static_cast<uint8_t>(u + 64);
    image.rgba[i] = static_cast<uint8_t>((u + 64) >> 8);
  }
  EXPECT_GT(seams_of(globe).too_far, 100);
}

}  // namespace
}  // namespace selvage::cli::test
