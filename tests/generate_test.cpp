// The generator of cases: repeatable and in range.
#include "spec/generate.h"

#include <gtest/gtest.h>

#include <limits>

#include "case_support.h"

namespace selvage::spec {
namespace {

TEST(Generate, StaysInRange) {
  for (uint64_t seed = 0; seed < 50000; ++seed) {
    const Case c = generate(seed);
    ASSERT_EQ(out_of_range(c), "") << "seed " << seed;
    ASSERT_TRUE(decode(encode(c)) == c) << "seed " << seed;
  }
  EXPECT_EQ(out_of_range(generate(std::numeric_limits<uint64_t>::max())), "");
}

// FNV-1a over the encodings. Seeds in bug reports mean the same cases only while this stays: change
// it only with the generator.
TEST(Generate, MeansTheSameCasesOnEveryMachine) {
  uint64_t hash = 0xcbf29ce484222325u;
  for (uint64_t seed = 0; seed < 1000; ++seed) {
    for (const uint8_t byte : encode(generate(seed))) hash = (hash ^ byte) * 0x100000001b3u;
  }
  EXPECT_EQ(hash, 0x957f47b5fe6763f6u);
}

TEST(Generate, MakesDifferentCasesOfNeighbouringSeeds) {
  for (uint64_t seed = 0; seed < 1000; ++seed) {
    EXPECT_FALSE(generate(seed) == generate(seed + 1)) << seed;
    EXPECT_TRUE(generate(seed) == generate(seed)) << seed;
  }
}

}  // namespace
}  // namespace selvage::spec
