#include "scene/motion.h"

#include <numbers>

namespace selvage::scene {

Placement placed(const Motion& motion, double time_s) {
  const double angle_rad = (motion.angle_deg + motion.spin_deg * time_s) * (std::numbers::pi / 180);
  Placement placement = Placement::Identity();
  placement.translate(motion.position + motion.velocity * time_s);
  placement.rotate(Eigen::AngleAxisd(angle_rad, motion.axis.stableNormalized()));
  placement.scale(motion.scale);
  return placement;
}

}  // namespace selvage::scene
