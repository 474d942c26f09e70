// A warp of the bounding box, copied through a mask: the usual way to map a triangle. Pixel and
// texel centres are whole numbers. fillConvexPoly draws "the polygon boundaries" too (imgproc.hpp),
// with 8 bits of fraction. The clip is a region of the target. Sides must be less than 32767
// (imgproc.hpp, remap: "the size of an input and output images"); longer ones throw.
#include <opencv2/core/version.hpp>

#include "reports/peers/subjects/subject.h"

namespace selvage::reports {

const PeerSubject& peer_subject() {
  static const PeerSubject subject = [] {
    PeerSubject opencv = {
        claims_of_triangles("OpenCV", CV_VERSION, kNearestAndBilinear, kClamp | kWrap, 0),
        paint_with_opencv};
    opencv.claims.longest_side_px = opencv.claims.longest_side_texel = 32766;
    return opencv;
  }();
  return subject;
}

}  // namespace selvage::reports
