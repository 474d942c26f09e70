// How far from its exact place a texel may be: the same question for a historic profile's bound,
// for a tolerance that is asked for and for an accuracy that is claimed.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "spec/exact.h"
#include "spec/geometry.h"
#include "spec/laws.h"
#include "spec/reach.h"

namespace selvage::spec {

// The texels along one axis that a mapper may reach, before they are addressed into `size`.
struct TexelRange {
  int32_t first, last, size;
  selvage_address address;

  // The addressed texel is one of them.
  [[nodiscard]] bool holds(int32_t texel) const;
  // As they are addressed: "3", "3 .. 5", "6 .. 7 or 0 .. 1".
  [[nodiscard]] std::string text() const;
};

// How much of the reach [exact - below, exact + above] it takes to get to a texel that addresses to
// `texel`: the least. Empty where there is no reach, or not there.
struct Reaching {
  Rational exact, below, above;
};
[[nodiscard]] std::optional<Margin> margin_along(const Reaching& reach, int32_t texel, int32_t size,
                                                 selvage_address address);

// Keeps the margin that is nearer to its bound; of equal ones the one with the larger, so that the
// order in which they come makes no difference.
void add(std::optional<Margin>* nearest, const std::optional<Margin>& other);

// Equally far in every direction.
[[nodiscard]] inline Reach reach_around(const Sample& exact, const Rational& texels) {
  return {exact.u, exact.v, texels, texels, texels, texels};
}

// How far off the subject claims its texels to be at most, in texels.
[[nodiscard]] inline Rational accuracy_of(const Capabilities& claims) {
  Rational texels(claims.accuracy_fx16, SELVAGE_SUBTEXELS);
  texels.canonicalize();
  return texels;
}
[[nodiscard]] inline Rational accuracy_of(const Subject& subject) {
  return accuracy_of(subject.claims);
}

// From where the case's profile takes a texel at `exact` to this one, addressed; empty if it is the
// one that is taken there. It may be 0 all the same, for a texel ends before its right border.
[[nodiscard]] std::optional<Offset> offset_to(const Texel& texel, const Sample& exact,
                                              const Case& shown);

// A law that says of each pixel which texels it may show.
struct TexelLaw {
  std::string_view name;
  std::string what;
  const Case& shown;

  // Whether a pixel that was drawn shows the texel of some (u, v) within reach. It is counted, and
  // its margin is kept, or else the violation.
  [[nodiscard]] bool judge(Pixel at, const Reach& reach, uint32_t drawn,
                           Judgement* judgement) const;
};

}  // namespace selvage::spec
