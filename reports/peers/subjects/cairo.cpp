// Paths are filled with a pattern under an affine matrix that has an inverse; EXTEND_PAD clamps,
// EXTEND_REPEAT repeats (cairo manual, cairo_pattern_t). A clip is a path: a rectangle.
// ANTIALIAS_NONE is "a bilevel alpha mask" (cairo_antialias_t), of which samples and ties are not
// specified. The pictures are RGB565: those of 32 bits are premultiplied, and no coordinate texture
// is. So there is no filter either.
#include <cairo.h>

#include "reports/peers/subjects/subject.h"

namespace selvage::reports {

const PeerSubject& peer_subject() {
  static const PeerSubject subject = [] {
    selvage_claims claims = claims_of_triangles("Cairo", cairo_version_string(), kNearest,
                                                kClamp | kWrap, SELVAGE_LACKS_PERSPECTIVE);
    claims.formats = 1u << SELVAGE_RGB565;
    return PeerSubject{claims, paint_with_cairo};
  }();
  return subject;
}

}  // namespace selvage::reports
