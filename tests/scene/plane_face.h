// Random plane faces before a camera, with the map that they ought to show.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "scene/clip.h"
#include "scene/vectors.h"
#include "spec/random.h"

namespace selvage::scene {

inline constexpr int kTextureSide_texel = 512;  // the faces' maps lie about its middle

// In [least, end).
[[nodiscard]] inline double real(spec::Random& random, double least, double end) {
  return least + (end - least) * static_cast<double>(random.bits() >> 11) * 0x1p-53;
}
[[nodiscard]] inline Vector3 direction(spec::Random& random) {
  const double z = real(random, -1, 1), angle = real(random, 0, 2 * std::numbers::pi);
  const double r = std::sqrt(1 - z * z);
  return {r * std::cos(angle), r * std::sin(angle), z};
}

// An n-gon on an ellipse in a plane, and its texture: u and v linear on the plane. Nothing here
// is computed as the pipeline does it: rays are cut with the plane.
class PlaneFace {
 public:
  PlaneFace(spec::Random& random, Size size, int corners) {
    to_place_ << size.height_px, 0, size.width_px / 2.0, 0, size.height_px, size.height_px / 2.0, 0,
        0, 1;
    centre_ = {real(random, -1, 1), real(random, -1, 1), real(random, 2.5, 6)};
    normal_ = direction(random);
    const Vector3 across = normal_.cross(direction(random)).normalized();
    along_ = across * real(random, 0.3, 2);
    aside_ = normal_.cross(across) * real(random, 0.3, 2);
    u_ = {real(random, 20, 200), real(random, -50, 50)};
    v_ = {real(random, -50, 50), real(random, 20, 200)};
    std::vector<double> angles;
    for (int i = 0; i < corners; ++i) angles.push_back(real(random, 0, 2 * std::numbers::pi));
    std::sort(angles.begin(), angles.end());
    for (const double angle : angles) {
      const Vector2 on_plane{std::cos(angle), std::sin(angle)};
      outline_.push_back({to_place_ * point(on_plane), texture(on_plane)});
    }
  }

  [[nodiscard]] const Outline& outline() const { return outline_; }

  // Where the ray through a point of the screen meets the plane: w, and the texture there.
  [[nodiscard]] PlacedCorner at(double x_px, double y_px) const {
    const Vector3 ray = to_place_.inverse() * Vector3(x_px, y_px, 1);
    const double w = normal_.dot(centre_) / normal_.dot(ray);
    const Vector3 from_centre = w * ray - centre_;
    return {{x_px * w, y_px * w, w},
            texture({from_centre.dot(along_) / along_.squaredNorm(),
                     from_centre.dot(aside_) / aside_.squaredNorm()})};
  }

  // All corners are at least that far.
  [[nodiscard]] bool is_beyond(double w) const {
    return std::all_of(outline_.begin(), outline_.end(),
                       [&](const PlacedCorner& corner) { return corner.place.z() >= w; });
  }

 private:
  [[nodiscard]] Vector3 point(const Vector2& on_plane) const {
    return centre_ + on_plane.x() * along_ + on_plane.y() * aside_;
  }
  [[nodiscard]] Vector2 texture(const Vector2& on_plane) const {
    constexpr double middle_texel = kTextureSide_texel / 2;
    return {middle_texel + u_.dot(on_plane), middle_texel + v_.dot(on_plane)};
  }

  Matrix3 to_place_;
  Vector3 centre_, normal_, along_, aside_;
  Vector2 u_, v_;
  Outline outline_;
};

[[nodiscard]] inline double least_w(const Outline& outline) {
  double least = outline.front().place.z();
  for (const PlacedCorner& corner : outline) least = std::min(least, corner.place.z());
  return least;
}

inline constexpr double kReach_px = 1.0 / 512 + 1e-9;  // of rounding x and y

struct Interval {
  double least, most;
};

// Of u (or v) where rounding x and y may move a pixel's centre to: a quotient of linear functions
// is between its values at a square's corners.
[[nodiscard]] inline Interval within_reach(const PlaneFace& face, int x_px, int y_px, int axis) {
  Interval interval{INFINITY, -INFINITY};
  for (const double dx : {-kReach_px, kReach_px}) {
    for (const double dy : {-kReach_px, kReach_px}) {
      const double value = face.at(x_px + 0.5 + dx, y_px + 0.5 + dy).texture_texel[axis];
      interval = {std::min(interval.least, value), std::max(interval.most, value)};
    }
  }
  return interval;
}

// No horizon within reach of the pixel: w is positive and finite on all of the square.
[[nodiscard]] inline bool is_before_horizon(const PlaneFace& face, int x_px, int y_px) {
  for (const double dx : {-kReach_px, kReach_px}) {
    for (const double dy : {-kReach_px, kReach_px}) {
      const double w = face.at(x_px + 0.5 + dx, y_px + 0.5 + dy).place.z();
      if (!(w > 0 && w < 1e6)) return false;
    }
  }
  return true;
}

// The outline comes nearer to the point than `reach_px` in x and in y at once.
[[nodiscard]] inline bool is_near(const Outline& outline, double x_px, double y_px,
                                  double reach_px) {
  for (size_t i = 0; i < outline.size(); ++i) {
    const Vector3 &from = outline[i].place, &to = outline[(i + 1) % outline.size()].place;
    const Vector2 a = from.head<2>() / from.z() - Vector2(x_px, y_px);
    const Vector2 b = to.head<2>() / to.z() - Vector2(x_px, y_px);
    const Vector2 side = b - a;
    const bool boxes_meet =
        std::min(a.x(), b.x()) <= reach_px && std::max(a.x(), b.x()) >= -reach_px &&
        std::min(a.y(), b.y()) <= reach_px && std::max(a.y(), b.y()) >= -reach_px;
    const double cross = side.x() * -a.y() + side.y() * a.x();
    if (boxes_meet && std::abs(cross) <= reach_px * side.lpNorm<1>()) return true;
  }
  return false;
}

}  // namespace selvage::scene
