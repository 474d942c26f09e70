// OpenCV warps a rectangle. Asked for a polygon it is given the polygon's bounding box as the
// destination and BORDER_TRANSPARENT, which leaves a pixel alone whose nearest texel lies outside
// the texture: for a polygon with the whole texture on it that is the polygon, up to its edge.
#include "reports/peers/peer.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/core/utility.hpp>
#include <opencv2/imgproc.hpp>

#include "reports/bench/planes.h"

namespace selvage::reports {

namespace {

cv::Rect bounding_box(const std::vector<selvage_vertex>& polygon, const Target& target) {
  int32_t left = SELVAGE_X_END, top = SELVAGE_X_END, right = SELVAGE_X_MIN, bottom = SELVAGE_X_MIN;
  for (const selvage_vertex& vertex : polygon) {
    left = std::min(left, vertex.x), right = std::max(right, vertex.x);
    top = std::min(top, vertex.y), bottom = std::max(bottom, vertex.y);
  }
  const auto px = [](int32_t fx8) { return static_cast<int32_t>(std::floor(fx8 / 256.0)); };
  const cv::Rect box(cv::Point(px(left), px(top)), cv::Point(px(right) + 1, px(bottom) + 1));
  return box & cv::Rect(0, 0, target.width_px, target.height_px);
}

// From the pixel (i, j) of the box to texture coordinates with texel centres at integers.
cv::Matx33d inverse_map(const std::vector<selvage_vertex>& polygon, const cv::Rect& box) {
  const Planes planes = planes_of(polygon);
  const double x = box.x + 0.5, y = box.y + 0.5;
  const auto less_half = [&](const Plane& a) {
    return cv::Vec3d(a.dx - planes.q.dx / 2, a.dy - planes.q.dy / 2,
                     a.at(x, y) - planes.q.at(x, y) / 2);
  };
  const cv::Vec3d u = less_half(planes.u), v = less_half(planes.v);
  return {u[0], u[1], u[2], v[0], v[1], v[2], planes.q.dx, planes.q.dy, planes.q.at(x, y)};
}

std::function<void()> prepare(const Workload& load, const Texture& texture, Target& target) {
  const auto& polygon = load.polygons.front();
  const cv::Rect box = bounding_box(polygon, target);
  const cv::Matx33d map = inverse_map(polygon, box);
  const bool bilinear = load.filter == kBilinear;
  const int element = bilinear ? CV_8UC4 : CV_32SC1;
  // OpenCV only reads the source; its matrix type has no constant view.
  const cv::Mat source(texture.side_texel, texture.side_texel, element,
                       const_cast<uint32_t*>(texture.texels.data()),
                       static_cast<size_t>(texture.pitch_texel) * sizeof(uint32_t));
  const cv::Mat whole(target.height_px, target.width_px, element, target.pixels.data());
  const cv::Mat destination = whole(box);
  const int flags = (bilinear ? cv::INTER_LINEAR : cv::INTER_NEAREST) | cv::WARP_INVERSE_MAP;
  if (load.perspective) {
    return [=] {
      cv::warpPerspective(source, destination, map, destination.size(), flags,
                          cv::BORDER_TRANSPARENT);
    };
  }
  const cv::Matx23d affine = map.get_minor<2, 3>(0, 0);
  return [=] {
    cv::warpAffine(source, destination, affine, destination.size(), flags, cv::BORDER_TRANSPARENT);
  };
}

}  // namespace

Peer peer_opencv() {
  cv::setNumThreads(1);
  Subject subject;
  subject.id = "OpenCV";
  subject.title = std::string("OpenCV ") + CV_VERSION + " warpAffine / warpPerspective";
  subject.configuration =
      "INTER_NEAREST | WARP_INVERSE_MAP, BORDER_TRANSPARENT, cv::setNumThreads(1), into the "
      "polygon's bounding box, a pixel as one 32-bit element (CV_32SC1; for W5 "
      "INTER_LINEAR and CV_8UC4), the matrix made beforehand; warpPerspective for W4; it walks the "
      "whole box, the time is divided by the "
      "covered pixels";
  subject.bilinear = true;
  subject.refusal = [](const Workload& load) {
    return load.polygons.size() == 1
               ? std::string()
               : std::string("it warps one rectangle; a mesh would be a call and a box a triangle");
  };
  subject.prepare = prepare;
  return {subject, cv::getBuildInformation()};
}

}  // namespace selvage::reports
