// Where an object stands and how it moves. Every object has its own.
#pragma once

#include "scene/vectors.h"

namespace selvage::scene {

struct Motion {
  Vector3 position = Vector3::Zero();
  Vector3 velocity = Vector3::Zero();  // a second
  Vector3 axis = Vector3::UnitY();     // of the rotation, through the object's own origin
  double angle_deg = 0;
  double spin_deg = 0;  // a second
  double scale = 1;
};

// From the object's space to the world's.
[[nodiscard]] Placement placed(const Motion& motion, double time_s);

}  // namespace selvage::scene
