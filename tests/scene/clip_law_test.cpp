// Clipping a face in space and drawing it is drawing it and clipping the picture, within what
// snapping moves (src/scene/README.md, "What snapping moves").
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <optional>
#include <string>

#include "plane_face.h"
#include "scene/screen_face.h"
#include "selvage.h"
#include "spec/exact.h"

namespace selvage::scene {
namespace {

inline constexpr Size kClipTarget{64, 48};
inline constexpr double kTexelRounding = 1.0 / 131072 + 1e-9;  // of rounding u and v

// Where u (or v) may be at a pixel's centre: where the true map has it within the reach of rounding
// x and y, widened by what rounding u and q add.
[[nodiscard]] Interval allowed(const PlaneFace& face, int x_px, int y_px, int axis,
                               const Outline& outline, std::span<const selvage_vertex> snapped) {
  const Interval interval = within_reach(face, x_px, y_px, axis);
  double least = INFINITY, most = -INFINITY;
  for (const PlacedCorner& corner : outline) {
    least = std::min(least, corner.texture_texel[axis]);
    most = std::max(most, corner.texture_texel[axis]);
  }
  const double widened = kTexelRounding + (most - least) * q_rounding_bound(snapped);
  return {interval.least - widened, interval.most + widened};
}

struct Tally {
  int64_t pixels = 0, decided = 0, at_outline = 0;
};

class Pictures {
 public:
  Pictures() : texels_(kTextureSide_texel * kTextureSide_texel) {
    for (int t = 0; t < kTextureSide_texel; ++t) {
      for (int s = 0; s < kTextureSide_texel; ++s)
        texels_[static_cast<size_t>(t * kTextureSide_texel + s)] =
            static_cast<uint32_t>(s | t << 16);
    }
  }

  // The texels of the coordinate texture, or -1 where nothing is drawn.
  [[nodiscard]] std::vector<uint32_t> draw(std::span<const selvage_vertex> vertices) const {
    std::vector<uint32_t> pixels(kClipTarget.width_px * kClipTarget.height_px, UINT32_MAX);
    if (vertices.size() < 3) return pixels;
    const selvage_image image{pixels.data(), kClipTarget.width_px, kClipTarget.height_px,
                              kClipTarget.width_px * 4, SELVAGE_RGBA8888};
    const selvage_texture texture{texels_.data(),
                                  kTextureSide_texel,
                                  kTextureSide_texel,
                                  kTextureSide_texel * 4,
                                  SELVAGE_RGBA8888,
                                  SELVAGE_LAYOUT_ROWS,
                                  nullptr};
    EXPECT_EQ(selvage_draw(&image, nullptr, vertices.data(), vertices.size(), &texture, nullptr),
              SELVAGE_OK);
    return pixels;
  }

 private:
  std::vector<uint32_t> texels_;
};

[[nodiscard]] double texel(uint32_t pixel, int axis) {
  return axis == 0 ? pixel & 0xffff : pixel >> 16;
}

// One pixel that both pictures show: each within its interval, and so the same texel where the
// interval of both holds no border of texels.
void expect_texels(const PlaneFace& face, int x, int y, uint32_t drawn, const Outline& outline,
                   std::span<const selvage_vertex> snapped, uint32_t other, Tally& tally) {
  if (!is_before_horizon(face, x, y)) return;
  bool decided = true;
  for (const int axis : {0, 1}) {
    const Interval interval = allowed(face, x, y, axis, outline, snapped);
    EXPECT_GE(texel(drawn, axis), std::floor(interval.least)) << x << ", " << y;
    EXPECT_LE(texel(drawn, axis), std::floor(interval.most)) << x << ", " << y;
    decided = decided && std::floor(interval.least) == std::floor(interval.most);
  }
  ++tally.pixels;
  tally.decided += decided;
  if (!decided) return;
  EXPECT_EQ(drawn, other) << x << ", " << y;
}

void compare(const PlaneFace& face, std::span<const ClipPlane> planes, const Pictures& pictures,
             Tally& tally) {
  const Outline& whole = face.outline();
  Outline cut = whole;
  clip(cut, planes);
  const double w_near = least_w(whole);
  std::vector<selvage_vertex> whole_snapped, cut_snapped;
  ASSERT_EQ(snap(whole, w_near, whole_snapped), SELVAGE_OK);
  ASSERT_EQ(snap(cut, w_near, cut_snapped), SELVAGE_OK);
  const std::vector<uint32_t> drawn_whole = pictures.draw(whole_snapped);
  const std::vector<uint32_t> drawn_cut = pictures.draw(cut_snapped);
  for (int y = 0; y < kClipTarget.height_px; ++y) {
    for (int x = 0; x < kClipTarget.width_px; ++x) {
      const Vector3 place = face.at(x + 0.5, y + 0.5).place;
      bool kept = place.z() > 0;
      for (const ClipPlane& plane : planes) kept = kept && plane.height(place) >= 0;
      const size_t i = static_cast<size_t>(y * kClipTarget.width_px + x);
      const bool due = kept && drawn_whole[i] != UINT32_MAX;
      const bool drawn = drawn_cut[i] != UINT32_MAX;
      if (due != drawn) {
        ++tally.at_outline;
        EXPECT_TRUE(is_near(whole, x + 0.5, y + 0.5, kReach_px) ||
                    is_near(cut, x + 0.5, y + 0.5, kReach_px))
            << x << ", " << y << (due ? " is missing" : " is too much");
      } else if (due) {
        expect_texels(face, x, y, drawn_cut[i], cut, cut_snapped, drawn_whole[i], tally);
        expect_texels(face, x, y, drawn_whole[i], whole, whole_snapped, drawn_cut[i], tally);
      }
    }
  }
}

TEST(ClipLaw, ClippingInSpaceIsClippingThePicture) {
  const Pictures pictures;
  Tally tally;
  int faces = 0;
  for (uint64_t seed = 1; faces < 500; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    spec::Random random(seed);
    const PlaneFace face(random, kClipTarget, random.in(3, 9));
    const double near = real(random, 0.2, 5);
    if (!face.is_beyond(0.1)) continue;  // only what can be drawn whole can be compared
    ++faces;
    const ClipPlane window[] = {beyond(near), right_of(random.in(0, 30)),
                                left_of(random.in(34, 64)), below(random.in(0, 20)),
                                above(random.in(24, 48))};
    compare(face, window, pictures, tally);
  }
  RecordProperty("pixels", std::to_string(tally.pixels));
  std::cout << tally.pixels << " texels, " << tally.decided << " decided, " << tally.at_outline
            << " pixels at outlines\n";
  EXPECT_GT(tally.pixels, 50000);
  EXPECT_GT(tally.decided, tally.pixels * 4 / 5);
}

TEST(ClipLaw, SharedSidesStayShared) {
  int cut = 0;
  for (uint64_t seed = 1; seed <= 500; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    spec::Random random(seed);
    std::vector<PlacedCorner> corners(4, {Vector3::Zero(), Vector2::Zero()});
    for (PlacedCorner& corner : corners) {
      corner.place = Vector3(real(random, -200, 200), real(random, -200, 200), real(random, -1, 2));
    }
    Outline left{corners[0], corners[1], corners[2]}, right{corners[2], corners[1], corners[3]};
    const std::vector<ClipPlane> planes = clip_planes({});
    clip(left, planes);
    clip(right, planes);
    // Each corner on the shared side is one of the other outline's, to the bit.
    const Vector3 side = corners[2].place - corners[1].place;
    for (const PlacedCorner& corner : left) {
      const Vector3 off = corner.place - corners[1].place;
      const double part = off.dot(side) / side.squaredNorm();
      if ((off - part * side).norm() > 1e-9 || part < 0 || part > 1) continue;
      cut += part > 1e-6 && part < 1 - 1e-6;
      EXPECT_TRUE(std::any_of(right.begin(), right.end(), [&](const PlacedCorner& other) {
        return other.place == corner.place;
      }));
    }
  }
  EXPECT_GT(cut, 200);
}

}  // namespace
}  // namespace selvage::scene
