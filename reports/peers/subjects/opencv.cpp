// A warp of the bounding box, copied through a mask: the usual way to map a triangle. Pixel and
// texel centres are whole numbers. fillConvexPoly draws "the polygon boundaries" too (imgproc.hpp),
// with 8 bits of fraction. The clip is a region of the target.
#include <opencv2/core/version.hpp>

#include "reports/peers/subjects/subject.h"

namespace selvage::reports {

const PeerSubject& peer_subject() {
  static const PeerSubject subject = {
      claims_of_triangles("OpenCV", CV_VERSION, kNearestAndBilinear, kClamp | kWrap, 0),
      paint_with_opencv};
  return subject;
}

}  // namespace selvage::reports
