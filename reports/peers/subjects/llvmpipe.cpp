// OpenGL: a fragment is produced where its centre lies in the polygon; of a centre on a common edge
// exactly one of two polygons does (specification 1.1 to 4.6, "Basic Polygon Rasterization"), which
// is not said. The specification "is not pixel exact" (appendix "Invariance"). Texel (i, j) is at
// (floor u, floor v). Coordinates are single precision. The clip is the scissor box.
#include <string>

#include "reports/peers/peer.h"
#include "reports/peers/subjects/subject.h"

namespace selvage::reports {

namespace {

// "22.3.6 (LLVM 15.0.6, 256 bits)" of "4.5 (Compatibility Profile) Mesa 22.3.6, llvmpipe (LLVM
// 15.0.6, 256 bits)"; another driver remains to be seen.
std::string version_in(const std::string& description) {
  const std::string before = "Mesa ", driver = ", llvmpipe";
  const size_t mesa = description.find(before);
  if (mesa == std::string::npos) return description;
  std::string version = description.substr(mesa + before.size());
  const size_t at = version.find(driver);
  return at == std::string::npos ? version : version.erase(at, driver.size());
}

}  // namespace

const PeerSubject& peer_subject() {
  static const std::string version = version_in(peer_llvmpipe().build_information);
  static const PeerSubject subject = {
      claims_of_triangles("Mesa llvmpipe", version.c_str(), kNearestAndBilinear, kClamp | kWrap, 0),
      paint_with_llvmpipe};
  return subject;
}

}  // namespace selvage::reports
