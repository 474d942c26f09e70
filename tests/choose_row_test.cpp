// What a row is drawn by within a tolerance, held against the formula of spec/README.md, 8.9.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "mapper/bend.h"
#include "mapper/tolerance.h"
#include "spec/random.h"
#include "tests/any_tolerance.h"
#include "tests/lane_units.h"

namespace selvage::mapper {
namespace {

// u and v, in units of 2^-16 texel, and the denominator at the ends of a row.
struct Ends {
  double u[2], v[2], denominator[2];
};

[[nodiscard]] DividedLanes lanes_of(const Ends& ends, int32_t width_px, int64_t error_fx32) {
  const double steps = width_px - 1;
  const auto line = [&](double first, double last) {
    return DividedLanes::Linear{first, (last - first) / steps};
  };
  const auto numerator = [&](const double(&ends_fx16)[2]) {
    return line(ends_fx16[0] * kFx32PerFx16 * ends.denominator[0],
                ends_fx16[1] * kFx32PerFx16 * ends.denominator[1]);
  };
  return {numerator(ends.u), numerator(ends.v), line(ends.denominator[0], ends.denominator[1]),
          error_fx32};
}

[[nodiscard]] RowChoice choose(const DividedLanes& lanes, int32_t width_px,
                               int32_t tolerance_fx16) {
  return choose_row(bend_of(lanes, width_px), lanes.margin_fx32(), width_px, tolerance_fx16);
}

// What lanes along so many steps lose beside the curve: the margin and two units a step, floored,
// and four units.
[[nodiscard]] int32_t rounding_loss_fx16(int64_t error_fx32, int32_t steps) {
  return 4 + static_cast<int32_t>(
                 std::floor((2.0 * static_cast<double>(error_fx32) + 2.0 * steps) / kFx32PerFx16));
}

// (N / n)^2 |du| r (r - 1) / 4, for a share N / n.
[[nodiscard]] double chord_fx16(const Ends& ends, double share, double ratio) {
  const double change = std::max(std::abs(ends.u[1] - ends.u[0]), std::abs(ends.v[1] - ends.v[0]));
  return share * share * change * ratio * (ratio - 1) / 4;
}
[[nodiscard]] double ratio_of(const Ends& ends) {
  return std::max(ends.denominator[0], ends.denominator[1]) /
         std::min(ends.denominator[0], ends.denominator[1]);
}

// What a slope may be off by, and what is added for that: a share of its terms.
[[nodiscard]] double slope_error_fx16(const Ends& ends, double share, double ratio) {
  double terms = 0;
  for (const auto& of : {ends.u, ends.v}) {
    terms = std::max(terms, std::max(std::abs(of[0]), std::abs(of[1])) * ratio);
  }
  return 0x1p-45 * share * share * terms * ratio * (ratio - 1);
}

// The bound that is told is that of the formula, in whole units, and hardly more.
void expect_bound(const RowChoice& choice, const Ends& ends, int32_t width_px, int64_t error_fx32) {
  const int32_t steps = width_px - 1, roundings = rounding_loss_fx16(error_fx32, steps);
  const double share =
      choice.segment_px == 0 ? 1.0 : choice.segment_px / static_cast<double>(steps);
  const double ratio = ratio_of(ends), chord = chord_fx16(ends, share, ratio);
  const double error = slope_error_fx16(ends, share, ratio);
  EXPECT_GE(choice.bound_fx16, roundings + std::ceil(chord * (1 - 0x1p-40) - error));
  EXPECT_LE(choice.bound_fx16, roundings + std::ceil(chord * (1 + 0x1p-22) + error));
}

TEST(ChooseRow, TellsTheRoundingsWhereNothingBends) {
  const Ends still{{7, 7}, {9, 9}, {1, 1}};
  for (const int32_t width_px : {160, 1000, 32768, 32769, 40000, 65536}) {
    const RowChoice choice = choose(lanes_of(still, width_px, 0), width_px, kAnyTolerance_fx16);
    EXPECT_EQ(choice.method, SELVAGE_METHOD_AFFINE_FOR_PERSPECTIVE);
    EXPECT_EQ(choice.bound_fx16, rounding_loss_fx16(0, width_px - 1)) << width_px;
  }
  EXPECT_EQ(rounding_loss_fx16(0, 32767), 4);
  EXPECT_EQ(rounding_loss_fx16(0, 32768), 5);
}

TEST(ChooseRow, TellsTheRoundingsOfTheMarginToo) {
  const Ends still{{7, 7}, {9, 9}, {1, 1}};
  for (const int32_t error_fx32 : {2, 100, 4096, 1 << 20}) {
    for (const int32_t width_px : {160, 28673, 28674, 40000}) {
      const RowChoice choice =
          choose(lanes_of(still, width_px, error_fx32), width_px, kAnyTolerance_fx16);
      EXPECT_EQ(choice.bound_fx16, rounding_loss_fx16(error_fx32, width_px - 1));
    }
  }
}

TEST(ChooseRow, TellsTheBoundOfTheSpecification) {
  constexpr double kFar = 1 << 30;
  const std::vector<Ends> rows = {
      {{70000, 3000000}, {9, 9}, {1, 1.25}},     {{9, 9}, {70000, 3000000}, {1.25, 1}},
      {{500000, -9000000}, {0, 1000}, {3, 7}},   {{-65536, 65536}, {-kFar, kFar}, {1, 1}},
      {{-kFar, kFar}, {kFar, 5}, {1 << 20, 1}},  {{10, 30}, {40, 20}, {1, 100}},
      {{-9000, -5000}, {800, 20000}, {100, 1}},  {{kFar, kFar - 99}, {0, 0}, {1, 3}},
      {{5000, 5000}, {700000, 500000}, {1, 50}}, {{0, 65536}, {0, 0}, {1, 1.0000001}}};
  int subdivided = 0, whole = 0;
  for (const Ends& ends : rows) {
    for (const int32_t width_px : {160, 161, 640, 5000}) {
      for (const int64_t error_fx32 : {int64_t{3}, kMostSteppedError_fx32}) {
        for (int bits = 3; bits <= 30; ++bits) {
          const RowChoice choice =
              choose(lanes_of(ends, width_px, error_fx32), width_px, 1 << bits);
          if (choice.method == SELVAGE_METHOD_EXACT_PERSPECTIVE) continue;
          (choice.segment_px == 0 ? whole : subdivided) += 1;
          EXPECT_LE(choice.bound_fx16, 1 << bits);
          expect_bound(choice, ends, width_px, error_fx32);
        }
      }
    }
  }
  EXPECT_GT(subdivided, 100);
  EXPECT_GT(whole, 100);
}

// The furthest that u goes while segments are as long as that: there the chord is all but the whole
// tolerance, and roundings of the length must not carry it beyond.
TEST(ChooseRow, KeepsToTheToleranceWhereSegmentsAreAboutToBeShorter) {
  for (const int32_t tolerance_fx16 : {1 << 16, 1 << 20, 77777777, kAnyTolerance_fx16}) {
    for (const double ratio : {1.25, 1.7, 3.0, 10.0}) {
      constexpr int32_t kWidth_px = 1000;
      for (const int32_t segment_px : {64, 80, 160, 480, kWidth_px}) {
        const auto chosen = [&](double u_fx16) {
          const Ends ends{{0, u_fx16}, {0, 0}, {1, ratio}};
          return choose(lanes_of(ends, kWidth_px, 3), kWidth_px, tolerance_fx16);
        };
        const auto is_long = [&](const RowChoice& choice) {
          return choice.method == SELVAGE_METHOD_AFFINE_FOR_PERSPECTIVE ||
                 choice.segment_px >= segment_px;
        };
        double u_fx16 = 0, beyond_fx16 = 0x1p44;
        for (int halvings = 0; halvings < 60; ++halvings) {
          const double middle = (u_fx16 + beyond_fx16) / 2;
          (is_long(chosen(middle)) ? u_fx16 : beyond_fx16) = middle;
        }
        const RowChoice choice = chosen(u_fx16);
        EXPECT_EQ(choice.segment_px, segment_px < kWidth_px ? segment_px : 0);
        EXPECT_LE(choice.bound_fx16, tolerance_fx16);
        EXPECT_GE(choice.bound_fx16, tolerance_fx16 - 1);
      }
    }
  }
}

// The last row of which segments of 64 px are within a tolerance, unit by unit of double: whatever
// way a quotient and its root are rounded, they are not shorter.
TEST(ChooseRow, SegmentsAreNotShorterThan64Pixels) {
  for (uint64_t seed = 1; seed <= 1000; ++seed) {
    spec::Random random(seed);
    const int32_t tolerance_fx16 = random.in(1000, 1 << 30);
    const auto share = [&] { return 1 + random.in(0, 1 << 30) * 0x1p-30; };
    RowBend row{0, share(), share()};
    const double room = Chords(row).room_fx16(tolerance_fx16 - rounding_loss_fx16(0, 999));
    const auto is_within = [&](double slope_fx32) {
      return Chords({slope_fx32, row.turn, row.least_denominator}).off_fx16(64) <= room;
    };
    row.slope_fx32 = room / Chords({1, row.turn, row.least_denominator}).off_fx16(64);
    while (!is_within(row.slope_fx32)) row.slope_fx32 = std::nextafter(row.slope_fx32, 0);
    const double steeper = std::nextafter(row.slope_fx32, HUGE_VAL);
    if (is_within(steeper)) row.slope_fx32 = steeper;
    EXPECT_EQ(choose_segment_px(row, 0, 1000, tolerance_fx16), 64) << "seed " << seed;
    EXPECT_LE(choose_row(row, 0, 1000, tolerance_fx16).bound_fx16, tolerance_fx16);
  }
}

// Steps fit 32 bits without being asked for their size.
TEST(ChooseRow, StepsAreSmallWhereverARowIsStepped) {
  constexpr double kEnd = 0x1p31;
  double steepest = 0;
  for (double ratio = 1; ratio <= 0x1p24; ratio *= 1.01) {
    for (int32_t width_px = 160; width_px <= 65536; width_px = width_px * 5 / 4) {
      const Ends ends{{-kEnd, kEnd}, {0, 0}, {1, ratio}};
      const RowChoice choice = choose(lanes_of(ends, width_px, 3), width_px, INT32_MAX);
      if (choice.method == SELVAGE_METHOD_EXACT_PERSPECTIVE) continue;
      steepest = std::max(steepest, 2 * kEnd * ratio / (width_px - 1));
    }
  }
  EXPECT_LT(steepest, 0x1p28);
  EXPECT_GT(steepest, 0x1p25);
}

// As section 8.9 says; segments of 64 px are in the test of those about to be shorter.
TEST(ChooseRow, RowsBelow160PixelsAreExact) {
  const Ends still{{7, 7}, {9, 9}, {1, 1}};
  for (const int32_t width_px : {2, 50, 159}) {
    const RowChoice choice = choose(lanes_of(still, width_px, 3), width_px, kAnyTolerance_fx16);
    EXPECT_EQ(choice.method, SELVAGE_METHOD_EXACT_PERSPECTIVE);
    EXPECT_EQ(choice.bound_fx16, 0);
  }
}

// The least distance between two divisions: of a segment, or from end to end of a narrow row.
TEST(Stepping, IsShortestByASegmentOrByARow) {
  EXPECT_EQ(kUsualStepping.shortest_px(), 64);
  EXPECT_EQ(kWideStepping.shortest_px(), 255);
}

}  // namespace
}  // namespace selvage::mapper
