// Whether a face is what the pipeline takes it for: plane and convex, but for how its file rounds.
#pragma once

#include <string>

#include "scene/object.h"

namespace selvage::scene {

// How far a corner may be from where it was meant, in the object's unit: files tell coordinates to
// six significant digits, which moves each by at most 5e-6 of the greatest, and so a corner by at
// most sqrt(3) times that. Single precision is finer.
[[nodiscard]] double corner_rounding(const Object& object);

// The root of the mean square of the corners' distances from the plane where it is least. Of a
// plane face whose corners were each moved by at most r it is at most r: it is so from that plane.
[[nodiscard]] double off_plane(const Object& object, const Face& face);

// Every corner turns the same way, seen along the normal, once around. Moving three corners a, b, c
// by at most r changes (b - a) x (c - b) by at most r (|ab| + |bc| + |ca|) + 3 r^2: so much may a
// corner turn the other way.
[[nodiscard]] bool is_convex(const Object& object, const Face& face, double rounding);

// What is wrong with the shape, and what would be right; empty if nothing is.
[[nodiscard]] std::string shape_problem(const Object& object, const Face& face, double rounding);

}  // namespace selvage::scene
