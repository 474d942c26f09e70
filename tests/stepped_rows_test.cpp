// Stepped rows, by every kernel, held against their definition (mapper/stepped.h): with borders of
// texels at every pixel, and a unit or a few beside.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "mapper/stepped.h"
#include "mapper/vector/kernel.h"
#include "spec/random.h"
#include "spec/vertex_units.h"
#include "tests/kernel_support.h"
#include "tests/lane_units.h"

namespace selvage::mapper {
namespace {

using spec::kTexel_fx16;

struct SteppedRow {
  DividedLanes::Linear u_fx32, v_fx32, denominator;
  int64_t error_fx32;
  int32_t width_px, segment_px;
};

// One coordinate of a stepped row: segments between values that are lowered by their error; floors
// of starts, of steps, of lanes at every 16 pixels, and of the steps from there.
class Coordinate {
 public:
  Coordinate(const SteppedRow& row, const DividedLanes::Linear& numerator_fx32)
      : row_(row), numerator_fx32_(numerator_fx32) {}

  // In units of 2^-16 texel.
  [[nodiscard]] int64_t at(int32_t px) const {
    const int32_t first = px / row_.segment_px * row_.segment_px;
    const int32_t end = std::min(first + row_.segment_px, row_.width_px - 1);
    const double start = value_fx16(first);
    const double step =
        end == first ? 0 : (value_fx16(end) - start) * (1.0 / static_cast<double>(end - first));
    const auto step_units = static_cast<int64_t>(std::floor(step * kFx32PerFx16));
    const int32_t group = (px - first) / 16 * 16;
    const int64_t lane = static_cast<int64_t>(std::floor(start)) * 65536 + group * step_units;
    return (lane >> 16) + ((px - first - group) * step_units >> 16);
  }

 private:
  [[nodiscard]] double value_fx16(int32_t px) const {
    const double w = 1.0 / (row_.denominator.start + px * row_.denominator.step);
    const double numerator_fx16 =
        numerator_fx32_.start / kFx32PerFx16 + px * (numerator_fx32_.step / kFx32PerFx16);
    return numerator_fx16 * w - static_cast<double>(row_.error_fx32) / kFx32PerFx16;
  }

  const SteppedRow& row_;
  DividedLanes::Linear numerator_fx32_;
};

[[nodiscard]] uint32_t wrapped(int64_t texel) {
  return static_cast<uint32_t>(texel) % uint32_t{kRowTexture_texel};
}

[[nodiscard]] selvage_choice choice_of(const spec::Case& c, selvage_kernel kernel,
                                       int32_t tolerance) {
  spec::Canvas target(c.format, c.target_width_px, c.target_height_px, 0, false, 0);
  const spec::Canvas texture(c.format, c.texture_width_texel, c.texture_height_texel, 0, false, 0);
  const selvage_image image = target.image();
  const selvage_texture view = texture.texture();
  const selvage_options options{c.profile, c.filter, c.address, tolerance, kernel};
  selvage_choice choice{-1, -1, -1};
  EXPECT_EQ(selvage_choose(&image, nullptr, c.vertices.data(), c.vertices.size(), &view, &options,
                           &choice),
            SELVAGE_OK);
  return choice;
}

class SteppedRows : public testing::Test {
 protected:
  SteppedRows() {
    for (uint32_t t = 0; t < kRowTexture_texel; ++t) {
      for (uint32_t s = 0; s < kRowTexture_texel; ++s) texels_.push_back(s | t << 16);
    }
    for (const selvage_kernel kernel : usable_kernels()) {
      draws_.push_back(kernel == SELVAGE_KERNEL_SCALAR
                           ? draw_stepped_scalar
                           : vector_kernels(kernel, SELVAGE_FILTER_NEAREST)->draw_stepped);
    }
  }

  // All kernels draw the pixels [left, right) of the row as they are defined, and no other.
  void expect_drawn(const SteppedRow& row, int32_t left_px, int32_t right_px) {
    right_px = std::min(right_px, row.width_px);
    const Coordinate u(row, row.u_fx32), v(row, row.v_fx32);
    std::vector<uint32_t> wanted(static_cast<size_t>(row.width_px), kUntouched);
    for (int32_t px = left_px; px < right_px; ++px) {
      wanted[static_cast<size_t>(px)] = wrapped(u.at(px) >> 16) | wrapped(v.at(px) >> 16) << 16;
    }
    const auto line = [](const DividedLanes::Linear& of) {
      return ProjectiveField::Form{of.start, of.step, 0};
    };
    const ProjectiveField field{
        0, 0, line(row.u_fx32), line(row.v_fx32), line(row.denominator), row.error_fx32};
    const SpanBatch part = one_span({0, left_px, right_px}), whole = one_span({0, 0, row.width_px});
    const SteppedSpans stepped{part, whole, field, &row.segment_px};
    std::vector<uint32_t> drawn(wanted.size());
    const Surface surface{
        {drawn.data(), row.width_px, 1, ptrdiff_t{4} * row.width_px, SELVAGE_RGBA8888},
        {texels_.data(), kRowTexture_texel, kRowTexture_texel, 4 * kRowTexture_texel,
         SELVAGE_RGBA8888, SELVAGE_LAYOUT_ROWS, nullptr},
        SELVAGE_ADDRESS_WRAP};
    for (const auto draw : draws_) {
      std::ranges::fill(drawn, kUntouched);
      draw(stepped, surface);
      ASSERT_EQ(drawn, wanted);
    }
  }

 private:
  static constexpr uint32_t kUntouched = 0xABABABAB;
  std::vector<uint32_t> texels_;
  std::vector<void (*)(const SteppedSpans&, const Surface&)> draws_;
};

void shift(DividedLanes::Linear* numerator_fx32, const SteppedRow& row, int64_t by_fx16) {
  const double by_fx32 = static_cast<double>(by_fx16) * kFx32PerFx16;
  numerator_fx32->start += by_fx32 * row.denominator.start;
  numerator_fx32->step += by_fx32 * row.denominator.step;
}

// Both coordinates moved to so many units past a border at some pixel: u right of one, v left of
// it.
[[nodiscard]] SteppedRow with_border(SteppedRow row, int32_t px, int32_t beyond_fx16,
                                     int32_t border_texel) {
  const int64_t border_fx16 = int64_t{border_texel} * kTexel_fx16;
  const int64_t u = Coordinate(row, row.u_fx32).at(px), v = Coordinate(row, row.v_fx32).at(px);
  shift(&row.u_fx32, row, border_fx16 + beyond_fx16 - u);
  shift(&row.v_fx32, row, border_fx16 - beyond_fx16 - v);
  return row;
}

struct Border {
  int32_t texel;
  bool of_u, of_v;
};

// Of the texture too, where one coordinate is well inside.
TEST_F(SteppedRows, AreDrawnByTheirDefinitionWithBordersAtEveryPixel) {
  constexpr int64_t kSteps[] = {0x8000,
                                0xAAAB,
                                43691 + 5 * kTexel_fx16,
                                kTexel_fx32,
                                kTexel_fx32 - 1,
                                kTexel_fx32 - 0xAAAB,
                                kTexel_fx32 / 7,
                                kTexel_fx32 * 5 / 2 + 1};
  constexpr Border kBorders[] = {{20, true, true},
                                 {0, true, false},
                                 {0, false, true},
                                 {kRowTexture_texel, true, false},
                                 {kRowTexture_texel, false, true}};
  constexpr DividedLanes::Linear kStill_fx32{30.5 * 0x1p32, 0};
  constexpr int32_t kWidth_px = 102;
  const auto all_spans = [&](const SteppedRow& row, int32_t px) {
    expect_drawn(row, 0, kWidth_px);
    expect_drawn(row, std::max(px - 3, 0), px + 18);
    expect_drawn(row, std::max(px - 3, 0), px + 1);
    expect_drawn(row, px, px + 9);
  };
  for (const int64_t step : kSteps) {
    for (const int sign : {1, -1}) {
      for (int32_t px = 0; px < 2 * kStepGroup_px + 3; ++px) {
        for (const int32_t beyond_fx16 : {-1, 0, 3, 13}) {
          for (const Border& border : kBorders) {
            // Values start at a whole unit, or the least that is below one.
            const auto start_fx32 = static_cast<double>(5 - px % 2);
            const auto step_fx32 = static_cast<double>(sign * step);
            const int32_t segment_px = px % 3 == 0 ? 48 : kWidth_px;
            const DividedLanes::Linear rises{start_fx32, step_fx32}, falls{start_fx32, -step_fx32};
            SteppedRow row = with_border({rises, falls, {1, 0}, 5, kWidth_px, segment_px}, px,
                                         beyond_fx16, border.texel);
            if (!border.of_u) row.u_fx32 = kStill_fx32;
            if (!border.of_v) row.v_fx32 = kStill_fx32;
            all_spans(row, px);
            if (HasFatalFailure()) FAIL() << step << ", border at " << px << ", " << beyond_fx16;
          }
        }
      }
    }
  }
}

// Along many pixels each unit of 2^-32 texel of a step counts.
TEST_F(SteppedRows, AreDrawnByTheirDefinitionHoweverLong) {
  for (uint64_t seed = 1; seed <= 400; ++seed) {
    spec::Random random(seed);
    const int32_t width_px = random.in(4000, 20000);
    const int32_t segment_px = random.percent(50) ? 16 * random.in(3, 700) : width_px;
    const double grows = random.in(-width_px / 2, width_px) / static_cast<double>(width_px);
    const auto numerator = [&] {
      // No further than 2^14 texels at q = 1, and twice as far at q = 1/2.
      const double most_fx32 = std::min(std::exp2(random.in(12, 38)), 0x1p46 / width_px);
      return DividedLanes::Linear{0, most_fx32 * random.in(-1000000, 1000000) / 1000000};
    };
    SteppedRow row{numerator(),        numerator(), {1, grows / width_px},
                   random.in(2, 4097), width_px,    std::min(segment_px, width_px)};
    const int32_t px = random.percent(20) ? width_px - 1 : random.in(0, width_px);
    row = with_border(row, px, random.in(-1, 1), 20);
    expect_drawn(row, std::max(px - random.in(1, 40), 0), px + random.in(1, 40));
    if (HasFatalFailure()) FAIL() << "seed " << seed;
  }
}

// Segments are made some at a time.
TEST_F(SteppedRows, AreDrawnByTheirDefinitionHoweverManySegments) {
  for (int32_t segments = 1; segments <= 70; ++segments) {
    for (const int32_t more_px : {-1, 0, 1, 2}) {
      const int32_t width_px = 48 * segments + more_px;
      expect_drawn({{0, 0x1p35}, {0, 0x1p34}, {1, 1.0 / width_px}, 5, width_px, 48}, 0, width_px);
      if (HasFatalFailure()) FAIL() << segments << " segments and " << more_px << " px";
    }
  }
}

// A coordinate that is 1/65536 texel all along the row: what roundings leave of it goes down by
// next to nothing, which is a step of -1/2^32 texel for all kernels.
TEST_F(SteppedRows, StepDownByNextToNothing) {
  int lower = 0;
  for (int32_t q = 1000; q < 3000; ++q) {
    constexpr int32_t kWidth_px = 200;
    const DividedLanes::Linear denominator{static_cast<double>(q), 1.0 + q % 7};
    const DividedLanes::Linear unit_fx32{denominator.start * kFx32PerFx16,
                                         denominator.step * kFx32PerFx16};
    const SteppedRow row{unit_fx32, unit_fx32, denominator, 3, kWidth_px, 48};
    const Coordinate u(row, row.u_fx32);
    for (int32_t px = 0; px < kWidth_px; ++px) lower += u.at(px) < 0 ? 1 : 0;
    expect_drawn(row, 0, kWidth_px);
    if (HasFatalFailure()) FAIL() << q;
  }
  EXPECT_GT(lower, 0);
}

// The same, of a polygon.
TEST(SteppedQuads, AreDrawnTheSameNextToABorder) {
  spec::Case c;
  c.target_width_px = 300;
  c.target_height_px = 1;
  c.texture_width_texel = c.texture_height_texel = 64;
  c.address = SELVAGE_ADDRESS_WRAP;
  for (int32_t q = 1000; q < 1100; ++q) {
    const int32_t right_fx8 = 300 * 256, right_fx16 = 300 * kTexel_fx16, far = q + q / 2;
    c.vertices = {{0, 0, 0, 1, q},
                  {right_fx8, 0, right_fx16, 1, far},
                  {right_fx8, 256, right_fx16, 1, far},
                  {0, 256, 0, 1, q}};
    const spec::Canvas scalar = drawing_of(c, SELVAGE_KERNEL_SCALAR, 2 * kTexel_fx16);
    for (const selvage_kernel kernel : stepping_kernels()) {
      ASSERT_TRUE(drawing_of(c, kernel, 2 * kTexel_fx16) == scalar)
          << "kernel " << kernel << ", q " << q;
    }
  }
}

// Rows too narrow for segments, seen through a pixel.
TEST(SteppedTriangles, AreDrawnByTheirTipToo) {
  spec::Case c;
  c.target_width_px = c.target_height_px = 300;
  c.texture_width_texel = c.texture_height_texel = 64;
  const int32_t end_fx8 = 300 * 256, end_fx16 = 60 * kTexel_fx16;
  c.vertices = {{0, 0, 0, 0, 1 << 20},
                {end_fx8, end_fx8, end_fx16, end_fx16, 3 << 19},
                {0, end_fx8, 0, end_fx16, 1 << 20}};
  const spec::Canvas whole = drawing_of(c, SELVAGE_KERNEL_SCALAR, kTexel_fx16);
  EXPECT_FALSE(whole == drawing_of(c, SELVAGE_KERNEL_SCALAR)) << "all rows are exact";
  c.has_clip = true;
  for (const int32_t row : {0, 1, 2, 40, 90, 150, 220, 299}) {
    for (int32_t px = 0; px <= row; px += 1 + row / 8) {
      c.clip = {px, row, px + 1, row + 1};
      const spec::Canvas pixel = drawing_of(c, SELVAGE_KERNEL_SCALAR, kTexel_fx16);
      EXPECT_EQ(pixel.pixel(px, row), whole.pixel(px, row)) << px << ", " << row;
    }
  }
}

// Batches of rows, each of as many segments as it needs, the longest ones of many groups.
TEST(SteppedTriangles, AreDrawnTheSameByAllKernels) {
  spec::Case c;
  c.target_width_px = 800;
  c.target_height_px = 150;
  c.texture_width_texel = c.texture_height_texel = 64;
  const int32_t end_fx16 = 90 * kTexel_fx16;
  c.vertices = {{-9000, -700, 0, 0, 1 << 20},
                {820 * 256, 30 * 256, end_fx16, end_fx16 / 2, 5 << 18},
                {77 * 256, 170 * 256, -end_fx16, end_fx16, 1 << 20}};
  for (const int32_t tolerance_fx16 : {5000, 8000, 20000, 100000, 1 << 20}) {
    for (const selvage_address address : {SELVAGE_ADDRESS_CLAMP, SELVAGE_ADDRESS_WRAP}) {
      for (const int32_t clipped_px : {0, 1, 16, 100, 311}) {
        c.address = address;
        c.has_clip = clipped_px != 0;
        c.clip = {clipped_px, clipped_px % 7, 800 - clipped_px, 150};
        const spec::Canvas scalar = drawing_of(c, SELVAGE_KERNEL_SCALAR, tolerance_fx16);
        EXPECT_FALSE(scalar == drawing_of(c, SELVAGE_KERNEL_SCALAR)) << "all rows are exact";
        for (const selvage_kernel kernel : stepping_kernels()) {
          EXPECT_TRUE(drawing_of(c, kernel, tolerance_fx16) == scalar)
              << "kernel " << kernel << ", tolerance " << tolerance_fx16 << ", clip " << clipped_px;
        }
      }
    }
  }
}

// Far below its top, which is not seen: the rows that bend least are those at the bottom.
TEST(SteppedTriangles, AreSteppedFarBelowTheirTop) {
  spec::Case c;
  c.target_width_px = 800;
  c.target_height_px = 20;
  c.texture_width_texel = c.texture_height_texel = 64;
  const int32_t top_fx8 = -300 * 256, bottom_fx8 = 200 * 256;
  c.vertices = {{-400 * 256, top_fx8, 0, 0, 1 << 20},
                {1200 * 256, top_fx8, 300 * kTexel_fx16, 0, 3 << 19},
                {400 * 256, bottom_fx8, 30 * kTexel_fx16, 0, 3 << 20}};
  for (const selvage_kernel kernel : stepping_kernels()) {
    EXPECT_FALSE(drawing_of(c, kernel, kTexel_fx16) == drawing_of(c, kernel)) << kernel;
  }
}

// Where short segments cost a kernel more than exact rows do, it draws exactly, and says so; where
// one does for all of the row, as the scalar one.
TEST(KernelsOfWideSteps, TakeNoShortOnes) {
  spec::Case c;
  c.target_width_px = 800;
  c.target_height_px = 20;
  c.texture_width_texel = c.texture_height_texel = 64;
  const int32_t right_fx8 = 800 * 256, bottom_fx8 = 20 * 256, end_fx16 = 300 * kTexel_fx16;
  c.vertices = {{0, 0, 0, 0, 1 << 20},
                {right_fx8, 0, end_fx16, 0, 3 << 19},
                {right_fx8, bottom_fx8, end_fx16, kTexel_fx16, 3 << 19},
                {0, bottom_fx8, 0, kTexel_fx16, 1 << 20}};
  constexpr int32_t kWhole_fx16 = 64 * kTexel_fx16;
  const spec::Canvas of_one_segment = drawing_of(c, SELVAGE_KERNEL_SCALAR, kWhole_fx16);
  const std::vector<selvage_kernel> stepping = stepping_kernels();
  for (const selvage_kernel kernel : usable_kernels()) {
    const bool steps = std::ranges::find(stepping, kernel) != stepping.end();
    EXPECT_EQ(drawing_of(c, kernel, kTexel_fx16) == drawing_of(c, kernel), !steps) << kernel;
    EXPECT_EQ(choice_of(c, kernel, kTexel_fx16).method,
              steps ? SELVAGE_METHOD_SUBDIVIDED : SELVAGE_METHOD_EXACT_PERSPECTIVE)
        << kernel;
    EXPECT_TRUE(drawing_of(c, kernel, kWhole_fx16) == of_one_segment) << kernel;
    EXPECT_EQ(choice_of(c, kernel, kWhole_fx16).method, SELVAGE_METHOD_AFFINE_FOR_PERSPECTIVE)
        << kernel;
  }
}

}  // namespace
}  // namespace selvage::mapper
