// Verification and shrinking, on laws made for the purpose.
#include "spec/verify.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "spec/complexity.h"
#include "spec/generate.h"
#include "spec/geometry.h"

namespace selvage::spec {
namespace {

constexpr uint64_t kJudgedPx = 3;

[[nodiscard]] Judgement judge(bool holds, const Case& c) {
  Judgement judgement;
  judgement.judged_px = kJudgedPx;
  if (holds) return judgement;
  judgement.violation.emplace();
  judgement.violation->shown = c;
  return judgement;
}

// Asks the subject, so that a test can count and see what is checked.
selvage_status ask(const Subject& subject, const Case& c) {
  return subject.draw(nullptr, nullptr, c.vertices.data(), c.vertices.size(), nullptr, nullptr);
}

const Law kHolds{"HOLDS", "always holds", [](const Subject& subject, const Case& c) {
                   (void)ask(subject, c);
                   return judge(true, c);
                 }};
const Law kFails{"FAILS", "never holds", [](const Subject& subject, const Case& c) {
                   (void)ask(subject, c);
                   return judge(false, c);
                 }};
const Law kNoClip{"NOCLIP", "there is no clip",
                  [](const Subject&, const Case& c) { return judge(!c.has_clip, c); }};
const Law kNear{"NEAR", "no vertex lies right of column 100", [](const Subject&, const Case& c) {
                  return judge(std::none_of(c.vertices.begin(), c.vertices.end(),
                                            [](const auto& v) { return v.x > 100 * 256; }),
                               c);
                }};
const Law kStatus{"STATUS", "the subject is content", [](const Subject& subject, const Case& c) {
                    return judge(ask(subject, c) == SELVAGE_OK, c);
                  }};

[[nodiscard]] Subject idle() {
  return {"idle", [](auto...) { return SELVAGE_OK; }};
}

[[nodiscard]] Subject counting(uint64_t* calls) {
  return {"counting", [calls](auto...) {
            ++*calls;
            return SELVAGE_OK;
          }};
}

[[nodiscard]] uint64_t first_seed_where(bool (*is)(const Case&)) {
  uint64_t seed = 0;
  while (!is(generate(seed))) ++seed;
  return seed;
}

TEST(Verify, CountsWhatItChecks) {
  uint64_t calls = 0;
  const LawVerdict verdict = verify(kHolds, counting(&calls), 7, 1000);
  EXPECT_EQ(verdict.law, &kHolds);
  EXPECT_EQ(verdict.cases, 1000U);
  EXPECT_EQ(calls, 1000U);
  EXPECT_EQ(verdict.judged_px, 1000 * kJudgedPx);
  EXPECT_FALSE(verdict.violation.has_value());
  EXPECT_FALSE(verdict.counterexample.has_value());
}

TEST(Verify, ChecksTheCasesOfItsSeeds) {
  const uint64_t first_seed = std::numeric_limits<uint64_t>::max() - 2;  // and on from 0
  std::vector<size_t> seen, wanted;
  const Subject watching{"watching",
                         [&](const selvage_image*, const selvage_rect*, const selvage_vertex*,
                             size_t count, const selvage_texture*, const selvage_options*) {
                           seen.push_back(count);
                           return SELVAGE_OK;
                         }};
  EXPECT_EQ(verify(kHolds, watching, first_seed, 40).cases, 40U);
  for (uint64_t i = 0; i < 40; ++i) wanted.push_back(generate(first_seed + i).vertices.size());
  EXPECT_EQ(seen, wanted);
}

TEST(Verify, ReportsProgressAboutAHundredTimes) {
  for (const uint64_t cases : {1U, 5U, 100U, 250U, 10000U}) {
    std::vector<uint64_t> reports;
    const auto report = [&](uint64_t done) { reports.push_back(done); };
    EXPECT_EQ(verify(kHolds, idle(), 0, cases, report).cases, cases);
    ASSERT_FALSE(reports.empty());
    EXPECT_EQ(reports.back(), cases);
    EXPECT_GE(reports.size(), std::min<uint64_t>(cases, 100));
    EXPECT_LT(reports.size(), 200U);
    EXPECT_TRUE(std::is_sorted(reports.begin(), reports.end()));
  }
}

TEST(Verify, OfNoCasesIsEmpty) {
  uint64_t calls = 0;
  const LawVerdict verdict = verify(kFails, counting(&calls), 0, 0, [](uint64_t) { FAIL(); });
  EXPECT_EQ(verdict.cases + verdict.judged_px + calls, 0U);
  EXPECT_FALSE(verdict.violation.has_value());
}

TEST(Verify, StopsAtTheFirstViolation) {
  const uint64_t seed = first_seed_where([](const Case& c) { return c.has_clip; });
  const LawVerdict verdict = verify(kNoClip, idle(), 0, 1000);
  EXPECT_EQ(verdict.cases, seed + 1);
  EXPECT_EQ(verdict.judged_px, kJudgedPx) << "of the case that fails";
  ASSERT_TRUE(verdict.violation && verdict.counterexample);
  EXPECT_TRUE(verdict.counterexample->has_clip);
  EXPECT_TRUE(verdict.violation->shown == *verdict.counterexample);
}

TEST(Verify, KeepsAViolationThatDoesNotReturn) {
  int calls = 0;
  const Subject fickle{
      "fickle", [&](auto...) { return ++calls == 3 ? SELVAGE_ERROR_VERTEX_COUNT : SELVAGE_OK; }};
  const LawVerdict verdict = verify(kStatus, fickle, 0, 10);
  EXPECT_EQ(verdict.cases, 3U);
  ASSERT_TRUE(verdict.violation && verdict.counterexample);
  EXPECT_TRUE(*verdict.counterexample == generate(2));
  EXPECT_TRUE(verdict.violation->shown == generate(2));
}

TEST(Shrink, EndsAtTheSimplestCase) {
  for (uint64_t seed = 0; seed < 200; ++seed) {
    const Case least = shrink(kFails, idle(), generate(seed));
    EXPECT_EQ(complexity(least), (Complexity{0, 2, 2, 0, 0, 0})) << print(least);
    EXPECT_TRUE(simpler(least).empty());
  }
}

TEST(Shrink, KeepsJustWhatTheLawNeeds) {
  const LawVerdict verdict = verify(kNear, idle(), 0, 10000);
  ASSERT_TRUE(verdict.counterexample.has_value());
  const Case& c = *verdict.counterexample;
  ASSERT_EQ(c.vertices.size(), 1U) << print(c);
  EXPECT_EQ(complexity(c), (Complexity{1, 2, 2, 0, 0, 101 * 256})) << print(c);
  EXPECT_EQ(c.vertices[0].x, 101 * 256);
}

TEST(Shrink, FindsTheSmallestTriangle) {
  const Law no_area{
      "AREA", "triangles have no area", [](const Subject&, const Case& c) {
        return judge(
            c.vertices.size() != 3 || doubled_area(position(c.vertices[0]), position(c.vertices[1]),
                                                   position(c.vertices[2])) == 0,
            c);
      }};
  int found = 0;
  for (uint64_t seed = 0; seed < 60; ++seed) {
    const Case c = generate(seed);
    if (!no_area.check(idle(), c).violation) continue;
    const Case least = shrink(no_area, idle(), c);
    EXPECT_EQ(complexity(least), (Complexity{3, 2, 2, 0, 0, 512})) << print(least);
    ++found;
  }
  EXPECT_GT(found, 5);
}

TEST(Shrink, KeepsFractionsAndPerspectiveWhereTheyMatter) {
  const Law rounded{
      "ROUND", "u is whole wherever q is above 1000", [](const Subject&, const Case& c) {
        return judge(std::none_of(c.vertices.begin(), c.vertices.end(),
                                  [](const auto& v) { return v.q > 1000 && v.u % 65536 != 0; }),
                     c);
      }};
  const LawVerdict verdict = verify(rounded, idle(), 0, 1000);
  ASSERT_TRUE(verdict.counterexample.has_value());
  const Case& c = *verdict.counterexample;
  ASSERT_EQ(c.vertices.size(), 1U) << print(c);
  EXPECT_EQ(c.vertices[0].q, 1001);
  EXPECT_NE(c.vertices[0].u % 65536, 0);
  EXPECT_EQ(c.vertices[0].u % 8192, 0) << "a rounder fraction would do";
}

TEST(Shrink, ChecksABoundedNumberOfCases) {
  const Law few{"FEW", "fewer than 60 vertices", [](const Subject& subject, const Case& c) {
                  (void)ask(subject, c);
                  return judge(c.vertices.size() < 60, c);
                }};
  uint64_t calls = 0;
  const uint64_t seed = first_seed_where([](const Case& c) { return c.vertices.size() > 120; });
  const Case least = shrink(few, counting(&calls), generate(seed));
  EXPECT_EQ(least.vertices.size(), 60U);
  EXPECT_LE(calls, 4000U);
}

// A subject that draws nothing, against the law of coverage: a triangle on a pixel is enough.
TEST(Shrink, WorksOnALawOfTheSpecification) {
  const LawVerdict verdict = verify(*find_law("COV"), idle(), 0, 100);
  ASSERT_TRUE(verdict.counterexample.has_value());
  const Case& c = *verdict.counterexample;
  EXPECT_EQ(c.vertices.size(), 3U) << print(c);
  EXPECT_EQ(c.target_width_px * c.target_height_px, 1) << print(c);
  EXPECT_EQ(complexity(c)[3], 0U) << print(c);
}

TEST(Simpler, LowersTheComplexityEachTime) {
  for (uint64_t seed = 0; seed < 500; ++seed) {
    const Case c = generate(seed);
    for (const Case& candidate : simpler(c)) {
      ASSERT_LT(complexity(candidate), complexity(c)) << print(c) << print(candidate);
      ASSERT_TRUE(decode(encode(candidate)) == candidate) << print(candidate);
    }
  }
}

TEST(Simpler, StaysInRangeFromTheEndsOfEveryRange) {
  constexpr int32_t kLeast = std::numeric_limits<int32_t>::min();
  constexpr int32_t kGreatest = std::numeric_limits<int32_t>::max();
  for (const int32_t end : {0, 1}) {
    Case c;
    c.target_width_px = end == 0 ? 65536 : 1;
    c.target_height_px = end == 0 ? 1 : 65536;
    c.has_clip = true;
    c.clip = {-32768, 32767, 32767, -32768};
    c.choice = std::numeric_limits<uint32_t>::max();
    c.vertices = {{SELVAGE_X_MIN, SELVAGE_X_END - 1, kLeast, kGreatest, SELVAGE_Q_MAX},
                  {SELVAGE_X_END - 1, SELVAGE_X_MIN, kGreatest, kLeast, 1},
                  {-1, 1, -1, 1, 2}};
    const std::vector<Case> candidates = simpler(c);
    EXPECT_GT(candidates.size(), 50U);
    for (const Case& candidate : candidates) {
      EXPECT_TRUE(decode(encode(candidate)) == candidate) << print(candidate);
      EXPECT_LT(complexity(candidate), complexity(c)) << print(candidate);
    }
  }
}

TEST(Simpler, OffersAReasonableNumberLargeStepsFirst) {
  for (uint64_t seed = 0; seed < 2000; ++seed) {
    const Case c = generate(seed);
    const std::vector<Case> candidates = simpler(c);
    if (c.vertices.size() <= 4) {
      EXPECT_LT(candidates.size(), 300U) << print(c);
    }
    if (c.vertices.empty()) continue;
    ASSERT_FALSE(candidates.empty());
    EXPECT_LE(candidates.front().vertices.size(), (c.vertices.size() + 1) / 2);
  }
}

// Even where only the last and least simplification ever works, descent ends.
TEST(SimplerAtLength, EndsOnTheSlowestWay) {
  Case c = generate(5);
  c.vertices.resize(std::min<size_t>(c.vertices.size(), 3));
  for (selvage_vertex& vertex : c.vertices) vertex.q = 1 + vertex.q % 50;
  c.choice %= 50;
  int steps = 0;
  for (std::vector<Case> next = simpler(c); !next.empty(); next = simpler(c)) {
    c = next.back();
    ASSERT_LT(++steps, 1000000);
  }
  EXPECT_EQ(complexity(c), (Complexity{0, 2, 2, 0, 0, 0}));
}

TEST(Complexity, WeighsInItsOrder) {
  Case c;
  const Complexity plain = complexity(c);
  EXPECT_EQ(plain, (Complexity{0, 32, 32, 0, 0, 0}));
  c.has_clip = c.flip_target = c.flip_texture = true;
  c.clip = {-1, 2, 3, -4};
  c.padding_px = 5;
  c.address = SELVAGE_ADDRESS_WRAP;
  c.format = SELVAGE_INDEX8;
  c.layout = Layout::kTiled;
  c.choice = 100;
  c.vertices = {{384, -1, 65536 + 1, 32768, 11}};
  EXPECT_EQ(complexity(c), (Complexity{1, 32, 32, 7, 1 + 8 + 16 + 1,
                                       10 + 5 + 2 + 100 + 384 + 1 + 65537 + 32768 + 10}));
}

}  // namespace
}  // namespace selvage::spec
