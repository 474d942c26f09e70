#include "mapper/lanes.h"

#include <gtest/gtest.h>

#include "spec/exact.h"
#include "spec/random.h"
#include "tests/span_support.h"

namespace selvage::mapper {
namespace {

// Of u_fx16 + beside / parts, in 1/2^32 texel.
[[nodiscard]] int64_t expected_floor_fx32(int32_t u_fx16, int beside, int64_t parts) {
  const int64_t whole_fx32 = int64_t{u_fx16} << kTexelFraction;
  const int64_t more_fx32 = (int64_t{1} << kTexelFraction) / parts;
  const bool exact = (int64_t{1} << kTexelFraction) % parts == 0;
  return beside < 0 ? whole_fx32 - more_fx32 - (exact ? 0 : 1) : whole_fx32 + beside * more_fx32;
}

// The law of the filter: lane <= true value < lane + margin.
void expect_lawful_lane(int64_t lane_fx32, uint32_t margin_fx32, const spec::Rational& exact_texel,
                        const spec::Case& c) {
  const spec::Rational exact_fx32 = exact_texel * spec::Rational(4294967296.0);
  ASSERT_LE(spec::rational(lane_fx32), exact_fx32) << spec::print(c);
  ASSERT_LT(exact_fx32, spec::rational(lane_fx32 + margin_fx32)) << spec::print(c);
}

template <class Lanes>
void expect_lawful_lanes(const spec::Case& c, const SpanMap& map, const Span& span) {
  const Lanes lanes(map, span);
  const int32_t last = span.width_px() - 1;
  for (const int32_t offset_px : {0, 1, last / 2, last}) {
    if (offset_px > last) continue;
    const auto exact = spec::sample(c.vertices, span.left_px + offset_px, span.row);
    const Lane lane = lanes.at(offset_px);
    expect_lawful_lane(lane.u_fx32, lanes.margin_fx32(), exact->u, c);
    expect_lawful_lane(lane.v_fx32, lanes.margin_fx32(), exact->v, c);
  }
}

void expect_lawful_lanes_of_generated_spans(int cases) {
  int affine = 0, projective = 0;
  for_each_generated_span(
      static_cast<uint64_t>(cases),
      [&](const spec::Case& c, const Polygon& polygon, const SpanMap& map, const Span& span) {
        if (polygon.affine) {
          expect_lawful_lanes<AffineLanes>(c, map, span);
          ++affine;
        }
        // The projective lanes must hold on affine spans too: a ratio of 1 is an ordinary ratio.
        expect_lawful_lanes<ProjectiveLanes>(c, map, span);
        ++projective;
      });
  EXPECT_GT(affine, cases * 3 / 4);
  EXPECT_GT(projective, affine + cases / 4);
}

TEST(Lanes, AreLowByLessThanTheirMargin) { expect_lawful_lanes_of_generated_spans(400); }
TEST(LanesAtLength, AreLowByLessThanTheirMargin) { expect_lawful_lanes_of_generated_spans(4000); }

TEST(Lanes, AreExactWhereCoordinatesAreDyadic) {
  spec::Case c;
  c.vertices = {{0, 0, 0, 0, 1},
                {4096, 0, 32 * 65536, 0, 1},
                {4096, 4096, 32 * 65536, 65536, 1},
                {0, 4096, 0, 65536, 1}};
  for_each_span(c, [](const spec::Case&, const Polygon&, const SpanMap& map, const Span& span) {
    const AffineLanes lanes(map, span);
    for (int32_t i = 0; i < span.width_px(); ++i) {
      // Every centre is a tie, u = 2 i + 1; the lane hits it and needs no decision.
      ASSERT_EQ(lanes.at(i).u_fx32, int64_t{2 * (span.left_px + i) + 1} << kLaneFraction);
    }
  });
}

// One pixel of a span so narrow that u would run far out of range in the next.
TEST(Lanes, NeedNoStepForOnePixel) {
  const auto at = [](int64_t x, int64_t u) {
    return EdgePoint{.height = 256, .x = x, .uq = int128{u} * 256, .vq = 0, .q = 256};
  };
  const SpanMap map(at(128 * 256 - 1, INT32_MIN), at(128 * 256 + 1, INT32_MAX));
  const AffineLanes lanes(map, Span{0, 0, 1});
  EXPECT_EQ(lanes.at(0).u_fx32 >> kLaneFraction, -1);  // half way, -1/2 of 1/65536 texel
  EXPECT_EQ(lanes.margin_fx32(), 1U);
}

// The widest span there is, with the largest coordinates.
TEST(Lanes, HoldOverTheWholeRange) {
  spec::Case c;
  const int32_t least = SELVAGE_X_MIN, last = SELVAGE_X_END - 1;
  const int32_t u_least = INT32_MIN, u_last = INT32_MAX;
  c.vertices = {{least, least, u_least, u_last, 1},
                {last, least, u_last, u_least, 1},
                {last, last, u_last, u_last, 1},
                {least, last, u_least, u_least, 1}};
  for (const int32_t q : {1, 2, 1000, int32_t{SELVAGE_Q_MAX}}) {
    c.vertices[1].q = q;
    Polygon polygon;
    ASSERT_EQ(examine(c.vertices, &polygon), SELVAGE_OK);
    Chain forward(polygon, Chain::Direction::kForward);
    Chain backward(polygon, Chain::Direction::kBackward);
    for (const int32_t row : {-32768, -1, 0, 12345, 32766}) {
      const Edge& right = forward.at_row(row);
      const Edge& left = backward.at_row(row);
      const Span span{row, left.first_px(), right.first_px()};
      const SpanMap map(left.at(row), right.at(row));
      if (q == 1) expect_lawful_lanes<AffineLanes>(c, map, span);
      expect_lawful_lanes<ProjectiveLanes>(c, map, span);
    }
  }
}

// Coordinates at a unit of 1/65536 texel, and less beside it than doubles tell: the floors of
// quotients whose estimates are rounded to either side.
TEST(Lanes, StartAtTheFloorOfWhatIsAtOrBesideAUnit) {
  spec::Random random(3);
  for (int i = 0; i < 20000; ++i) {
    const int64_t height = random.in(1, 1 << random.in(1, 24));
    const int64_t wide = random.in(1, 1 << random.in(1, 24)), q = random.pick({1, 1, 3, 1 << 24});
    const int32_t u_fx16 =
        random.pick({0, 1, -1, -2, random.in(-65536, 65537), random.in(INT32_MIN + 1, INT32_MAX)});
    const int beside = random.in(-1, 2);
    const int64_t centre = kHalfPixel * height;  // of pixel 0; the left edge is just left of it
    const EdgePoint left{height, centre - 1, int128{u_fx16} * height * q, 0, height * q};
    EdgePoint right = left;
    right.x = centre + wide * height;
    right.uq = int128{u_fx16 + beside} * height * q;
    const AffineLanes lanes(SpanMap(left, right), Span{0, 0, 1});
    ASSERT_EQ(lanes.at(0).u_fx32, expected_floor_fx32(u_fx16, beside, wide * height + 1)) << i;
    ASSERT_EQ(lanes.at(0).v_fx32, 0);
  }
}

// By proof half of it is enough (spec/proofs/projective_lanes.g); and a unit more is decided
// slowly.
TEST(Lanes, HaveTheMarginsOfTheProofs) {
  const auto at = [](int64_t x, int64_t q) { return EdgePoint{256, x * 256, 0, 0, q * 256}; };
  for (const int64_t q : {1, 2, 7, 1000, int32_t{SELVAGE_Q_MAX}}) {
    const SpanMap map(at(kHalfPixel, 1), at(kHalfPixel + 256 * 9, q));
    const ProjectiveLanes lanes(map, Span{0, 0, 10});
    EXPECT_EQ(lanes.ratio(), static_cast<double>(q));
    EXPECT_EQ(lanes.error_fx32(), q + kProjectiveTruncations_fx32);
    EXPECT_EQ(lanes.margin_fx32(), 2U * static_cast<uint32_t>(lanes.error_fx32()));
  }
}

// u is -(1 + 1 / (65536 a w - 1)) of 1/2^32 texel: so little beyond a unit that estimates in double
// are at it, or short of it.
TEST(Lanes, StartAtTheFloorOfWhatIsBeyondAUnitByAHair) {
  spec::Random random(4);
  constexpr int64_t kWeight = 1 << 20;
  for (int i = 0; i < 1000; ++i) {
    const int64_t a = random.in(1 << 24, INT32_MAX);
    const EdgePoint left{1, kHalfPixel - kWeight, 0, 0, 1};
    const EdgePoint right{1, kHalfPixel + kWeight - 1, int128{-a}, int128{a}, 65536 * a - 1};
    const AffineLanes lanes(SpanMap(left, right), Span{0, 0, 1});
    ASSERT_EQ(lanes.at(0).u_fx32, -2) << a;
    ASSERT_EQ(lanes.at(0).v_fx32, 1) << a;
  }
}

// A quotient that is whole, by divisors whose reciprocals are rounded.
TEST(Lanes, StartAtAWholeUnitWhateverTheDivisor) {
  for (int64_t q = 1; q < 3000; ++q) {
    const EdgePoint left{1, kHalfPixel - 1, 0, 0, q};
    const EdgePoint right{1, kHalfPixel + 65535, int128{q}, -int128{q}, q};
    const AffineLanes lanes(SpanMap(left, right), Span{0, 0, 1});
    ASSERT_EQ(lanes.at(0).u_fx32, 1) << q;
    ASSERT_EQ(lanes.at(0).v_fx32, -1) << q;
  }
}

}  // namespace
}  // namespace selvage::mapper
