#include "reports/peers/peer.h"

namespace selvage::reports {

namespace {

// Which of the two are called depends on what was found.
[[maybe_unused]] void add(Peers& all, Peer peer) {
  all.build_information[peer.subject.id] = std::move(peer.build_information);
  all.subjects.push_back(std::move(peer.subject));
}

[[maybe_unused]] void miss(Peers& all, const std::string& name, const std::string& package) {
  all.absent.push_back(name + ": " + package + " was not there when this was configured");
}

}  // namespace

// A peer that was not found has no definition: its call is in a discarded statement.
Peers peers() {
  Peers all;
#define SELVAGE_ADD(found, make, name, package) \
  if constexpr (found)                          \
    add(all, make());                           \
  else                                          \
    miss(all, name, package)
  SELVAGE_ADD(SELVAGE_PEER_OPENCV, peer_opencv, "OpenCV", "libopencv-imgproc-dev");
#if SELVAGE_PEERS_ALL
  SELVAGE_ADD(SELVAGE_PEER_QT, peer_qt, "Qt", "qt6-base-dev");
  SELVAGE_ADD(SELVAGE_PEER_ALLEGRO, peer_allegro, "Allegro", "liballegro4-dev");
  SELVAGE_ADD(SELVAGE_PEER_LLVMPIPE, peer_llvmpipe, "llvmpipe", "libosmesa6-dev");
  SELVAGE_ADD(SELVAGE_PEER_SDL, peer_sdl, "SDL", "libsdl2-dev");
  SELVAGE_ADD(SELVAGE_PEER_PIXMAN, peer_pixman, "pixman", "libpixman-1-dev");
  SELVAGE_ADD(SELVAGE_PEER_CAIRO, peer_cairo, "Cairo", "libcairo2-dev");
  SELVAGE_ADD(SELVAGE_PEER_AGG, peer_agg, "AGG", "libagg-dev");
#else
  all.absent.emplace_back(
      "Qt, Allegro, llvmpipe, SDL, pixman, Cairo, AGG: this program does not link them; "
      "reports/run measures those that are installed, with selvage_with_peers");
#endif
#undef SELVAGE_ADD
  return all;
}

}  // namespace selvage::reports
