// The laws are tested: each rejects the wrong mappers of the catalogue that are its to reject.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "coverage/counterexample_size.h"
#include "coverage/matrix/expected.h"
#include "coverage/wrong_mappers.h"
#include "spec/laws.h"
#include "spec/profiles.h"
#include "spec/verify.h"

namespace selvage {
namespace {

using coverage::ExpectedKillers;
using coverage::WrongMapper;

inline constexpr uint64_t kFewCases = 300;

// Only ORACLE may be missing, in a build without OpenCV; MAP must then do its work.
[[nodiscard]] const spec::Law* law_against(const WrongMapper& wrong) {
  const spec::Law* law = spec::find_law(wrong.killer);
  return law == nullptr && wrong.killer == "ORACLE" ? spec::find_law("MAP") : law;
}

void expect_small(const spec::Case& c, const WrongMapper& wrong) {
  const coverage::CounterexampleSize size = coverage::size_of(c);
  const coverage::CounterexampleSize most = coverage::largest_counterexample(wrong.name);
  EXPECT_LE(size.vertices, most.vertices) << print(c);
  EXPECT_LE(size.target_px, most.target_px) << print(c);
  EXPECT_LE(size.texture_texel, most.texture_texel) << print(c);
}

class WrongMappers : public testing::TestWithParam<const WrongMapper*> {};

TEST_P(WrongMappers, AreRejected) {
  const WrongMapper& wrong = *GetParam();
  const selvage_profile profile = wrong.subject.profile;
  const spec::Law* law = law_against(wrong);
  ASSERT_NE(law, nullptr) << wrong.killer;
  ASSERT_TRUE(spec::is_promised(profile, law->name)) << "the right mapper may break it too";
  const spec::LawVerdict verdict =
      spec::verify(*law, wrong.subject, /*first_seed=*/1, coverage::kKillerCases);
  ASSERT_TRUE(verdict.violation) << law->name << " accepts a mapper although " << wrong.bug;
  EXPECT_EQ(verdict.violation->law, law->name);
  EXPECT_FALSE(verdict.violation->allowed.empty());
  EXPECT_FALSE(verdict.violation->drawn.empty());
  expect_small(*verdict.counterexample, wrong);
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

// Exceptions have a reason, and are of mappers that there are.
TEST(Catalogue, ArguesForEachLargeCounterexample) {
  for (const coverage::LargeCounterexample& large : coverage::large_counterexamples()) {
    EXPECT_EQ(std::ranges::count(coverage::wrong_mappers(), large.mapper, &WrongMapper::name), 1)
        << large.mapper;
    EXPECT_FALSE(large.why.empty()) << large.mapper;
  }
}

[[nodiscard]] ExpectedKillers expected_killers() {
  std::ifstream file(SELVAGE_SOURCE_DIR "/coverage/expected_killers.txt");
  EXPECT_TRUE(file) << "coverage/killers --write makes it";
  return coverage::read_expected(file);
}

TEST(ExpectedKillers, NameEachWrongMapperAndItsKiller) {
  const ExpectedKillers expected = expected_killers();
  EXPECT_EQ(expected.size(), coverage::wrong_mappers().size());
  for (const WrongMapper& wrong : coverage::wrong_mappers()) {
    const auto entry = expected.find(wrong.name);
    ASSERT_NE(entry, expected.end()) << wrong.name << ": coverage/killers --write";
    EXPECT_TRUE(entry->second.contains(std::string(wrong.killer))) << wrong.name;
    for (const std::string& law : entry->second) {
      EXPECT_TRUE(spec::is_promised(wrong.subject.profile, law)) << wrong.name << " " << law;
    }
  }
}

// By the whole matrix, not only by the laws that the catalogue names.
TEST(ExpectedKillers, LetNoLawKillNothing) {
  const ExpectedKillers expected = expected_killers();
  for (const spec::Law& law : spec::laws()) {
    const auto kills = std::ranges::count_if(
        expected, [&](const auto& entry) { return entry.second.contains(std::string(law.name)); });
    EXPECT_GT(kills, 0) << law.name;
  }
}

TEST(ExpectedKillers, NamesALineThatIsNone) {
  std::istringstream no_mapper("# fine\none: COV\nCOV MAP\n"), twice("one: COV\none: MAP\n");
  EXPECT_THROW((void)coverage::read_expected(no_mapper), std::runtime_error);
  EXPECT_THROW((void)coverage::read_expected(twice), std::runtime_error);
}

// The matrix tells one that is killed from one that is not, and what is not promised from both.
TEST(Matrix, TellsFatesApart) {
  const auto named = [](std::string_view name) {
    return &*std::ranges::find(coverage::wrong_mappers(), name, &WrongMapper::name);
  };
  const coverage::Budget few{.cases = 30, .killer_cases = 30};
  const coverage::Matrix matrix =
      coverage::fill({named("draws_nothing"), named("dkit_floors_texels")}, few, /*threads=*/2);
  const auto fate = [&](size_t row, std::string_view law) {
    const auto at = std::ranges::find(spec::laws(), law, &spec::Law::name) - spec::laws().begin();
    return matrix.rows[row].cells[static_cast<size_t>(at)].fate;
  };
  EXPECT_EQ(fate(0, "COV"), coverage::Fate::kKilled);
  EXPECT_EQ(fate(0, "ORDER"), coverage::Fate::kPassed);
  EXPECT_EQ(fate(0, "MAP"), coverage::Fate::kNotJudged);  // nothing is drawn
  EXPECT_EQ(fate(0, "DDA"), coverage::Fate::kNotPromised);
  EXPECT_EQ(fate(1, "MAP"), coverage::Fate::kKilled);
  EXPECT_EQ(fate(1, "COV"), coverage::Fate::kPassed);
  EXPECT_EQ(fate(1, "PART"), coverage::Fate::kNotPromised);
  EXPECT_GT(kills_of(matrix.rows[1]), 0U);
}

TEST(Matrix, TellsWhatTheTableDoesNot) {
  const auto& wrong = coverage::wrong_mappers().front();
  coverage::Matrix matrix{{}, {{&wrong, std::vector<coverage::Cell>(spec::laws().size())}}};
  matrix.rows[0].cells[0] = {coverage::Fate::kKilled, 1};
  const std::string law(spec::laws()[0].name), other(spec::laws()[1].name);
  EXPECT_TRUE(differences({{wrong.name, {law}}}, matrix).empty());
  EXPECT_EQ(differences({{wrong.name, {other}}}, matrix).size(), 2U);
  EXPECT_EQ(differences({}, matrix).size(), 1U);
  std::istringstream written(expected_text(matrix));
  EXPECT_EQ(coverage::read_expected(written), expected_of(matrix));
  EXPECT_EQ(tally(matrix, 0).sole, 1U);
  EXPECT_EQ(tally(matrix, 1).kills, 0U);
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
    const spec::LawVerdict verdict = spec::verify(law, found->subject, /*first_seed=*/1, kFewCases);
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
