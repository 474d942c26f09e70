// Rows in perspective that are divided for at each pixel: exact whatever their lanes are within the
// error they tell of, and where they rise or fall steeply.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "mapper/vector/kernel.h"
#include "spec/random.h"
#include "tests/kernel_support.h"
#include "tests/span_support.h"

namespace selvage::mapper {
namespace {

// A quad of one row of pixels: u and v in units of 2^-16 texel and q, left and right.
struct Sides {
  int32_t left_fx8, right_fx8;
  int32_t u[2], v[2], q[2];
};
[[nodiscard]] spec::Case one_row_quad(const Sides& sides) {
  spec::Case c;
  c.target_width_px = sides.right_fx8 / 256 + 1;
  c.target_height_px = 1;
  c.texture_width_texel = c.texture_height_texel = 64;
  c.address = SELVAGE_ADDRESS_WRAP;
  const auto vertex = [&](int side, int32_t y_fx8) {
    return selvage_vertex{side == 0 ? sides.left_fx8 : sides.right_fx8, y_fx8, sides.u[side],
                          sides.v[side], sides.q[side]};
  };
  c.vertices = {vertex(0, 0), vertex(1, 0), vertex(1, 256), vertex(0, 256)};
  return c;
}

void expect_as_scalar(const spec::Case& c, int32_t tolerance) {
  const spec::Canvas scalar = drawing_of(c, SELVAGE_KERNEL_SCALAR);
  for (const selvage_kernel kernel : usable_kernels()) {
    ASSERT_TRUE(drawing_of(c, kernel, tolerance) == scalar) << "kernel " << kernel << "\n"
                                                            << spec::print(c);
  }
}

class DividedRows : public testing::Test {
 protected:
  static constexpr int32_t kSide_texel = 64;

  DividedRows() {
    for (uint32_t t = 0; t < kSide_texel; ++t) {
      for (uint32_t s = 0; s < kSide_texel; ++s) texels_.push_back(s | t << 16);
    }
  }

  [[nodiscard]] std::vector<uint32_t> drawn(selvage_kernel kernel, const ProjectiveSpans& spans) {
    std::vector<uint32_t> pixels(static_cast<size_t>(spans.batch.widest_px), 0xABABABAB);
    const Surface surface{{pixels.data(), spans.batch.widest_px, 1,
                           ptrdiff_t{4} * spans.batch.widest_px, SELVAGE_RGBA8888},
                          {texels_.data(), kSide_texel, kSide_texel, 4 * kSide_texel,
                           SELVAGE_RGBA8888, SELVAGE_LAYOUT_ROWS, nullptr},
                          SELVAGE_ADDRESS_WRAP};
    const Kernels& kernels = kernel == SELVAGE_KERNEL_SCALAR
                                 ? scalar_kernels(SELVAGE_FILTER_NEAREST)
                                 : *vector_kernels(kernel, SELVAGE_FILTER_NEAREST);
    kernels.draw_projective(spans, surface);
    return pixels;
  }

 private:
  std::vector<uint32_t> texels_;
};

// The lanes of a field, off by so much at every pixel: u too high, v too low, or the reverse.
[[nodiscard]] ProjectiveField shifted(ProjectiveField field, int64_t by_fx32, int64_t error_fx32) {
  const auto add = [&](ProjectiveField::Form* line, int64_t by) {
    line->start += static_cast<double>(by) * field.denominator.start;
    line->step_x += static_cast<double>(by) * field.denominator.step_x;
  };
  add(&field.u_fx32, by_fx32);
  add(&field.v_fx32, -by_fx32);
  field.error_fx32 = error_fx32;
  return field;
}

// Coordinates that drift from below borders to above them, by four times what lanes may be off.
TEST_F(DividedRows, AreExactWhateverLanesAreWithinTheirError) {
  constexpr int32_t kWidth_px = 64;
  int rows = 0;
  for (const int bits : {2, 10, 16, 17, 20, 22, 24}) {
    const int64_t error_fx32 = int64_t{1} << bits;
    const int32_t drift_fx16 = std::max((1 << bits >> 16) * 4, 8);
    for (const int32_t pace_fx16 : {0, 16384, 32768, 65536, 131072}) {
      for (const int sign : {1, -1}) {
        for (int32_t offset_fx16 = -2; offset_fx16 <= 2; ++offset_fx16) {
          const int32_t drift = sign * drift_fx16;
          const auto ends = [&](int32_t pace, int32_t to) {
            const int32_t start = 10 * 65536 - pace / 2 - to / 2 + offset_fx16;
            return std::pair{start, start + pace * kWidth_px + to};
          };
          const auto u = ends(pace_fx16, drift), v = ends(65536 - pace_fx16 / 2, -drift);
          const spec::Case c = one_row_quad(
              {0, kWidth_px * 256, {u.first, u.second}, {v.first, v.second}, {1000, 1001}});
          for_each_span(
              c, [&](const spec::Case&, const Polygon&, const SpanMap& map, const Span& span) {
                ++rows;
                const SpanBatch batch = one_span(span);
                const ProjectiveField field = ProjectiveLanes(map, span).field(span);
                const auto wanted =
                    drawn(SELVAGE_KERNEL_SCALAR, {batch, field, kFarApart, ExactMap(map)});
                for (const int64_t off_fx32 : {-(error_fx32 - 3), int64_t{0}, error_fx32 - 3}) {
                  const ProjectiveField off = shifted(field, off_fx32, error_fx32);
                  const ProjectiveSpans spans{batch, off, kFarApart, ExactMap(map)};
                  for (const selvage_kernel kernel : usable_kernels()) {
                    ASSERT_EQ(drawn(kernel, spans), wanted)
                        << "kernel " << kernel << ", error " << error_fx32 << ", off " << off_fx32;
                  }
                }
              });
          if (HasFatalFailure()) return;
        }
      }
    }
  }
  EXPECT_EQ(rows, 7 * 5 * 2 * 5);
}

// The denominator nearly ends at the last pixel, or nearly begins at the first one: neighbours are
// a texel apart there, or many, and much less everywhere else.
TEST(SteepRows, AreExactWhereTheirLastPixelIsFarFromTheOthers) {
  for (uint64_t seed = 1; seed <= 400; ++seed) {
    spec::Random random(seed);
    const int32_t width_px = random.in(33, 60), slope = random.in(100, 3000);
    const int32_t least_q = std::max(slope * width_px / random.in(200, 900) - slope / 256, 1);
    const double second = least_q + slope * (1 + 1.0 / 256);  // q a pixel before the last one
    const double steepness = 0.05 * random.in(10, 24);
    const double texels = steepness * second * second / slope / least_q;
    const auto walk_fx16 = static_cast<int32_t>(std::min(texels, 30000.0) * 65536);
    const int32_t start_fx16 = random.in(0, 65536), still_fx16 = random.in(0, 1 << 22);
    const bool falls = random.percent(50), mirrored = random.percent(50), by_v = random.percent(50);
    Sides sides{128,
                width_px * 256 + 128 + 1,
                {start_fx16, start_fx16 + walk_fx16},
                {still_fx16, still_fx16 + random.in(0, 65536)},
                {least_q + slope * width_px, least_q}};
    if (falls) std::swap(sides.u[0], sides.u[1]);
    if (by_v) std::swap(sides.u, sides.v);
    if (mirrored) {
      for (auto* ends : {&sides.u, &sides.v, &sides.q}) std::swap((*ends)[0], (*ends)[1]);
      sides.left_fx8 -= 1, sides.right_fx8 -= 1;
    }
    expect_as_scalar(one_row_quad(sides), 0);
    if (HasFatalFailure()) FAIL() << "seed " << seed;
  }
}

// As steep as rows get: all of the texture from the first pixel to the second, and far beyond what
// 64 bits hold of a step. Within a tolerance such a row is not cut into pieces; it is exact.
TEST(SteepRows, AreExactHoweverSteep) {
  constexpr int32_t kStill_fx16 = (5 << 16) + 30000;  // no tie
  for (const bool falls : {false, true}) {
    for (const bool by_v : {false, true}) {
      Sides sides{128,
                  100 * 256 + 128,
                  {INT32_MIN + 65536, INT32_MAX - 30000},
                  {kStill_fx16, kStill_fx16},
                  {1, SELVAGE_Q_MAX}};
      if (falls) std::swap(sides.u[0], sides.u[1]);
      if (by_v) std::swap(sides.u, sides.v);
      expect_as_scalar(one_row_quad(sides), 1000);
      if (HasFatalFailure()) FAIL() << "falls " << falls << ", by v " << by_v;
    }
  }
}

// More vectors of near-ties than are put aside at a time. q differs from row to row alone, so that
// no plane holds them.
TEST(LongRows, AreExactWhereEveryPixelIsATie) {
  constexpr int32_t kWidth_px = 64 * kMostLanes + 300;
  spec::Case c = one_row_quad({768,
                               768 + kWidth_px * 256,
                               {-32768, kWidth_px * 65536 - 32768},
                               {5 << 16, 5 << 16},
                               {1000, 1000}});
  c.vertices[2].q = c.vertices[3].q = 2000;
  expect_as_scalar(c, 0);
  c.vertices[1].u = c.vertices[2].u = kWidth_px * 2 * 65536 - 65536;
  c.vertices[0].u = c.vertices[3].u = -65536;  // two texels a pixel: no windows
  expect_as_scalar(c, 0);
}

}  // namespace
}  // namespace selvage::mapper
