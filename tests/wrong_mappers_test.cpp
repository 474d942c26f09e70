// The laws are tested: each rejects the wrong mappers of the catalogue that are its to reject.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "coverage/wrong_mappers.h"
#include "spec/laws.h"
#include "spec/profiles.h"
#include "spec/verify.h"

namespace selvage {
namespace {

using coverage::WrongMapper;

inline constexpr uint64_t kMostCases = 1500;
inline constexpr size_t kMostVertices = 4;  // no bug of the catalogue needs more to be seen

// Only ORACLE may be missing, in a build without OpenCV; MAP must then do its work.
[[nodiscard]] const spec::Law* law_against(const WrongMapper& wrong) {
  const spec::Law* law = spec::find_law(wrong.killer);
  return law == nullptr && wrong.killer == "ORACLE" ? spec::find_law("MAP") : law;
}

class WrongMappers : public testing::TestWithParam<const WrongMapper*> {};

TEST_P(WrongMappers, AreRejected) {
  const WrongMapper& wrong = *GetParam();
  const selvage_profile profile = wrong.subject.profile;
  const spec::Law* law = law_against(wrong);
  ASSERT_NE(law, nullptr) << wrong.killer;
  ASSERT_TRUE(spec::is_promised(profile, law->name)) << "the right mapper may break it too";
  const spec::LawVerdict verdict = spec::verify(*law, wrong.subject, /*first_seed=*/1, kMostCases);
  ASSERT_TRUE(verdict.violation) << law->name << " accepts a mapper although " << wrong.bug;
  EXPECT_EQ(verdict.violation->law, law->name);
  EXPECT_FALSE(verdict.violation->allowed.empty());
  EXPECT_FALSE(verdict.violation->drawn.empty());
  EXPECT_LE(verdict.counterexample->vertices.size(), kMostVertices) << explain(*verdict.violation);
  // The counterexample replays, from its text too.
  const auto replayed = spec::from_hex(spec::to_hex(*verdict.counterexample));
  ASSERT_TRUE(replayed);
  EXPECT_EQ(replayed->profile, profile);
  EXPECT_TRUE(law->check(wrong.subject, *replayed).violation);
  EXPECT_FALSE(law->check(spec::built_in(profile), *replayed).violation);
  EXPECT_FALSE(law->check(coverage::right_mapper(profile), *replayed).violation);
}

[[nodiscard]] std::vector<const WrongMapper*> every_wrong_mapper() {
  std::vector<const WrongMapper*> all;
  for (const WrongMapper& wrong : coverage::wrong_mappers()) all.push_back(&wrong);
  return all;
}

INSTANTIATE_TEST_SUITE_P(Catalogue, WrongMappers, testing::ValuesIn(every_wrong_mapper()),
                         [](const auto& of) { return of.param->name; });

// Of every law in every profile that promises it: a law that rejects nothing may say nothing.
TEST(Catalogue, GivesEveryPromiseSomethingToReject) {
  std::set<std::pair<selvage_profile, std::string_view>> killers;
  for (const WrongMapper& wrong : coverage::wrong_mappers()) {
    killers.emplace(wrong.subject.profile, wrong.killer);
  }
  for (const spec::Profile& profile : spec::profiles()) {
    for (const spec::Law& law : spec::laws()) {
      if (!spec::is_promised(profile.id, law.name)) continue;
      EXPECT_TRUE(killers.contains({profile.id, law.name})) << profile.name << " " << law.name;
    }
  }
}

// A unit in the last place lies within every bound and breaks no symmetry: without law DDA it would
// pass.
TEST(Catalogue, HasABugThatOnlyTheArithmeticShows) {
  const auto found = std::ranges::find(coverage::wrong_mappers(), "abrash57_half_step_toward_zero",
                                       &WrongMapper::name);
  ASSERT_NE(found, coverage::wrong_mappers().end());
  ASSERT_EQ(found->killer, "DDA");
  for (const spec::Law& law : spec::laws()) {
    if (law.name == found->killer || !spec::is_promised(found->subject.profile, law.name)) continue;
    const spec::LawVerdict verdict =
        spec::verify(law, found->subject, /*first_seed=*/1, kMostCases);
    EXPECT_FALSE(verdict.violation) << explain(*verdict.violation);
  }
}

class RightMappers : public testing::TestWithParam<const spec::Profile*> {};

// A recipe that broke a law by itself would make every rejection above worthless.
TEST_P(RightMappers, KeepEveryPromise) {
  const spec::Profile& profile = *GetParam();
  const spec::Subject right = coverage::right_mapper(profile.id);
  for (const spec::Law& law : spec::laws()) {
    if (!spec::is_promised(profile.id, law.name)) continue;
    const spec::LawVerdict verdict = spec::verify(law, right, /*first_seed=*/1, 150);
    EXPECT_FALSE(verdict.violation) << explain(*verdict.violation);
    EXPECT_GT(verdict.judged_px, 0U) << law.name;
  }
}

[[nodiscard]] std::vector<const spec::Profile*> every_profile() {
  std::vector<const spec::Profile*> all;
  for (const spec::Profile& profile : spec::profiles()) all.push_back(&profile);
  return all;
}

INSTANTIATE_TEST_SUITE_P(Catalogue, RightMappers, testing::ValuesIn(every_profile()),
                         [](const auto& of) { return std::string(of.param->name); });

}  // namespace
}  // namespace selvage
