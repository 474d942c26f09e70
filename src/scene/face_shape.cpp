#include "scene/face_shape.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <numbers>
#include <sstream>

namespace selvage::scene {
namespace {

inline constexpr double kSixDigits = 5e-6;  // half of the last of 1.00000

[[nodiscard]] std::string show(double length) {
  std::ostringstream text;
  text << std::setprecision(3) << length;
  return text.str();
}

}  // namespace

double corner_rounding(const Object& object) {
  double greatest = 0;
  for (const Vector3& place : object.vertices) {
    greatest = std::max(greatest, place.lpNorm<Eigen::Infinity>());
  }
  return std::numbers::sqrt3 * kSixDigits * greatest;
}

double off_plane(const Object& object, const Face& face) {
  const auto count = static_cast<double>(face.corners.size());
  Vector3 mean = Vector3::Zero();
  for (size_t i = 0; i < face.corners.size(); ++i) mean += vertex_at(object, face, i) / count;
  Matrix3 squares = Matrix3::Zero();
  for (size_t i = 0; i < face.corners.size(); ++i) {
    const Vector3 from_mean = vertex_at(object, face, i) - mean;
    squares += from_mean * from_mean.transpose() / count;
  }
  const Eigen::SelfAdjointEigenSolver<Matrix3> solver(squares, Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0.0, solver.eigenvalues().x()));  // the least comes first
}

bool is_convex(const Object& object, const Face& face, double rounding) {
  const Vector3 outside = normal(object, face);
  const bool flat = outside.isZero(0);  // all on a line, or as much turned left as right
  double turned = 0;
  for (size_t i = 0; i < face.corners.size(); ++i) {
    const Vector3 before = vertex_at(object, face, i + 1) - vertex_at(object, face, i);
    const Vector3 after = vertex_at(object, face, i + 2) - vertex_at(object, face, i + 1);
    const double around = before.norm() + after.norm() + (before + after).norm();
    const double straight = rounding * (around + 3 * rounding);
    if (flat && before.cross(after).norm() > straight) return false;
    const double sine = before.cross(after).dot(outside);
    if (sine < -straight) return false;
    turned += std::atan2(sine, before.dot(after));
  }
  return turned < 3 * std::numbers::pi;  // once around, not twice as a star does
}

std::string shape_problem(const Object& object, const Face& face, double rounding) {
  if (const double off = off_plane(object, face); off > rounding) {
    return "is not plane: its corners are " + show(off) +
           " off any plane (root mean square), where rounding to six digits explains " +
           show(rounding) + "; cut it into triangles";
  }
  return is_convex(object, face, rounding) ? "" : "is not convex; cut it into convex faces";
}

}  // namespace selvage::scene
