// How many cases it takes to reject a wrong mapper, at random and hunted, and mappers that are
// wrong by little.
#pragma once

#include <cstdint>
#include <vector>

#include "spec/laws.h"

namespace selvage::test {

// The number of the first case that the law rejects, from 1 on; most + 1 if none is. A mapper's
// exception is its crash.
[[nodiscard]] uint64_t first_kill_at_random(const spec::Law& law, const spec::Subject& subject,
                                            uint64_t seed, uint64_t most);
[[nodiscard]] uint64_t first_kill_by_hunting(const spec::Law& law, const spec::Subject& subject,
                                             uint64_t seed, uint64_t most);

// Medians over so many seeds, always the same ones.
struct Gain {
  uint64_t random, hunted;
};
[[nodiscard]] Gain gain_of(const spec::Law& law, const spec::Subject& subject, uint64_t seeds,
                           uint64_t most);

// Rounded to 2^-bits: u and v, in texels; where edges cross rows, in pixels; what a bilinear filter
// weighs by.
[[nodiscard]] spec::Subject coordinates_of(unsigned bits);
[[nodiscard]] spec::Subject edges_of(unsigned bits);
[[nodiscard]] spec::Subject weights_of(unsigned bits);

}  // namespace selvage::test
