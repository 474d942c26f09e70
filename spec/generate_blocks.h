// Rectangles that are not transformed, and what is nearly one.
#pragma once

#include "spec/case.h"
#include "spec/random.h"

namespace selvage::spec {

// Gives a case of a historic profile the outline of a block: axis-aligned, one texel to a pixel,
// clockwise from any corner. Rather more often than not one thing about it is spoiled, so that it
// is none.
void make_block(Random& random, Case* c);

}  // namespace selvage::spec
