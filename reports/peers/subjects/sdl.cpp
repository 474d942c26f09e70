// SDL_RenderGeometry: triangles alone, affine, "normalized texture coordinates" (SDL_render.h) in
// [0, 1]; no filter but nearest for triangles. Which pixels are covered is not said.
#include "reports/peers/subjects/subject.h"

namespace selvage::reports {

const PeerSubject& peer_subject() {
  static const PeerSubject subject = {
      claims_of_triangles("SDL software renderer", SELVAGE_PEER_MODULE_VERSION, kNearest, kClamp,
                          SELVAGE_LACKS_PERSPECTIVE | SELVAGE_LACKS_OUTSIDE_TEXELS),
      paint_with_sdl};
  return subject;
}

}  // namespace selvage::reports
