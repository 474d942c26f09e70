// The hunt: mutated cases, their closeness, climbs.
#include "spec/hunt.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "case_support.h"
#include "spec/closeness.h"
#include "spec/generate.h"
#include "spec/generate_historic.h"
#include "spec/model.h"
#include "spec/profiles.h"

namespace selvage::spec {
namespace {

[[nodiscard]] std::vector<const Mutation*> every_mutation() {
  std::vector<const Mutation*> all;
  for (const auto mutations : {outline_mutations(), texel_mutations(), drawing_mutations()}) {
    for (const Mutation& mutation : mutations) all.push_back(&mutation);
  }
  return all;
}

TEST(MutateCase, StaysInRangeAndValid) {
  std::set<std::string_view> changing, names;
  for (const Profile& profile : profiles()) {
    for (uint64_t seed = 0; seed < 60; ++seed) {
      const Case c = generate(seed, profile.id);
      for (const Mutation* mutation : every_mutation()) {
        Random random(seed);
        const Case changed = mutated_by(*mutation, random, c);
        ASSERT_EQ(out_of_range(changed), "") << mutation->name << print(c) << print(changed);
        ASSERT_TRUE(decode(encode(changed)) == changed) << mutation->name << print(changed);
        ASSERT_EQ(changed.profile, profile.id);
        ASSERT_TRUE(is_valid(changed) || !is_valid(c)) << mutation->name << print(changed);
        names.insert(mutation->name);
        if (!(changed == c)) changing.insert(mutation->name);
      }
    }
  }
  EXPECT_EQ(changing, names) << "a mutation never changes anything";
}

TEST(MutateCase, StaysInRangeFromTheEndsOfEveryRange) {
  constexpr int32_t kLeast = std::numeric_limits<int32_t>::min();
  constexpr int32_t kGreatest = std::numeric_limits<int32_t>::max();
  Case c;
  c.target_width_px = 65536, c.target_height_px = 1;
  c.texture_width_texel = 1, c.texture_height_texel = 65536;
  c.has_clip = true;
  c.clip = {-32768, 32767, 32767, -32768};
  c.vertices = {{SELVAGE_X_MIN, SELVAGE_X_MIN, kLeast, kGreatest, SELVAGE_Q_MAX},
                {SELVAGE_X_END - 1, SELVAGE_X_MIN, kGreatest, kLeast, 1},
                {-1, SELVAGE_X_END - 1, -1, 1, 2}};
  for (uint64_t seed = 0; seed < 20; ++seed) {
    for (const Mutation* mutation : every_mutation()) {
      Random random(seed);
      const Case changed = mutated_by(*mutation, random, c);
      ASSERT_EQ(out_of_range(changed), "") << mutation->name << print(changed);
      ASSERT_TRUE(is_valid(changed)) << mutation->name << print(changed);
    }
  }
}

// A triangle over 8 x 8 px whose right edge leans by dx over a height that no row divides.
[[nodiscard]] Case triangle(int32_t dx_fx8, int32_t du_fx16, int32_t u_fx16 = 32768) {
  Case c;
  c.target_width_px = c.target_height_px = 8;
  const auto vertex = [&](int32_t x, int32_t y, int32_t u) {
    return selvage_vertex{x, y, u, 20000, 1};
  };
  c.vertices = {vertex(0, 0, u_fx16), vertex(1024, 0, u_fx16 + du_fx16),
                vertex(1024 + dx_fx8, 2047, u_fx16 + du_fx16)};
  return c;
}

TEST(Closeness, IsGreaterNearerToATie) {
  // The sample at 1/2 px of row 1/2 px from edges through x = 4 px + dx / 16, ...
  const Closeness far = closeness(triangle(77, 0)), near = closeness(triangle(3, 0));
  EXPECT_GT(far.edges, 0);
  EXPECT_NE(far.edges, near.edges);
  Case on_border = triangle(77, 100003), beside = on_border, inside = on_border;
  for (selvage_vertex& v : on_border.vertices) v.v = 65536;
  for (selvage_vertex& v : beside.vertices) v.v = 65535;
  for (selvage_vertex& v : inside.vertices) v.v = 32768;
  EXPECT_GT(closeness(beside).texels, closeness(inside).texels);
  EXPECT_GT(closeness(on_border).texels, closeness(inside).texels);
}

TEST(Closeness, CountsStepsThatFixedPointTakesExactlyForLess) {
  // u is constant along rows and columns, a unit below a whole texel; v walks by a third.
  Case whole = triangle(77, 0, 65535), thirds = whole;
  whole.vertices[1].v = whole.vertices[2].v = 65535;
  whole.vertices[0].v = 65535;
  thirds.vertices[1].u += 1;
  EXPECT_GT(closeness(thirds).texels, closeness(whole).texels);
}

TEST(Closeness, OfWhatIsNotDrawnIsNothing) {
  Case c;
  EXPECT_EQ(closeness(c), (Closeness{0, 0}));
  for (uint64_t seed = 0; seed < 300; ++seed) {
    const Case any = generate(seed);
    const Closeness near = closeness(any);
    EXPECT_GE(std::min(near.edges, near.texels), 0);
    EXPECT_LE(std::max(near.edges, near.texels), kPlaces * kMostBits);
    EXPECT_TRUE(is_valid(any) || near == (Closeness{0, 0}));
  }
}

const Law& map_law() { return *find_law("MAP"); }

// The cases of a climb whose every case is judged well.
[[nodiscard]] std::vector<Case> climbed(const Subject& subject, uint64_t seed, uint64_t number) {
  Climb climb(map_law(), subject, seed, number);
  std::vector<Case> cases;
  for (uint64_t step = 0; step < kClimbCases; ++step) {
    cases.push_back(climb.propose());
    climb.weigh(cases.back(), score_of(map_law(), cases.back(), std::nullopt));
  }
  return cases;
}

TEST(Climb, IsTheSameAgain) {
  for (const Profile& profile : profiles()) {
    const Subject subject = built_in(profile.id);
    EXPECT_EQ(climbed(subject, 5, 2), climbed(subject, 5, 2));
    EXPECT_NE(climbed(subject, 5, 2), climbed(subject, 5, 3));
    EXPECT_NE(climbed(subject, 5, 2), climbed(subject, 6, 2));
  }
}

TEST(Climb, AsksForNothingThatIsNotClaimed) {
  Subject subject = built_in();
  subject.claims.most_vertices = 3;
  subject.claims.perspective = subject.claims.clip = subject.claims.negative_pitch = false;
  subject.claims.formats = only(SELVAGE_RGB565);
  subject.claims.filters = only(SELVAGE_FILTER_NEAREST);
  subject.claims.winding = Winding::kClockwise;
  subject.claims.longest_side_px = 20;
  for (uint64_t number = 0; number < 10; ++number) {
    for (const Case& c : climbed(subject, 1, number)) {
      EXPECT_EQ(beyond(subject.claims, c).value_or(""), "") << print(c);
      EXPECT_EQ(out_of_range(c), "");
    }
  }
}

TEST(Climb, NeverGoesDownAndEndsHigher) {
  const Subject subject = built_in();
  double first = 0, last = 0;
  for (uint64_t number = 0; number < 20; ++number) {
    Climb climb(map_law(), subject, 1, number);
    std::optional<Score> before;
    for (uint64_t step = 0; step < kClimbCases; ++step) {
      const Case c = climb.propose();
      const Score score = score_of(map_law(), c, std::nullopt);
      climb.weigh(c, score);
      ASSERT_TRUE(climb.score());
      EXPECT_GE(climb.score()->closeness, before ? before->closeness : 0);
      EXPECT_GE(*climb.score(), score);
      if (!before) first += score.closeness;
      before = climb.score();
    }
    last += before->closeness;
  }
  EXPECT_GT(last, 1.2 * first);
}

TEST(Climb, WeighsWhatTheLawMeasuredFirst) {
  const Margin half{1, 2};
  const Case c = generate(3);
  const Score measured = score_of(map_law(), c, half), exact = score_of(map_law(), c, std::nullopt);
  EXPECT_EQ(measured.share, 0.5);
  EXPECT_EQ(exact.share, 0);
  EXPECT_GT(measured, exact);
  EXPECT_GT((Score{0.5, 0.1}), (Score{0.4, 0.9}));
  EXPECT_GT((Score{0.5, 0.2}), (Score{0.5, 0.1}));
}

// How a run is cut into climbs changes nothing.
TEST(Hunt, OfPartsAddsUpToTheWhole) {
  const Subject subject = built_in(SELVAGE_PROFILE_ABRASH56);
  Verification whole(map_law(), subject), odd(map_law(), subject), even(map_law(), subject);
  for (uint64_t number = 0; number < 4; ++number) {
    hunt(&whole, 9, number);
    hunt(number % 2 == 0 ? &even : &odd, 9, number);
  }
  const LawVerdict &all = whole.verdict(), &a = odd.verdict(), &b = even.verdict();
  ASSERT_FALSE(all.violation) << explain(*all.violation);
  EXPECT_EQ(all.cases, 4 * kClimbCases);
  EXPECT_EQ(all.hunted.cases, all.cases);
  EXPECT_EQ(a.hunted.cases + b.hunted.cases, all.hunted.cases);
  EXPECT_EQ(a.judged_px + b.judged_px, all.judged_px);
  ASSERT_TRUE(all.hunted.best && a.hunted.best && b.hunted.best);
  EXPECT_EQ(std::max(*a.hunted.best, *b.hunted.best), *all.hunted.best);
}

TEST(Hunt, NumbersAndShrinksWhatItFinds) {
  const Subject idle{"idle", [](auto...) { return SELVAGE_OK; }};
  Verification verification(*find_law("COV"), idle);
  hunt(&verification, 1, /*number=*/3);
  const LawVerdict& verdict = verification.verdict();
  ASSERT_TRUE(verdict.violation);
  EXPECT_TRUE(verdict.hunted.found);
  EXPECT_FALSE(verdict.hunted.best);
  EXPECT_EQ(verdict.failed_case, 3 * kClimbCases + verdict.hunted.cases - 1);
  EXPECT_EQ(verdict.counterexample->target_width_px, 1);
  const uint64_t cases = verdict.cases;
  hunt(&verification, 1, 4);
  EXPECT_EQ(verification.verdict().cases, cases) << "nothing happens once it is violated";
}

TEST(Hunt, TakesNoMoreCasesThanItMay) {
  const Subject subject = built_in();
  Verification verification(map_law(), subject);
  hunt(&verification, 1, 0, 5);
  EXPECT_EQ(verification.verdict().hunted.cases, 5U);
}

}  // namespace
}  // namespace selvage::spec
