// The lanes and the exact maps of a slab's rows, against those of spans one by one and the model.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "mapper/affine_slab.h"
#include "mapper/exact_row.h"
#include "mapper/kernel.h"
#include "mapper/lane_divisor.h"
#include "mapper/projective_slab.h"
#include "mapper/slab.h"
#include "mapper/span_walk.h"
#include "mapper/to_double.h"
#include "spec/exact.h"
#include "spec/generate.h"
#include "spec/random.h"
#include "tests/kernel_support.h"
#include "tests/slab_support.h"
#include "tests/span_support.h"
#include "tests/whole.h"

namespace selvage::mapper {
namespace {

using spec::Rational;

// The law of the filter for one lane.
[[nodiscard]] bool holds(int64_t lane_fx32, int64_t margin_fx32, const Rational& texel) {
  const Rational true_fx32 = texel * Rational(4294967296.0);
  return spec::rational(lane_fx32) <= true_fx32 &&
         true_fx32 < spec::rational(lane_fx32 + margin_fx32);
}

// The law of the filter, and that no lane is lower than its own pixels account for.
TEST(AffineSlab, LanesAreLowByLessThanTheirMargin) {
  int pixels = 0;
  for_each_slab(2000, true, [&](const auto& vertices, const Polygon& polygon, const Slab& slab) {
    const int32_t first_row = slab.first_row + slab.rows() / 3;
    const selvage_rect part =
        part_of(polygon, {-40000, first_row, 40000, std::min(slab.end_row, first_row + 9)});
    if (is_empty(part)) return;
    BatchWalk batches(polygon, part, find_spans_scalar);
    SpanBatch batch;
    ASSERT_TRUE(batches.next(&batch));
    RuledRows rows;
    find_lanes(std::span(&slab, 1), batch, find_ruled_lanes_scalar, &rows);
    EXPECT_EQ(rows.margin_fx32, kRuledErrorPerPixel_fx32 * static_cast<uint32_t>(batch.widest_px));
    double most_denominator = 0;
    for (int32_t i = 0; i < batch.rows; ++i) {
      const Span span = batch.span(i);
      if (span.empty()) continue;
      const ExactRow row = ExactMap(RuledMap(slab)).row_from(span.left_px, span.row);
      most_denominator = std::max(most_denominator, to_double(static_cast<int128>(row.d.start)));
      for (const int32_t px : {0, span.width_px() / 2, span.width_px() - 1}) {
        const auto exact = spec::sample(vertices, span.left_px + px, span.row);
        const Lane lane = rows.lanes(i).at(px);
        const int64_t least_margin_fx32 = kRuledErrorPerPixel_fx32 * int64_t{px + 1};
        ASSERT_TRUE(holds(lane.u_fx32, least_margin_fx32, exact->u)) << "row " << span.row;
        ASSERT_TRUE(holds(lane.v_fx32, least_margin_fx32, exact->v)) << "row " << span.row;
        ++pixels;
      }
    }
    EXPECT_NEAR(rows.most_denominator, most_denominator, most_denominator * 0x1p-50);
  });
  EXPECT_GT(pixels, 20000);
}

void expect_same_lanes(const RuledRows& rows, const RuledRows& wanted, int32_t count) {
  EXPECT_EQ(rows.most_denominator, wanted.most_denominator);
  for (size_t i = 0; i < static_cast<size_t>(count); ++i) {
    ASSERT_EQ(rows.start[i].u_fx32, wanted.start[i].u_fx32) << "row " << i;
    ASSERT_EQ(rows.start[i].v_fx32, wanted.start[i].v_fx32) << "row " << i;
    ASSERT_EQ(rows.step[i].u_fx32, wanted.step[i].u_fx32) << "row " << i;
    ASSERT_EQ(rows.step[i].v_fx32, wanted.step[i].v_fx32) << "row " << i;
  }
}

// Of batches that begin and end in any slab, rows without pixels or with one among them.
TEST(AffineSlab, EveryKernelFindsTheSameLanes) {
  int rows_of_none = 0, rows_of_one = 0, batches = 0;
  for (uint64_t seed = 1; seed <= 3000; ++seed) {
    spec::Random random(seed);
    const std::vector<selvage_vertex> vertices = any_quad(random, true);
    Polygon polygon;
    if (examine(vertices, &polygon) != SELVAGE_OK) continue;
    selvage_rect part = part_of(polygon, kEverywhere);
    if (is_empty(part)) continue;
    part.top = random.in(part.top, part.bottom);
    RuledMap map;
    SlabWalk slabs(polygon, part);
    while (const auto slab = slabs.next()) ASSERT_TRUE(map.add(*slab));
    BatchWalk walk(polygon, part, find_spans_scalar);
    SpanBatch batch;
    for (int i = 0; i < 4 && walk.next(&batch); ++i, ++batches) {
      RuledRows wanted;
      find_lanes(map.slabs(), batch, find_ruled_lanes_scalar, &wanted);
      for (const selvage_kernel kernel : usable_kernels()) {
        RuledRows rows;
        find_lanes(map.slabs(), batch, kernels_of(kernel, SELVAGE_FILTER_NEAREST)->find_ruled_lanes,
                   &rows);
        ASSERT_NO_FATAL_FAILURE(expect_same_lanes(rows, wanted, batch.rows))
            << "seed " << seed << ", kernel " << kernel;
      }
      for (int32_t row = 0; row < batch.rows; ++row) {
        rows_of_none += batch.span(row).empty() ? 1 : 0;
        rows_of_one += batch.span(row).width_px() == 1 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(batches, 3000);
  EXPECT_GT(rows_of_none, 100);
  EXPECT_GT(rows_of_one, 100);
}

// Of a batch that begins above some slabs and ends in others, each row has its own; none is 0.
TEST(AffineSlab, FindsTheRowsOfAllSlabsInABatch) {
  const std::vector<selvage_vertex> vertices = {{0, 0, 0, 0, 1},
                                                {5000, 1000, 1 << 20, 0, 1},
                                                {5010, 4000, 1 << 20, 1 << 20, 1},
                                                {-9, 3000, 0, 1 << 20, 1}};
  Polygon polygon;
  ASSERT_EQ(examine(vertices, &polygon), SELVAGE_OK);
  RuledMap map;
  SlabWalk slabs(polygon, part_of(polygon, kEverywhere));
  while (const auto slab = slabs.next()) ASSERT_TRUE(map.add(*slab));
  ASSERT_EQ(map.slabs().size(), 3U);
  BatchWalk batches(polygon, part_of(polygon, kEverywhere), find_spans_scalar);
  SpanBatch batch;
  ASSERT_TRUE(batches.next(&batch));
  RuledRows rows;
  find_lanes(map.slabs(), batch, find_ruled_lanes_scalar, &rows);
  for (int32_t i = 0; i < batch.rows; ++i) {
    const Span span = batch.span(i);
    if (span.empty()) {
      EXPECT_EQ(rows.start[static_cast<size_t>(i)].u_fx32, 0);
      continue;
    }
    const auto exact = spec::sample(vertices, span.left_px, span.row);
    EXPECT_TRUE(holds(rows.start[static_cast<size_t>(i)].u_fx32, 2, exact->u)) << i;
    EXPECT_TRUE(holds(rows.start[static_cast<size_t>(i)].v_fx32, 2, exact->v)) << i;
  }
}

// Slabs above a batch and below it have none of its rows.
TEST(AffineSlab, LeavesRowsOfOtherBatchesAlone) {
  const selvage_vertex v[] = {
      {0, 0, 0, 0, 1}, {0, 50000, 0, 0, 1}, {900, 0, 9, 0, 1}, {900, 50000, 99, 0, 1}};
  const auto rows = [&](int32_t first, int32_t end) {
    return Slab{Edge(v[0], v[1]), Edge(v[2], v[3]), first, end};
  };
  const Slab slabs[] = {rows(0, 10), rows(10, 13), rows(13, 40)};
  SpanBatch batch;
  batch.first_row = 10;
  batch.rows = 3;
  batch.widest_px = 2;
  for (size_t i = 0; i < 5; ++i) {
    batch.left_px[i] = 1;
    batch.right_px[i] = 3;
  }
  RuledRows lanes;
  for (size_t i = 0; i < 5; ++i) lanes.start[i].u_fx32 = lanes.step[i].u_fx32 = -77;
  find_lanes(slabs, batch, find_ruled_lanes_scalar, &lanes);
  for (size_t i = 0; i < 3; ++i) EXPECT_GT(lanes.start[i].u_fx32, 0);
  for (size_t i = 3; i < 5; ++i) EXPECT_EQ(lanes.start[i].u_fx32, -77);
}

// The exact rows of a ruled map are those of the model, whichever edge is on the left.
TEST(RuledMap, DecidesAsTheModelDoes) {
  int pixels = 0;
  for (const bool affine : {true, false}) {
    for_each_slab(400, affine, [&](const auto& vertices, const Polygon& polygon, const Slab& slab) {
      const RuledMap map(slab);
      EXPECT_TRUE(ExactMap(map).is_ruled());
      SpanWalk walk(polygon,
                    {-40000, slab.first_row, 40000, std::min(slab.end_row, slab.first_row + 5)});
      while (walk.next()) {
        const Span span = walk.span();
        const auto [row, below] = ExactMap(map).rows_from(span.left_px, span.row);
        ASSERT_TRUE(below.u.start == row.u.start && below.d.start == row.d.start);
        for (const int32_t px : {0, span.width_px() - 1}) {
          const auto exact = spec::sample(vertices, span.left_px + px, span.row);
          const int32_t s = spec::floor(exact->u), t = spec::floor(exact->v);
          for (const int32_t beyond : {0, 1}) {
            ASSERT_EQ(row.reaches(row.u, px, s + beyond), beyond == 0);
            ASSERT_EQ(row.reaches(row.v, px, t + beyond), beyond == 0);
          }
          ++pixels;
        }
      }
    });
  }
  EXPECT_GT(pixels, 5000);
}

// The law of the filter for a field of a slab, over rows and columns.
TEST(ProjectiveSlab, LanesAreLowByLessThanTheirMargin) {
  int fields = 0, slabs = 0, pixels = 0;
  for_each_slab(2500, false, [&](const auto& vertices, const Polygon&, const Slab& slab) {
    const SlabOutline corners_of(slab);
    const Polygon outline = corners_of.polygon();
    const auto sided = from_left_to_right(slab);
    if (!sided || outline.vertices.size() < 4 || slab.rows() < kLeastFieldRows) return;
    ++slabs;
    const selvage_rect part = part_of(outline, {-300, slab.first_row, 300, slab.end_row});
    if (is_empty(part)) return;
    const auto field = ruled_field(*sided, outline, part);
    if (!field) return;
    ++fields;
    EXPECT_TRUE(field->is_ruled);
    EXPECT_LE(field->error_fx32, kMostReach + kProjectiveTruncations_fx32);
    SpanWalk walk(outline, part);
    const int32_t apart = std::max(slab.rows() / 3, 1);
    while (walk.next()) {
      const Span span = walk.span();
      if ((span.row - part.top) % apart != 0 && span.row != part.bottom - 1) continue;
      const DividedLanes lanes = field->of(span);
      for (const int32_t px : {0, span.width_px() / 2, span.width_px() - 1}) {
        const auto exact = spec::sample(vertices, span.left_px + px, span.row);
        const Lane lane = lanes.at(px);
        ASSERT_TRUE(holds(lane.u_fx32, lanes.margin_fx32(), exact->u));
        ASSERT_TRUE(holds(lane.v_fx32, lanes.margin_fx32(), exact->v));
        ASSERT_GE(lanes.denominator().start + px * lanes.denominator().step, 1 - 0x1p-20);
        ++pixels;
      }
      // What anchored lanes go by.
      ASSERT_LE(std::abs(lanes.denominator().step), field->turn * (1 + 0x1p-40));
      const double least =
          std::min(lanes.denominator().start,
                   lanes.denominator().start + (span.width_px() - 1) * lanes.denominator().step);
      for (const auto& n : {lanes.u_numerator_fx32(), lanes.v_numerator_fx32()}) {
        const double u = n.start / lanes.denominator().start;
        ASSERT_LE(std::abs(n.step - u * lanes.denominator().step) / least,
                  field->steepest_fx32 * (1 + 0x1p-20) + 1);
      }
    }
  });
  EXPECT_GT(fields, slabs / 2);
  EXPECT_GT(pixels, 8000);
}

// Where two rows are all there are, or numbers too large, there is no field.
TEST(ProjectiveSlab, HasNoFieldWhereNumbersMayNotFit) {
  const auto field_of = [](int32_t side, int32_t q, int32_t u, int32_t rows) {
    const std::vector<selvage_vertex> vertices = {{-side, -side, 0, 0, q},
                                                  {side, -side, u, 0, q},
                                                  {side - 1, side, u, u, q - 1},
                                                  {-side, side, 0, u, q}};
    Polygon polygon;
    EXPECT_EQ(examine(vertices, &polygon), SELVAGE_OK);
    SlabWalk walk(polygon, part_of(polygon, kEverywhere));
    const auto slab = from_left_to_right(*walk.next());
    const SlabOutline corners_of(*slab);
    const Polygon outline = corners_of.polygon();
    return ruled_field(*slab, outline, {-100, slab->first_row, 100, slab->first_row + rows});
  };
  EXPECT_TRUE(field_of(1 << 16, 1 << 20, 1 << 24, 3));
  EXPECT_FALSE(field_of(1 << 16, 1 << 20, 1 << 24, 2));
  EXPECT_TRUE(field_of(1 << 20, 1 << 20, 1 << 24, 8));
  EXPECT_FALSE(field_of(SELVAGE_X_END - 1, SELVAGE_Q_MAX, INT32_MAX, 8));
}

TEST(ProjectiveSlab, HasNoFieldWhereItsEdgesCross) {
  const selvage_vertex v[] = {
      {0, 0, 0, 0, 1}, {900, 9000, 0, 0, 2}, {900, 0, 9, 0, 1}, {0, 9000, 99, 0, 1}};
  const Slab slab{Edge(v[0], v[1]), Edge(v[2], v[3]), 0, 30};
  const SlabOutline corners_of(slab);
  EXPECT_FALSE(ruled_field(slab, corners_of.polygon(), {0, 0, 3, 30}));
}

// Half way to the apex of edges that nearly meet, the reach is too large; where they meet in a row,
// it is infinite.
TEST(ProjectiveSlab, HasNoFieldWhereItReachesTooFar) {
  for (const int32_t apart : {0, 1, 1 << 16}) {
    const std::vector<selvage_vertex> vertices = {{0, 128, 0, 0, 1 << 20},
                                                  {apart, 128, 5, 0, 1 << 20},
                                                  {1 << 22, 1 << 16, 99, 0, 1 << 19},
                                                  {-1 << 22, 1 << 16, 0, 99, 1 << 20}};
    Polygon polygon;
    ASSERT_EQ(examine(vertices, &polygon), SELVAGE_OK);
    SlabWalk walk(polygon, part_of(polygon, kEverywhere));
    const auto slab = from_left_to_right(*walk.next());
    ASSERT_TRUE(slab);
    const SlabOutline corners_of(*slab);
    const Polygon outline = corners_of.polygon();
    const selvage_rect part{-2000, slab->first_row, 2000, slab->end_row};
    EXPECT_EQ(ruled_field(*slab, outline, part).has_value(), apart > 1);
  }
}

// Rows without pixels far from both edges, above rows with near-ties: the exact map is not asked
// for the former, whose numbers may not fit. The target's rows overlap, and only its last ones are
// drawn.
TEST(RuledRows, AreNotDecidedWhereTheyAreEmpty) {
  constexpr int32_t kLast_fx8 = 20000 * 256, kFar_fx8 = 8388000, kPitch = 64;
  std::vector<uint8_t> pixels(20010 * kPitch + 32768), texels(1024);
  for (size_t i = 0; i < texels.size(); ++i) texels[i] = static_cast<uint8_t>(i * 37 >> 2);
  const selvage_texture texture{texels.data(),       32,     32, 32, SELVAGE_INDEX8,
                                SELVAGE_LAYOUT_ROWS, nullptr};
  const Surface surface{
      {pixels.data(), 32768, 20010, kPitch, SELVAGE_INDEX8}, texture, SELVAGE_ADDRESS_WRAP};
  spec::Random random(8);
  for (int i = 0; i < 400; ++i) {
    const int32_t u = random.in(-(1 << 20), 1 << 20), least = INT32_MIN + 65536;
    const std::vector<selvage_vertex> vertices = {
        {SELVAGE_X_MIN, SELVAGE_X_MIN, least, least, SELVAGE_Q_MAX},
        {SELVAGE_X_MIN, kLast_fx8, least, least, SELVAGE_Q_MAX},
        {kFar_fx8, kLast_fx8 + 1024, u, u, SELVAGE_Q_MAX},
        {kFar_fx8, kLast_fx8 + 2048, u, u, SELVAGE_Q_MAX},
        {SELVAGE_X_MIN + 1, kLast_fx8, INT32_MAX, INT32_MAX, SELVAGE_Q_MAX},
        {SELVAGE_X_MIN + 1, SELVAGE_X_MIN, INT32_MAX, INT32_MAX, SELVAGE_Q_MAX}};
    Polygon polygon;
    ASSERT_EQ(examine(vertices, &polygon), SELVAGE_OK);
    const selvage_rect part = part_of(polygon, {32740, 19980, 32760, 20006});
    RuledMap map;
    SlabWalk slabs(polygon, part);
    while (const auto slab = slabs.next()) ASSERT_TRUE(map.add(*slab));
    BatchWalk walk(polygon, part, find_spans_scalar);
    SpanBatch batch;
    ASSERT_TRUE(walk.next(&batch));
    ASSERT_TRUE(batch.span(0).empty());
    ASSERT_GT(batch.widest_px, 0);
    RuledRows rows;
    find_lanes(map.slabs(), batch, find_ruled_lanes_scalar, &rows);
    const RuledSpans spans{batch, rows, polygon.texels, ExactMap(map)};
    for_each_row(spans, [&](const AffineSpans& row) {
      scalar_kernels(SELVAGE_FILTER_NEAREST).draw_affine(row, surface);
    });
    const std::vector<uint8_t> wanted = pixels;
    for (const selvage_kernel kernel : usable_kernels()) {
      const Kernels* const kernels = vector_kernels(kernel, SELVAGE_FILTER_NEAREST);
      if (kernels == nullptr) continue;
      std::ranges::fill(pixels, uint8_t{0});
      kernels->draw_ruled(spans, surface);
      for (int32_t row = 20004; row < 20006; ++row) {
        const Span span = batch.span(row - batch.first_row);
        for (int32_t px = span.left_px; px < span.right_px; ++px) {
          const auto at = static_cast<size_t>(row * kPitch + px);
          ASSERT_EQ(pixels[at], wanted[at]) << i << ", kernel " << kernel;
        }
      }
    }
  }
}

[[nodiscard]] int128 any_integer(spec::Random& random) {
  int128 n = 0;
  for (int i = 0; i < 4; ++i)
    n = (n << 32) | static_cast<uint32_t>(random.in(INT32_MIN, INT32_MAX));
  return n >> random.in(0, 127);
}

// Within two roundings of what one would be.
TEST(ToDouble, RoundsTwiceAtMost) {
  spec::Random random(5);
  for (int i = 0; i < 100000; ++i) {
    const int128 n = any_integer(random);
    const auto once = static_cast<double>(n);
    ASSERT_LE(std::abs(to_double(n) - once), 0x1p-52 * std::abs(once)) << i;
  }
  for (const int shift : {0, 51, 52, 53, 103, 104, 126}) {
    for (const int sign : {-1, 1}) {
      const int128 power = sign * (int128{1} << shift);
      EXPECT_EQ(to_double(power), sign * std::ldexp(1, shift)) << shift;
      if (shift < 53) {
        EXPECT_EQ(to_double(power - 1), sign * std::ldexp(1, shift) - 1) << shift;
      }
    }
  }
  EXPECT_EQ(to_double(~(int128{1} << 127)), 0x1p127);
  EXPECT_EQ(to_double(int128{0}), 0);
}

// Of numbers that fit when they are shifted, so that the remainder tells.
TEST(LaneDivisor, Floors) {
  spec::Random random(6);
  for (int i = 0; i < 100000; ++i) {
    const int128 d = (any_integer(random) & ((int128{1} << 77) - 1)) + 1;
    const int128 whole = d * random.in(-32768, 32768);
    const int128 n = random.percent(30) ? whole + random.in(-2, 3)
                                        : whole + remainder_of(any_integer(random), d);
    const int64_t floor = LaneDivisor(d).floor_fx32(n);
    const int128 rest = n * (int128{1} << kLaneFraction) - int128{floor} * d;
    ASSERT_TRUE(rest >= 0 && rest < d) << i;
  }
}

}  // namespace
}  // namespace selvage::mapper
