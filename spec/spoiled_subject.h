// Mappers that are right but for one pixel of one drawing: what audits of verifiers draw with.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "spec/subject.h"

namespace selvage::spec {

// Which of the drawings that a law makes.
struct Moment {
  enum class Kind {
    kAny,
    kDrawing,  // number of them: each is two calls, over two backgrounds
    kTile,     // one through a clip, of a case without one
    kKernel,   // one by kernel `number`
    kThreads   // one of many polygons, by `number` threads
  };
  Kind kind = Kind::kAny;
  int32_t number = 0;
};

// What is wrong with the pixel.
enum class Spoiling {
  kToggled,    // drawn where it should not be, or not where it should
  kOtherBits,  // every bit
  kPainted,    // a value that neither background nor texture has
  kDependent   // what was there shows
};

struct Spot {
  Moment when{};
  Spoiling how = Spoiling::kToggled;
  int32_t x_px = 0, y_px = 0;
};

// The mapper that this program is linked with, wrong in the spot alone. It counts its calls: each
// check wants one of its own.
[[nodiscard]] Subject wrong_in(const Spot& spot, selvage_profile profile);

// The right one, which adds up the pixels that its calls change.
[[nodiscard]] Subject counting(std::shared_ptr<uint64_t> drawn_px, selvage_profile profile);

}  // namespace selvage::spec
