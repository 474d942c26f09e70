// pixman/rounding.txt: samples at half pixels; "we usually break ties by rounding down"; nearest is
// floor(x - e), e = 1/65536. Triangles and matrices are 16.16; what does not fit is refused.
// REPEAT_PAD clamps, REPEAT_NORMAL repeats; the clip is a region of the target.
#include <pixman.h>

#include "reports/peers/subjects/subject.h"

namespace selvage::reports {

const PeerSubject& peer_subject() {
  static const PeerSubject subject = {claims_of_triangles("pixman", pixman_version_string(),
                                                          kNearestAndBilinear, kClamp | kWrap, 0),
                                      paint_with_pixman};
  return subject;
}

}  // namespace selvage::reports
