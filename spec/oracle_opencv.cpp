#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <opencv2/core.hpp>
#include <opencv2/core/utility.hpp>
#include <opencv2/imgproc.hpp>

#include "spec/geometry.h"
#include "spec/law_list.h"
#include "spec/law_tools.h"
#include "spec/oracle.h"

namespace selvage::spec {
namespace {

// a i + b j + c over pixel indices (i, j), exactly.
struct Plane {
  Rational a, b, c;

  [[nodiscard]] Rational at(int32_t i, int32_t j) const { return a * i + b * j + c; }
  // |a i| + |b j| + |c|, which bounds the rounding of a sum of the three.
  [[nodiscard]] double magnitude(int32_t i, int32_t j) const {
    return std::abs(a.get_d() * i) + std::abs(b.get_d() * j) + std::abs(c.get_d());
  }
};

// The plane through three values at three vertices, whose doubled area is not 0.
[[nodiscard]] Plane plane_through(std::span<const selvage_vertex> v,
                                  const std::array<Rational, 3>& f) {
  const auto position_of = [&](size_t k) {
    return std::pair<Rational, Rational>(Rational(v[k].x) / SELVAGE_SUBPIXELS,
                                         Rational(v[k].y) / SELVAGE_SUBPIXELS);
  };
  const auto [x0, y0] = position_of(0);
  const auto [x1, y1] = position_of(1);
  const auto [x2, y2] = position_of(2);
  const Rational area = (x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0);
  Plane plane;
  plane.a = ((f[1] - f[0]) * (y2 - y0) - (f[2] - f[0]) * (y1 - y0)) / area;
  plane.b = ((f[2] - f[0]) * (x1 - x0) - (f[1] - f[0]) * (x2 - x0)) / area;
  const Rational half(1, 2);  // index (0, 0) is the point (1/2, 1/2)
  plane.c = f[0] + plane.a * (half - x0) + plane.b * (half - y0);
  return plane;
}

// The map of a triangle in OpenCV's convention, where texel centres are integers: (X / W, Y / W).
struct Homography {
  Plane x, y, w;
};

[[nodiscard]] Homography homography_of(std::span<const selvage_vertex> v) {
  const Rational half(1, 2);
  std::array<Rational, 3> x, y, w;
  for (size_t k = 0; k < 3; ++k) {
    w[k] = v[k].q;
    x[k] = (Rational(v[k].u) / SELVAGE_SUBTEXELS - half) * w[k];
    y[k] = (Rational(v[k].v) / SELVAGE_SUBTEXELS - half) * w[k];
  }
  return {plane_through(v, x), plane_through(v, y), plane_through(v, w)};
}

[[nodiscard]] double distance_to_integer(const Rational& number) {
  const Rational fraction = number - floor(number);
  return std::min(fraction, Rational(1 - fraction)).get_d();
}

// Far below the ends of the 16-bit texel coordinates that OpenCV saturates.
inline constexpr double kLargestTexel = 32000;
inline constexpr double kHalfUlpOfOne = 0x1p-53;
// OpenCV refuses larger images.
inline constexpr int32_t kSideLimit = 32767;

// warpAffine rounds each of two terms to 1/1024 texel, halves to even, and floors their sum plus
// 1/2: the texel is certain where u is further than 1/1024 from an integer, plus what doubles lose
// in the matrix, its products and their sums.
[[nodiscard]] bool is_decided_affine(const Plane& plane, const Rational& u, Pixel at,
                                     double accuracy_texel) {
  const double sum = plane.magnitude(at.x_px, at.y_px);
  const double margin =
      kAffineRounding_texel + kAffineRoundings * kHalfUlpOfOne * sum + accuracy_texel;
  return sum < kLargestSum_texel && std::abs(u.get_d()) < kLargestTexel &&
         distance_to_integer(u) > margin;
}

// warpPerspective divides in double and rounds: relative errors of a few 2^-53 in the matrix, in X,
// W and X / W.
[[nodiscard]] bool is_decided_projective(const Plane& x, const Plane& w, const Rational& u,
                                         Pixel at, double accuracy_texel) {
  const auto [i, j] = at;
  const double depth = std::abs(w.at(i, j).get_d());
  const double u_magnitude = std::abs(u.get_d()) + 1;
  const double x_terms = kProjectiveTerms * x.magnitude(i, j) / depth;
  const double w_terms = kProjectiveTerms * w.magnitude(i, j) / depth;
  const double margin = kProjectiveFactor * kHalfUlpOfOne *
                            (x_terms + u_magnitude * (w_terms + kProjectiveQuotient)) +
                        accuracy_texel;
  return u_magnitude < kLargestTexel && distance_to_integer(u) > margin;
}

[[nodiscard]] cv::Mat coordinate_image(const Case& c) {
  cv::Mat image(c.texture_height_texel, c.texture_width_texel, CV_8UC4);
  for (int32_t t = 0; t < image.rows; ++t) {
    for (int32_t s = 0; s < image.cols; ++s) {
      const uint32_t value = coordinate_texel(s, t);
      std::memcpy(image.ptr(t, s), &value, image.elemSize());
    }
  }
  return image;
}

[[nodiscard]] cv::Mat warp(const Case& c, const Homography& map, bool affine) {
  const Plane* planes[] = {&map.x, &map.y, &map.w};
  cv::Mat matrix(affine ? 2 : 3, 3, CV_64F);
  for (int row = 0; row < matrix.rows; ++row) {
    matrix.at<double>(row, 0) = planes[row]->a.get_d();
    matrix.at<double>(row, 1) = planes[row]->b.get_d();
    matrix.at<double>(row, 2) = planes[row]->c.get_d();
  }
  const int flags = cv::INTER_NEAREST | cv::WARP_INVERSE_MAP;
  const int border = c.address == SELVAGE_ADDRESS_CLAMP ? cv::BORDER_REPLICATE : cv::BORDER_WRAP;
  const cv::Size size(c.target_width_px, c.target_height_px);
  cv::Mat warped;
  cv::setNumThreads(1);
  if (affine) {
    cv::warpAffine(coordinate_image(c), warped, matrix, size, flags, border);
  } else {
    cv::warpPerspective(coordinate_image(c), warped, matrix, size, flags, border);
  }
  return warped;
}

// An affine map with its constant q made 1.
[[nodiscard]] Homography normalised(Homography map) {
  for (Plane* plane : {&map.x, &map.y}) {
    plane->a /= map.w.c;
    plane->b /= map.w.c;
    plane->c /= map.w.c;
  }
  map.w.c = 1;
  return map;
}

// Where OpenCV is certain of a texel that a subject of this accuracy must show, too.
struct Decision {
  const Homography& map;
  bool affine;
  double accuracy_texel;

  [[nodiscard]] bool is_made(const Sample& point, Pixel at) const {
    const auto along = [&](const Plane& plane, const Rational& u) {
      return affine ? is_decided_affine(plane, u, at, accuracy_texel)
                    : is_decided_projective(plane, map.w, u, at, accuracy_texel);
    };
    return along(map.x, point.u) && along(map.y, point.v);
  }
};

[[nodiscard]] OracleTally judge_warped(const Case& shown, const Picture& picture,
                                       const cv::Mat& warped, const Decision& decision) {
  OracleTally tally;
  for (int32_t y = 0; y < shown.target_height_px; ++y) {
    const std::optional<ScanLine> line = scan_line(shown.vertices, y);
    for (int32_t x = 0; line && x < shown.target_width_px; ++x) {
      const std::optional<Sample> point = sample(*line, x);
      if (!point || !picture.at(x, y)) continue;
      if (!decision.is_made(*point, {x, y})) {
        ++tally.undecided_px;
        continue;
      }
      ++tally.decided_px;
      uint32_t theirs = 0;
      std::memcpy(&theirs, warped.ptr(y, x), warped.elemSize());
      if (theirs == *picture.at(x, y)) continue;
      tally.violation =
          violation_at("ORACLE", "the mapper agrees with OpenCV where OpenCV is decided", shown, x,
                       y, describe_texel(theirs) + " (OpenCV)", picture.at(x, y));
      return tally;
    }
  }
  return tally;
}

}  // namespace

OracleTally ask_opencv(const Subject& subject, const Case& c) {
  if (c.vertices.size() < 3) return {};
  Case shown = with_vertices(subject.claims, c, {c.vertices[0], c.vertices[1], c.vertices[2]});
  make_visible(profile_of(c), subject.claims, &shown.vertices);
  shown.has_clip = false;
  const int32_t largest_side = std::max(
      {c.target_width_px, c.target_height_px, c.texture_width_texel, c.texture_height_texel});
  if (largest_side >= kSideLimit) return {};
  const auto& v = shown.vertices;
  if (doubled_area(position(v[0]), position(v[1]), position(v[2])) == 0) return {};
  const bool affine = v[0].q == v[1].q && v[1].q == v[2].q;
  const Homography map = affine ? normalised(homography_of(v)) : homography_of(v);
  return judge_warped(shown, draw(subject, shown), warp(shown, map, affine),
                      {map, affine, accuracy_of(subject).get_d()});
}

Judgement check_oracle(const Subject& subject, const Case& any) {
  const Case c = with_nearest(any);
  OracleTally tally = ask_opencv(subject, c);
  return {tally.decided_px, std::move(tally.violation)};
}

std::string opencv_build() { return cv::getBuildInformation(); }

}  // namespace selvage::spec
