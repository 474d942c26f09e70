// The globe's map does not stay in its place inside of the faces as it turns: how far it may move
// is a law (src/scene/README.md, "Maps that are no plane's").
#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <map>

#include "globe_views.h"

namespace selvage::cli::test {
namespace {

using scene::Vector2;
using scene::Vector3;

constexpr double kReach_px = 1.0 / 512 + 1e-9;          // of rounding x and y
constexpr double kTexelRounding = 1.0 / 131072 + 1e-9;  // of rounding u and v

// A face between two meridians and two parallels, cut by rays: its own map, which lines along the
// parallels rule, and never a row of the picture.
class Patch {
 public:
  // Corners as the globe has them: on the west from north to south, on the east from south to
  // north.
  Patch(const scene::Scene& scene, const scene::Face& face) {
    const scene::Object& object = scene.objects[0];
    const scene::Placement to_eye =
        scene::world_to_eye(scene.camera) * scene::placed(object.motion, 0);
    for (size_t i = 0; i < 4; ++i) {
      corners_[i] = to_eye * object.vertices[face.corners[i].vertex];
      texture_[i] = face.corners[i].texture_texel;
    }
    to_ray_ = scene::eye_to_place(scene.camera, kGlobeSize).inverse();
    north_ = (corners_[3] - corners_[0]).norm();
    south_ = (corners_[2] - corners_[1]).norm();
    const double longer = std::max(north_, south_);
    along_ = north_ > south_ ? corners_[3] - corners_[0] : corners_[2] - corners_[1];
    along_ /= longer;
  }

  // Where the ray through a point of the picture meets the plane.
  [[nodiscard]] Vector2 at(double x_px, double y_px) const {
    const Vector3 ray = to_ray_ * Vector3(x_px, y_px, 1);
    const Vector3 north = middle(0, 3), down = middle(1, 2) - north;
    const Vector3 normal = along_.cross(down);
    const Vector3 off = normal.dot(north) / normal.dot(ray) * ray - north;
    const double part = off.dot(down) / down.squaredNorm();  // 0 in the north, 1 in the south
    const double aside = off.dot(along_) / (north_ + part * (south_ - north_));
    return {(texture_[0].x() + texture_[3].x()) / 2 + aside * width(),
            texture_[0].y() + part * (texture_[1].y() - texture_[0].y())};
  }

  // How far the rows of any picture may move u: (1 - sqrt r) / (1 + sqrt r) of its range, r the
  // shorter parallel side over the longer.
  [[nodiscard]] double bound() const {
    const double root = std::sqrt(std::min(north_, south_) / std::max(north_, south_));
    return width() * (1 - root) / (1 + root);
  }
  [[nodiscard]] bool is_cap() const { return std::min(north_, south_) == 0; }
  [[nodiscard]] double width() const { return texture_[3].x() - texture_[0].x(); }
  [[nodiscard]] double height() const { return texture_[1].y() - texture_[0].y(); }

 private:
  [[nodiscard]] Vector3 middle(size_t a, size_t b) const { return (corners_[a] + corners_[b]) / 2; }

  std::array<Vector3, 4> corners_;
  std::array<Vector2, 4> texture_;
  scene::Matrix3 to_ray_;
  double north_, south_;  // the parallel sides
  Vector3 along_;
};

struct Range {
  Vector2 least, most;
};

// Between what the patch has within the reach of rounding x and y: both coordinates are quotients
// of linear functions there.
[[nodiscard]] Range within_reach(const Patch& patch, int32_t x_px, int32_t y_px) {
  Range range{Vector2::Constant(INFINITY), Vector2::Constant(-INFINITY)};
  for (const double dx : {-kReach_px, kReach_px}) {
    for (const double dy : {-kReach_px, kReach_px}) {
      const Vector2 here = patch.at(x_px + 0.5 + dx, y_px + 0.5 + dy);
      range = {range.least.cwiseMin(here), range.most.cwiseMax(here)};
    }
  }
  return range;
}

struct Moves {
  int64_t pixels = 0, beyond_u = 0, beyond_v = 0;
  double nearest = 0;  // to the bound of u, as a part of it
};

// Texels of a pixel are within [least - bound, most + bound], rounded down; `slack` is what
// rounding q adds, in parts of the range, and `scale` the part of the bound that is granted.
void judge(const Patch& patch, const GlobePicture::Texel& texel, const Range& range, double slack,
           double scale, Moves& moves) {
  const double u_slack = kTexelRounding + patch.width() * slack;
  const double v_slack = kTexelRounding + patch.height() * slack;
  const double u_bound = patch.bound() * scale + u_slack;
  moves.beyond_u += texel.u < std::floor(range.least.x() - u_bound) ||
                    texel.u > std::floor(range.most.x() + u_bound);
  moves.beyond_v += texel.v < std::floor(range.least.y() - v_slack) ||
                    texel.v > std::floor(range.most.y() + v_slack);
  ++moves.pixels;
  if (patch.bound() < 8) return;  // a texel would count for much
  const double moved = std::max(range.least.x() - (texel.u + 1), texel.u - range.most.x());
  moves.nearest = std::max(moves.nearest, (moved - u_slack) / patch.bound());
}

[[nodiscard]] Moves moves_of(const scene::Scene& globe, double scale) {
  Moves moves;
  for (uint64_t seed = 1; seed <= 24; ++seed) {
    const scene::Scene scene = globe_seen_from(seed, globe);
    const GlobePicture picture(scene);
    std::map<int, Patch> patches;
    for (int32_t y = 0; y < kGlobeSize.height_px; ++y) {
      for (int32_t x = 0; x < kGlobeSize.width_px; ++x) {
        const int shown = picture.index.face[GlobePicture::at(x, y)];
        if (shown < 0) continue;
        const scene::ScreenFace& face = picture.drawing.view.faces[static_cast<size_t>(shown)];
        const Patch& patch =
            patches.try_emplace(shown, scene, scene.objects[0].faces[face.face]).first->second;
        if (patch.is_cap()) continue;  // the bound is all of its u there
        judge(patch, picture.texel(x, y), within_reach(patch, x, y),
              scene::q_rounding_bound(face.vertices), scale, moves);
      }
    }
  }
  return moves;
}

[[nodiscard]] scene::Scene globe_with_map(int32_t width_texel) {
  scene::Scene globe = read_globe();
  scene::TextureImage& image = globe.textures[0];
  const double scale = static_cast<double>(width_texel) / image.width_texel;
  for (scene::Face& face : globe.objects[0].faces) {
    for (scene::Corner& corner : face.corners) corner.texture_texel *= scale;
  }
  image = {width_texel, width_texel / 2, {}, image.address};
  image.rgba.resize(static_cast<size_t>(width_texel) * static_cast<size_t>(width_texel) * 2);
  paint_places(image);
  return globe;
}

TEST(GlobeMap, MovesWithinItsBoundAsTheGlobeTurns) {
  const Moves moves = moves_of(globe_with_map(2048), 1);
  std::cout << moves.pixels << " pixels; nearest to the bound: " << moves.nearest << " of it\n";
  EXPECT_EQ(moves.beyond_u, 0);
  EXPECT_EQ(moves.beyond_v, 0);  // along a meridian it never moves
  EXPECT_GT(moves.pixels, 50000);
  EXPECT_GT(moves.nearest, 0.7);
}

// A bound of three quarters is broken: no less will do.
TEST(GlobeMap, MovesByMostOfItsBound) {
  EXPECT_GT(moves_of(globe_with_map(2048), 0.75).beyond_u, 0);
}

}  // namespace
}  // namespace selvage::cli::test
