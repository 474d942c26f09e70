// A polygon filled with a texture brush, which repeats the texture (QBrush); its transform goes
// from texture to target and must have an inverse. setClipRect clips. QPainter and "Coordinate
// System" do not say which pixels an outline with fractions covers without antialiasing.
#include <QtCore/QtGlobal>

#include "reports/peers/subjects/subject.h"

namespace selvage::reports {

const PeerSubject& peer_subject() {
  static const PeerSubject subject = {
      claims_of_triangles("Qt", qVersion(), kNearestAndBilinear, kWrap, 0), paint_with_qt};
  return subject;
}

}  // namespace selvage::reports
