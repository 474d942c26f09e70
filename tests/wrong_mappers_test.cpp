// The laws are tested: each rejects the wrong mappers of the catalogue that are its to reject.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "coverage/wrong_mappers.h"
#include "spec/generate.h"
#include "spec/laws.h"
#include "spec/verify.h"

namespace selvage {
namespace {

using coverage::WrongMapper;

inline constexpr uint64_t kMostCases = 1500;

class WrongMappers : public testing::TestWithParam<const WrongMapper*> {};

TEST_P(WrongMappers, AreRejected) {
  const WrongMapper& wrong = *GetParam();
  const spec::Law* law = spec::find_law(wrong.killer);
  if (law == nullptr) {
    // Only ORACLE may be missing, in a build without OpenCV; MAP must then do its work.
    ASSERT_EQ(wrong.killer, "ORACLE");
    law = spec::find_law("MAP");
  }
  const spec::LawVerdict verdict = spec::verify(*law, wrong.subject, /*first_seed=*/1, kMostCases);
  ASSERT_TRUE(verdict.violation) << law->name << " accepts a mapper although " << wrong.bug;
  EXPECT_EQ(verdict.violation->law, law->name);
  EXPECT_FALSE(verdict.violation->allowed.empty());
  EXPECT_FALSE(verdict.violation->drawn.empty());
  // The counterexample replays, from its text too.
  const auto replayed = spec::from_hex(spec::to_hex(*verdict.counterexample));
  ASSERT_TRUE(replayed);
  EXPECT_TRUE(law->check(wrong.subject, *replayed).violation);
  EXPECT_FALSE(law->check(spec::built_in(), *replayed).violation);
}

[[nodiscard]] std::vector<const WrongMapper*> every_wrong_mapper() {
  std::vector<const WrongMapper*> all;
  for (const WrongMapper& wrong : coverage::wrong_mappers()) all.push_back(&wrong);
  return all;
}

INSTANTIATE_TEST_SUITE_P(Catalogue, WrongMappers, testing::ValuesIn(every_wrong_mapper()),
                         [](const auto& of) { return std::string(of.param->name); });

TEST(Catalogue, GivesEveryLawSomethingToReject) {
  std::set<std::string_view> killers;
  for (const WrongMapper& wrong : coverage::wrong_mappers()) killers.insert(wrong.killer);
  for (const spec::Law& law : spec::laws()) EXPECT_TRUE(killers.contains(law.name)) << law.name;
}

// A recipe that broke a law by itself would make every rejection above worthless.
TEST(Catalogue, StartsFromARightMapper) {
  const spec::Subject right = coverage::right_mapper();
  for (const spec::Law& law : spec::laws()) {
    const spec::LawVerdict verdict = spec::verify(law, right, /*first_seed=*/1, 150);
    EXPECT_FALSE(verdict.violation) << explain(*verdict.violation);
    EXPECT_GT(verdict.judged_px, 0U) << law.name;
  }
}

}  // namespace
}  // namespace selvage
