#include "mapper/span.h"

#include "mapper/exact_row.h"

#include <gtest/gtest.h>

#include <numeric>

#include "spec/exact.h"
#include "tests/span_support.h"
#include "tests/whole.h"

namespace selvage::mapper {
namespace {

TEST(SpanMap, EqualsTheExactModel) {
  uint64_t judged = 0;
  for_each_generated_span(
      3000, [&](const spec::Case& c, const Polygon&, const SpanMap& map, const Span& span) {
        for (const int32_t px :
             {span.left_px, std::midpoint(span.left_px, span.right_px), span.right_px - 1}) {
          const auto exact = spec::sample(c.vertices, px, span.row);
          ASSERT_TRUE(exact) << spec::print(c);
          ASSERT_GT(map.denominator(px), 0);
          ASSERT_EQ(floor_of(map.u_numerator(px), map.denominator(px)), spec::floor(exact->u));
          ASSERT_EQ(floor_of(map.v_numerator(px), map.denominator(px)), spec::floor(exact->v));
          ++judged;
        }
      });
  EXPECT_GT(judged, 10000U);
}

TEST(SpanMap, StepsAreDifferences) {
  for_each_generated_span(1000, [](const spec::Case&, const Polygon& polygon, const SpanMap& map,
                                   const Span& span) {
    if (span.width_px() < 2) return;
    const int32_t px = span.left_px;
    const auto difference = [](int128 a, int128 b) {
      return static_cast<int128>(static_cast<uint128>(b) - static_cast<uint128>(a));
    };
    ASSERT_TRUE(difference(map.u_numerator(px), map.u_numerator(px + 1)) == map.u_numerator_step());
    ASSERT_TRUE(difference(map.v_numerator(px), map.v_numerator(px + 1)) == map.v_numerator_step());
    ASSERT_TRUE(difference(map.denominator(px), map.denominator(px + 1)) == map.denominator_step());
    ASSERT_TRUE(!polygon.affine || map.denominator_step() == 0);
  });
}

TEST(SpanMap, DecidesBetweenTwoTexels) {
  for_each_generated_span(
      1000, [](const spec::Case& c, const Polygon&, const SpanMap& map, const Span& span) {
        const auto exact = spec::sample(c.vertices, span.left_px, span.row);
        const int32_t s = spec::floor(exact->u), t = spec::floor(exact->v);
        for (const int32_t below : {0, 1}) {
          const ExactRow row = ExactMap(map).row_from(span.left_px, span.row);
          ASSERT_EQ(row.reaches(row.u, 0, s + below), below == 0);
          ASSERT_EQ(row.reaches(row.v, 0, t + below), below == 0);
        }
      });
}

// A tie belongs to the next texel, and what is one unit short of it does not.
TEST(ExactRow, ReachesATexelAtTheTieAndNotAUnitBefore) {
  for (const int32_t texel : {-3, 0, 5}) {
    for (const int64_t d : {int64_t{1} << 16, int64_t{77} << 16, int64_t{1} << 40}) {
      const auto line = [](int128 start) { return ExactLine{static_cast<uint128>(start), 0}; };
      const int128 tie = int128{d} * texel;
      for (const int offset : {-1, 0, 1}) {
        const ExactRow row{line(tie + offset), line(0), line(d)};
        EXPECT_EQ(row.reaches(row.u, 4, texel), offset >= 0) << texel << " " << d << " " << offset;
      }
    }
  }
}

}  // namespace
}  // namespace selvage::mapper
