// polygon3d(3alleg4): no concave or self-intersecting shapes; "the width and height of the texture
// bitmap must be powers of two", and it is tiled; texels are blocks, "whole numbers for u and v
// refer to the top-left corner of a texel". Where pixels are sampled is not said. set_clip_rect
// clips.
#include "reports/peers/subjects/subject.h"

namespace selvage::reports {

const PeerSubject& peer_subject() {
  static const PeerSubject subject = [] {
    selvage_claims claims =
        claims_of_triangles("Allegro", SELVAGE_PEER_MODULE_VERSION, kNearest, kWrap,
                            SELVAGE_LACKS_CONCAVE | SELVAGE_LACKS_ANY_TEXTURE_SIDE);
    claims.most_vertices = 0;  // any number
    return PeerSubject{claims, paint_with_allegro};
  }();
  return subject;
}

}  // namespace selvage::reports
