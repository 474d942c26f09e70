// Paths are filled with a pattern under an affine matrix that has an inverse; EXTEND_PAD clamps,
// EXTEND_REPEAT repeats (cairo manual, cairo_pattern_t). A clip is a path: a rectangle.
// ANTIALIAS_NONE is "a bilevel alpha mask" (cairo_antialias_t), of which samples and ties are not
// specified.
#include <cairo.h>

#include "reports/peers/subjects/subject.h"

namespace selvage::reports {

const PeerSubject& peer_subject() {
  static const PeerSubject subject = {
      claims_of_triangles("Cairo", cairo_version_string(), kNearestAndBilinear, kClamp | kWrap,
                          SELVAGE_LACKS_PERSPECTIVE),
      paint_with_cairo};
  return subject;
}

}  // namespace selvage::reports
