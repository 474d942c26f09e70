// What a row is drawn by within a tolerance, held against the formula of spec/README.md, 8.9.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "mapper/polygon.h"
#include "mapper/tolerance.h"
#include "mapper/tolerant_draw.h"
#include "spec/exact.h"
#include "spec/tolerance.h"

namespace selvage::mapper {
namespace {

inline constexpr double kFx32PerFx16 = 65536;
inline constexpr int32_t kAnyTolerance_fx16 = 1 << 30;

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

// What lanes along so many steps lose beside the curve: the margin and two units a step, floored,
// and four units.
[[nodiscard]] int32_t roundings_fx16(int64_t error_fx32, int32_t steps) {
  return 4 + static_cast<int32_t>(
                 std::floor((2.0 * static_cast<double>(error_fx32) + 2.0 * steps) / kFx32PerFx16));
}

// (N / n)^2 |du| r (r - 1) / 4, for a share N / n and a change that holds the lanes' margin.
[[nodiscard]] double chord_fx16(const Ends& ends, int64_t error_fx32, double share, double ratio) {
  const double change = std::max(std::abs(ends.u[1] - ends.u[0]), std::abs(ends.v[1] - ends.v[0])) +
                        2.0 * static_cast<double>(error_fx32) / kFx32PerFx16;
  return share * share * change * ratio * (ratio - 1) / 4;
}
[[nodiscard]] double ratio_of(const Ends& ends) {
  return std::max(ends.denominator[0], ends.denominator[1]) /
         std::min(ends.denominator[0], ends.denominator[1]);
}

// The bound that is told is that of the formula, in whole units, and hardly more: of the ratio
// 2^-23 of itself. Lanes are truncated to 2^-16 units.
void expect_bound(const RowChoice& choice, const Ends& ends, int32_t width_px, int64_t error_fx32) {
  const int32_t steps = width_px - 1, roundings = roundings_fx16(error_fx32, steps);
  const double share =
      choice.segment_px == 0 ? 1.0 : choice.segment_px / static_cast<double>(steps);
  const double ratio = ratio_of(ends), beyond = 1 + 0x1p-40;
  const double least = chord_fx16(ends, error_fx32, share, ratio);
  const double most = chord_fx16(ends, error_fx32, share, ratio * (1 + 0x1p-23));
  const double truncated = ratio * ratio * 2 / kFx32PerFx16;
  EXPECT_GE(choice.bound_fx16, roundings + std::ceil(least / beyond - truncated));
  EXPECT_LE(choice.bound_fx16, roundings + std::ceil(most * beyond + truncated));
}

TEST(ChooseRow, TellsTheRoundingsWhereNothingBends) {
  const Ends still{{7, 7}, {9, 9}, {1, 1}};
  for (const int32_t width_px : {96, 1000, 32768, 32769, 40000, 65536}) {
    const RowChoice choice = choose_row(lanes_of(still, width_px, 0), width_px, kAnyTolerance_fx16);
    EXPECT_EQ(choice.method, SELVAGE_METHOD_AFFINE_FOR_PERSPECTIVE);
    EXPECT_EQ(choice.bound_fx16, roundings_fx16(0, width_px - 1)) << width_px;
  }
  EXPECT_EQ(roundings_fx16(0, 32767), 4);
  EXPECT_EQ(roundings_fx16(0, 32768), 5);
}

// What is below a unit of the margin makes the curve's unit.
TEST(ChooseRow, TellsTheRoundingsOfTheMarginToo) {
  const Ends still{{7, 7}, {9, 9}, {1, 1}};
  for (const int32_t error_fx32 : {2, 100, 4096, 1 << 20}) {
    for (const int32_t width_px : {96, 28673, 28674, 40000}) {
      const RowChoice choice =
          choose_row(lanes_of(still, width_px, error_fx32), width_px, kAnyTolerance_fx16);
      EXPECT_EQ(choice.bound_fx16, roundings_fx16(error_fx32, width_px - 1) + 1);
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
    for (const int32_t width_px : {96, 97, 640, 5000}) {
      for (const int64_t error_fx32 : {int64_t{3}, kMostSteppedError_fx32}) {
        for (int bits = 3; bits <= 30; ++bits) {
          const RowChoice choice =
              choose_row(lanes_of(ends, width_px, error_fx32), width_px, 1 << bits);
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
      for (const int32_t segment_px : {48, 64, 160, 480}) {
        constexpr int32_t kWidth_px = 1000;
        const auto chosen = [&](double u_fx16) {
          const Ends ends{{0, u_fx16}, {0, 0}, {1, ratio}};
          return choose_row(lanes_of(ends, kWidth_px, 3), kWidth_px, tolerance_fx16);
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
        EXPECT_EQ(choice.segment_px, segment_px);
        EXPECT_LE(choice.bound_fx16, tolerance_fx16);
        EXPECT_GE(choice.bound_fx16, tolerance_fx16 - 1);
      }
    }
  }
}

// Steps fit 32 bits without being asked for their size.
TEST(ChooseRow, StepsAreSmallWhereverARowIsStepped) {
  constexpr double kEnd = 0x1p31;
  double steepest = 0;
  for (double ratio = 1; ratio <= 0x1p24; ratio *= 1.01) {
    for (int32_t width_px = 96; width_px <= 65536; width_px = width_px * 5 / 4) {
      const Ends ends{{-kEnd, kEnd}, {0, 0}, {1, ratio}};
      const RowChoice choice = choose_row(lanes_of(ends, width_px, 3), width_px, INT32_MAX);
      if (choice.method == SELVAGE_METHOD_EXACT_PERSPECTIVE) continue;
      steepest = std::max(steepest, 2 * kEnd * ratio / (width_px - 1));
    }
  }
  EXPECT_LT(steepest, 0x1p28);
  EXPECT_GT(steepest, 0x1p25);
}

// As section 8.9 says; segments of 48 px are in the test of those about to be shorter.
TEST(ChooseRow, RowsBelow96PixelsAreExact) {
  const Ends still{{7, 7}, {9, 9}, {1, 1}};
  for (const int32_t width_px : {2, 50, 95}) {
    const RowChoice choice = choose_row(lanes_of(still, width_px, 3), width_px, kAnyTolerance_fx16);
    EXPECT_EQ(choice.method, SELVAGE_METHOD_EXACT_PERSPECTIVE);
    EXPECT_EQ(choice.bound_fx16, 0);
  }
}

// A quad that bends less from row to row: the shortest segments come first or last.
TEST(ChooseRow, OfSomeRowsTheShortestSegmentsAreTold) {
  constexpr int32_t kNear = 1 << 20, kFar = kNear + (1 << 19), kTexels = 200 * SELVAGE_SUBTEXELS;
  std::vector<selvage_vertex> vertices = {
      {0, 0, 0, 0, kNear},
      {2000 * 256, 0, kTexels, 0, kFar},
      {2000 * 256, 8 * 256, kTexels, kTexels, kNear + (kFar - kNear) / 2},
      {0, 8 * 256, 0, kTexels, kNear}};
  constexpr int32_t kTolerance_fx16 = 5000;
  for (int turned = 0; turned < 2; ++turned) {
    Polygon polygon;
    ASSERT_EQ(examine(vertices, &polygon), SELVAGE_OK);
    int32_t shortest = INT32_MAX, longest = 0;
    for (int32_t row = 0; row < 8; ++row) {
      const selvage_rect alone{0, row, 2000, row + 1};
      const RowChoice choice = choose_tolerantly(alone, polygon, kTolerance_fx16);
      if (choice.segment_px == 0) continue;
      shortest = std::min(shortest, choice.segment_px);
      longest = std::max(longest, choice.segment_px);
    }
    EXPECT_LT(shortest, longest);
    const RowChoice all = choose_tolerantly({0, 0, 2000, 8}, polygon, kTolerance_fx16);
    EXPECT_EQ(all.segment_px, shortest);
    for (selvage_vertex& v : vertices) v.y = 8 * 256 - v.y;
  }
}

// A plane that reaches far would cost a unit more than what the specification allows: rows are then
// chosen by their edges. q is the same along each row.
TEST(ChooseRow, PlanesThatReachFarCostNothing) {
  constexpr int32_t kTexels = 100 * SELVAGE_SUBTEXELS, kRight_fx8 = 200 * 256,
                    kBottom_fx8 = 3 * 256;
  for (const int32_t q : {1000, 4000, 5000, 20000, 31000, 40000}) {
    const std::vector<selvage_vertex> vertices = {
        {0, 0, 0, 0, 1}, {kRight_fx8, 0, kTexels, 0, 1}, {0, kBottom_fx8, 0, kTexels, q}};
    Polygon polygon;
    ASSERT_EQ(examine(vertices, &polygon), SELVAGE_OK);
    for (const int32_t row : {0, 1}) {
      const RowChoice choice =
          choose_tolerantly({0, row, 200, row + 1}, polygon, kAnyTolerance_fx16);
      ASSERT_EQ(choice.method, SELVAGE_METHOD_AFFINE_FOR_PERSPECTIVE);
      const auto line = spec::scan_line(vertices, row);
      const double chord = spec::chord_bound(*line, 0).get_d() * kFx32PerFx16;
      const double roundings = spec::rounding_bound_fx16(*line).get_d();
      EXPECT_LE(choice.bound_fx16, std::ceil(chord + roundings)) << q;
    }
  }
}

}  // namespace
}  // namespace selvage::mapper
