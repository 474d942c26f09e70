#include "mapper/edge.h"

#include "mapper/span_batch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "spec/exact.h"

namespace selvage::mapper {
namespace {

using spec::Rational;

// ceil(x - 1/2) of the edge at the row's centre, in rationals.
[[nodiscard]] int32_t exact_first_px(const selvage_vertex& a, const selvage_vertex& b,
                                     int32_t row) {
  const Rational y = Rational(row) * 256 + 128;
  const Rational x = a.x + (y - a.y) * (Rational(b.x) - a.x) / (Rational(b.y) - a.y);
  return -spec::floor(-(x / 256 - Rational(1, 2)));
}

void expect_exact_columns(const selvage_vertex& a, const selvage_vertex& b) {
  Edge stepped(a, b);
  const int32_t top_row = first_centre_px(std::min(a.y, b.y));
  if (top_row >= stepped.bottom_row()) return;
  stepped.seek(top_row);
  const int32_t last = std::min(stepped.bottom_row(), top_row + 200);
  for (int32_t row = top_row; row < last; ++row, stepped.step()) {
    Edge sought(b, a);
    sought.seek(row);
    ASSERT_EQ(sought.first_px(), exact_first_px(a, b, row)) << row;
    ASSERT_EQ(stepped.first_px(), sought.first_px()) << row;
  }
}

TEST(Edge, StepsAndSeeksToTheExactColumn) {
  std::mt19937 random(20261121);
  for (int i = 0; i < 400; ++i) {
    const int32_t reach = i % 3 == 0 ? 8388608 : i % 3 == 1 ? 4096 : 40;
    const auto pick = [&] {
      return static_cast<int32_t>(random() % static_cast<uint32_t>(2 * reach)) - reach;
    };
    expect_exact_columns({pick(), pick(), 0, 0, 1}, {pick(), pick(), 0, 0, 1});
  }
}

TEST(Edge, IsExactAtTheEndsOfTheRange) {
  const int32_t least = SELVAGE_X_MIN, last = SELVAGE_X_END - 1;
  expect_exact_columns({least, least, 0, 0, 1}, {last, last, 0, 0, 1});
  expect_exact_columns({last, least, 0, 0, 1}, {least, last, 0, 0, 1});
  expect_exact_columns({least, 127, 0, 0, 1}, {last, 129, 0, 0, 1});
}

TEST(Edge, OwnsRowsByTheHalfOpenRule) {
  const selvage_vertex top{0, 128, 0, 0, 1}, bottom{0, 640, 0, 0, 1};
  EXPECT_EQ(first_centre_px(top.y), 0);
  EXPECT_EQ(Edge(top, bottom).bottom_row(), 2);
}

// An edge that misses a sample point by 1 / height of a unit, on either side, in every row it may.
TEST(Edge, TellsTheLeastMissFromATouch) {
  for (const int32_t height : {3, 255, 257, 1021, 4099}) {
    for (int32_t dx = 1; dx < height; dx += 1 + height / 40) {
      for (const int32_t shift : {-128, 0, 1, 128}) {
        expect_exact_columns({shift, 127, 0, 0, 1}, {shift + dx, 127 + height, 0, 0, 1});
        expect_exact_columns({shift, 128, 0, 0, 1}, {shift - dx, 128 + height, 0, 0, 1});
      }
    }
  }
}

TEST(Chain, JumpsWithinAnEdgeAndPastSome) {
  const std::vector<selvage_vertex> v = {
      {0, 0, 0, 0, 1}, {2560, 3000, 0, 0, 1}, {3000, 5000, 0, 0, 1}, {-500, 9000, 0, 0, 1}};
  Polygon polygon;
  ASSERT_EQ(examine(v, &polygon), SELVAGE_OK);
  for (const int32_t stride : {2, 3, 7, 12}) {
    Chain chain(polygon, Chain::Direction::kForward);
    for (int32_t row = 0; row < polygon.bottom_row; row += stride) {
      Chain fresh(polygon, Chain::Direction::kForward);
      ASSERT_EQ(chain.at_row(row).first_px(), fresh.at_row(row).first_px()) << row;
    }
  }
}

TEST(Chain, HasLinesForTheRowsAskedForAndNoMore) {
  const std::vector<selvage_vertex> v = {
      {0, 0, 0, 0, 1}, {2560, 300, 0, 0, 1}, {3000, 2000, 0, 0, 1}, {-500, 2560, 0, 0, 1}};
  Polygon polygon;
  ASSERT_EQ(examine(v, &polygon), SELVAGE_OK);
  constexpr int32_t kUntouched = -12345;
  for (int32_t rows = 1; rows <= polygon.bottom_row; ++rows) {
    Chain chain(polygon, Chain::Direction::kForward), walked(polygon, Chain::Direction::kForward);
    std::vector<int32_t> first_px(static_cast<size_t>(rows) + 1, kUntouched);
    chain.for_each_line(0, rows, [&](const EdgeLine& line, int32_t count, int32_t first) {
      for (int32_t i = 0; i < count; ++i) {
        first_px[static_cast<size_t>(first + i)] =
            static_cast<int32_t>(floor_quotient(line.dividend + i * line.step, line.divisor));
      }
    });
    for (int32_t row = 0; row < rows; ++row) {
      ASSERT_EQ(first_px[static_cast<size_t>(row)], walked.at_row(row).first_px()) << row;
    }
    ASSERT_EQ(first_px.back(), kUntouched) << rows << " rows";
  }
}

TEST(Chain, JumpsToARowAndWalksOnFromThere) {
  const std::vector<selvage_vertex> v = {
      {0, 0, 0, 0, 1}, {2560, 300, 0, 0, 1}, {3000, 2000, 0, 0, 1}, {-500, 2560, 0, 0, 1}};
  Polygon polygon;
  ASSERT_EQ(examine(v, &polygon), SELVAGE_OK);
  for (int32_t start = polygon.top_row; start < polygon.bottom_row; ++start) {
    Chain walked(polygon, Chain::Direction::kForward);
    for (int32_t row = start; row < polygon.bottom_row; ++row) {
      Chain jumped(polygon, Chain::Direction::kForward);
      ASSERT_EQ(walked.at_row(row).first_px(), jumped.at_row(row).first_px()) << row;
    }
  }
}

}  // namespace
}  // namespace selvage::mapper
