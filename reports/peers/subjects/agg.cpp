// Vertices are 24.8 (agg_rasterizer_scanline_aa.h), a pixel is covered by area, here from a half
// on; texture coordinates are 24.8 (agg_span_interpolator_linear.h). image_accessor_clone clamps,
// image_accessor_wrap repeats; renderer_base has a clip box.
#include "reports/peers/subjects/subject.h"

namespace selvage::reports {

const PeerSubject& peer_subject() {
  static const PeerSubject subject = {
      claims_of_triangles("Anti-Grain Geometry", SELVAGE_PEER_MODULE_VERSION, kNearestAndBilinear,
                          kClamp | kWrap, 0),
      paint_with_agg};
  return subject;
}

}  // namespace selvage::reports
