// OpenCV warps rectangles. A polygon with the whole texture on it is its bounding box warped with
// BORDER_TRANSPARENT, which leaves a pixel alone whose nearest texel lies outside the texture. Any
// other is warped into a picture of its own, which is copied through a mask of the polygon.
#include "reports/peers/peer.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/core/utility.hpp>
#include <opencv2/imgproc.hpp>

#include "reports/peers/map.h"

namespace selvage::reports {

namespace {

cv::Rect bounding_box(const Polygon& polygon, const selvage_image& target) {
  int32_t left = SELVAGE_X_END, top = SELVAGE_X_END, right = SELVAGE_X_MIN, bottom = SELVAGE_X_MIN;
  for (const selvage_vertex& vertex : polygon) {
    left = std::min(left, vertex.x), right = std::max(right, vertex.x);
    top = std::min(top, vertex.y), bottom = std::max(bottom, vertex.y);
  }
  const auto px = [](int32_t fx8) { return static_cast<int32_t>(std::floor(fx8 / 256.0)); };
  const cv::Rect box(cv::Point(px(left), px(top)), cv::Point(px(right) + 1, px(bottom) + 1));
  return box & cv::Rect(0, 0, target.width, target.height);
}

// From the pixel (i, j) of the box to texture coordinates with texel centres at integers.
cv::Matx33d inverse_map(const Polygon& polygon, const cv::Rect& box) {
  const Planes planes = map_of(polygon);
  const double x = box.x + 0.5, y = box.y + 0.5;
  const auto less_half = [&](const Plane& a) {
    return cv::Vec3d(a.dx - planes.q.dx / 2, a.dy - planes.q.dy / 2,
                     a.at(x, y) - planes.q.at(x, y) / 2);
  };
  const cv::Vec3d u = less_half(planes.u), v = less_half(planes.v);
  return {u[0], u[1], u[2], v[0], v[1], v[2], planes.q.dx, planes.q.dy, planes.q.at(x, y)};
}

// OpenCV only reads its sources; its matrix type has no constant view.
cv::Mat matrix_over(const void* pixels, int32_t width, int32_t height, ptrdiff_t pitch_bytes,
                    int element) {
  return {height, width, element, const_cast<void*>(pixels), static_cast<size_t>(pitch_bytes)};
}

class OpencvPainter : public Painter {
 public:
  explicit OpencvPainter(const Canvas& canvas)
      : canvas_(canvas),
        element_(canvas.filter == SELVAGE_FILTER_BILINEAR ? CV_8UC4 : CV_32SC1),
        source_(matrix_over(canvas.texture.texels, canvas.texture.width, canvas.texture.height,
                            canvas.texture.pitch, element_)),
        target_(matrix_over(canvas.target.pixels, canvas.target.width, canvas.target.height,
                            canvas.target.pitch, element_)) {}

  void draw(std::span<const Polygon> polygons) override {
    for (const Polygon& polygon : polygons) {
      const cv::Rect box = bounding_box(polygon, canvas_.target);
      if (box.empty()) continue;
      if (canvas_.opaque)
        warp(polygon, box, target_(box), cv::BORDER_TRANSPARENT);
      else
        draw_masked(polygon, box);
    }
  }

 private:
  void warp(const Polygon& polygon, const cv::Rect& box, const cv::Mat& into, int border) const {
    const cv::Matx33d map = inverse_map(polygon, box);
    const bool bilinear = canvas_.filter == SELVAGE_FILTER_BILINEAR;
    const int flags = (bilinear ? cv::INTER_LINEAR : cv::INTER_NEAREST) | cv::WARP_INVERSE_MAP;
    if (canvas_.perspective)
      cv::warpPerspective(source_, into, map, into.size(), flags, border);
    else
      cv::warpAffine(source_, into, map.get_minor<2, 3>(0, 0), into.size(), flags, border);
  }

  // fillConvexPoly's points have 8 bits of fraction, and the pixels' centres at whole numbers.
  void draw_masked(const Polygon& polygon, const cv::Rect& box) {
    constexpr int fraction_bits = 8, half = 128;
    const cv::Rect& visible = box & clip();
    if (visible.empty()) return;
    cv::Mat warped(box.size(), element_), mask(target_.size(), CV_8UC1, cv::Scalar(0));
    const bool wraps = canvas_.address == SELVAGE_ADDRESS_WRAP;
    warp(polygon, box, warped, wraps ? cv::BORDER_WRAP : cv::BORDER_REPLICATE);
    std::vector<cv::Point> points;
    for (const selvage_vertex& vertex : polygon)
      points.emplace_back(vertex.x - half, vertex.y - half);
    cv::fillConvexPoly(mask, points, cv::Scalar(255), cv::LINE_8, fraction_bits);
    warped(visible - box.tl()).copyTo(target_(visible), mask(visible));
  }

  [[nodiscard]] cv::Rect clip() const {
    const cv::Rect whole(0, 0, canvas_.target.width, canvas_.target.height);
    if (!canvas_.clip) return whole;
    const selvage_rect& clip = *canvas_.clip;
    return whole & cv::Rect(clip.left, clip.top, width_of(clip), height_of(clip));
  }

  const Canvas canvas_;
  const int element_;
  const cv::Mat source_;
  cv::Mat target_;
};

}  // namespace

std::unique_ptr<Painter> paint_with_opencv(const Canvas& canvas) {
  cv::setNumThreads(1);
  return std::make_unique<OpencvPainter>(canvas);
}

Peer peer_opencv() {
  Subject subject;
  subject.id = "OpenCV";
  subject.title = std::string("OpenCV ") + CV_VERSION + " warpAffine / warpPerspective";
  subject.configuration =
      "INTER_NEAREST | WARP_INVERSE_MAP, BORDER_TRANSPARENT, cv::setNumThreads(1), into the "
      "polygon's bounding box, a pixel as one 32-bit element (CV_32SC1; for W5 "
      "INTER_LINEAR and CV_8UC4), its matrix from the vertices is timed; warpPerspective for W4; "
      "it walks the "
      "whole box, the time is divided by the "
      "covered pixels";
  subject.bilinear = true;
  subject.refusal = [](const Workload& load) {
    return load.polygons.size() == 1
               ? std::string()
               : std::string("it warps one rectangle; a mesh would be a call and a box a triangle");
  };
  subject.prepare = prepared_by(paint_with_opencv);
  return {subject, cv::getBuildInformation()};
}

}  // namespace selvage::reports
