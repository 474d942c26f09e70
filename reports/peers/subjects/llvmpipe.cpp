// OpenGL: a fragment is produced where its centre lies in the polygon; of a centre on a common edge
// exactly one of two polygons does (specification 1.1 to 4.6, "Basic Polygon Rasterization"), which
// is not said. The specification "is not pixel exact" (appendix "Invariance"). Texel (i, j) is at
// (floor u, floor v). Coordinates are single precision. The clip is the scissor box.
#include <string>

#include "reports/peers/peer.h"
#include "reports/peers/subjects/subject.h"

namespace selvage::reports {

const PeerSubject& peer_subject() {
  static const std::string version = peer_llvmpipe().build_information;
  static const PeerSubject subject = {
      claims_of_triangles("Mesa llvmpipe", version.c_str(), kNearestAndBilinear, kClamp | kWrap, 0),
      paint_with_llvmpipe};
  return subject;
}

}  // namespace selvage::reports
