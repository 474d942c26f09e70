// Where search matters hunting needs fewer cases than chance: medians over fixed seeds, the same on
// every machine.
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <string_view>

#include "coverage/wrong_mappers.h"
#include "first_kill.h"

namespace selvage::test {
namespace {

inline constexpr uint64_t kSeeds = 7, kMost = 1000;

[[nodiscard]] Gain gain_by(const char* law, const spec::Subject& subject) {
  return gain_of(*spec::find_law(law), subject, kSeeds, kMost);
}

[[nodiscard]] const spec::Subject& of_the_catalogue(std::string_view name) {
  for (const auto& wrong : coverage::wrong_mappers()) {
    if (wrong.subject.name == name) return wrong.subject;
  }
  throw std::out_of_range(std::string(name));
}

// The smaller the error, the fewer cases tell: chance needs more and more of them.
TEST(HuntGain, FindsSmallErrorsOfEdgesSooner) {
  for (const unsigned bits : {16U, 20U, 24U, 28U}) {
    const Gain gain = gain_by("COV", edges_of(bits));
    EXPECT_LE(2 * gain.hunted, gain.random) << bits << " bits";
    EXPECT_LE(gain.random, kMost) << bits << " bits: there is one to be found";
  }
}

TEST(HuntGain, FindsWrongEdgesOfTheCatalogueSooner) {
  for (const char* name : {"error_term_off_by_one", "edges_in_float", "large_area_overflows"}) {
    const Gain gain = gain_by("COV", of_the_catalogue(name));
    EXPECT_LT(gain.hunted, gain.random) << name;
  }
}

TEST(HuntGain, FindsSmallErrorsOfFiltersSooner) {
  const Gain gain = gain_by("FILTER", weights_of(28));
  EXPECT_LT(gain.hunted, gain.random);
  EXPECT_LE(gain.random, kMost);
}

TEST(HuntGain, IsTheSameAgain) {
  const spec::Law& law = *spec::find_law("COV");
  const spec::Subject wrong = edges_of(20);
  EXPECT_EQ(first_kill_by_hunting(law, wrong, 5, kMost),
            first_kill_by_hunting(law, wrong, 5, kMost));
  EXPECT_EQ(first_kill_at_random(law, wrong, 5, kMost), first_kill_at_random(law, wrong, 5, kMost));
}

}  // namespace
}  // namespace selvage::test
