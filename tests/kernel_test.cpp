#include "mapper/kernel.h"
#include "mapper/kernel_choice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "mapper/kernel_preference.h"
#include "mapper/vector/kernel.h"
#include "spec/generate.h"
#include "spec/laws.h"
#include "tests/kernel_support.h"
#include "tests/span_support.h"

namespace selvage::mapper {
namespace {

// 2^40 where addresses have 64 bits: further than the 32 of a lane reach.
constexpr ptrdiff_t kFar_bytes = ptrdiff_t{1} << 5 * sizeof(ptrdiff_t);

[[nodiscard]] selvage_options nearest_by(selvage_kernel kernel) {
  return {SELVAGE_PROFILE_EXACT, SELVAGE_FILTER_NEAREST, SELVAGE_ADDRESS_CLAMP, 0, kernel};
}

// A span from x = 1 to x = 5 over u = `first` .. `first` + 4 texels, v = 0.
[[nodiscard]] SpanMap one_to_one(int32_t first_texel) {
  const auto at = [](int32_t x_px, int32_t u_texel) {
    return EdgePoint{.height = 256,
                     .x = int64_t{x_px} * 256 * 256,
                     .uq = int128{u_texel} * 65536 * 256,
                     .vq = 0,
                     .q = 256};
  };
  return {at(1, first_texel), at(5, first_texel + 4)};
}

template <class Pixel>
[[nodiscard]] std::vector<Pixel> drawn_row(selvage_kernel kernel, selvage_format format,
                                           selvage_address address, int32_t first_texel,
                                           bool affine) {
  const std::vector<Pixel> texels = {10, 11, 12};
  std::vector<Pixel> row(7, 99);
  const Surface surface{{row.data(), 7, 1, 7 * sizeof(Pixel), format},
                        {texels.data(), 3, 1, 3 * sizeof(Pixel), format, 0, nullptr},
                        address};
  const SpanMap map = one_to_one(first_texel);
  const Span span{0, 1, 5};
  const Kernels& kernels = kernels_for(nearest_by(kernel), surface.texture, {});
  if (affine) {
    const AffineField lanes = AffineLanes(map, span).field(span);
    kernels.draw_affine({one_span(span), lanes, kFarApart, ExactMap(map)}, surface);
  } else {
    const ProjectiveField lanes = ProjectiveLanes(map, span).field(span);
    kernels.draw_projective({one_span(span), lanes, kFarApart, ExactMap(map)}, surface);
  }
  return row;
}

template <class Pixel>
void expect_rows(selvage_kernel kernel, selvage_format format) {
  using Row = std::vector<Pixel>;
  for (const bool affine : {false, true}) {
    const auto row = [&](selvage_address address, int32_t first_texel) {
      return drawn_row<Pixel>(kernel, format, address, first_texel, affine);
    };
    EXPECT_EQ(row(SELVAGE_ADDRESS_CLAMP, -1), (Row{99, 10, 10, 11, 12, 99, 99}));
    EXPECT_EQ(row(SELVAGE_ADDRESS_CLAMP, 0), (Row{99, 10, 11, 12, 12, 99, 99}));
    EXPECT_EQ(row(SELVAGE_ADDRESS_WRAP, -1), (Row{99, 12, 10, 11, 12, 99, 99}));
    EXPECT_EQ(row(SELVAGE_ADDRESS_WRAP, -302), (Row{99, 11, 12, 10, 11, 99, 99}));
  }
}

TEST(Kernel, WritesItsSpanAndNothingElse) {
  for (const selvage_kernel kernel : usable_kernels()) {
    SCOPED_TRACE(kernel);
    expect_rows<uint8_t>(kernel, SELVAGE_INDEX8);
    expect_rows<uint16_t>(kernel, SELVAGE_RGB565);
    expect_rows<uint32_t>(kernel, SELVAGE_RGBA8888);
  }
}

// One test for each, so that a run names those that this machine cannot test.
class EveryKernel : public testing::TestWithParam<selvage_kernel> {};

[[nodiscard]] std::string name_of(const testing::TestParamInfo<selvage_kernel>& kernel) {
  constexpr std::array kNames = {"Fastest", "Scalar", "Sse4", "Avx2", "Avx512", "Neon"};
  return kNames.at(static_cast<size_t>(kernel.param));
}

TEST_P(EveryKernel, DrawsWhatTheScalarOneDraws) {
  if (!is_usable(GetParam())) {
    GTEST_SKIP() << "untested: this build has no such kernel, or this machine cannot run it";
  }
  // The fastest is one of the others, or some of them.
  const uint64_t seeds = GetParam() == SELVAGE_KERNEL_FASTEST ? 2000 : 20000;
  for (uint64_t seed = 1; seed <= seeds; ++seed) {
    const spec::Case c = spec::generate(seed);
    ASSERT_TRUE(drawing_of(c, GetParam()) == drawing_of(c, SELVAGE_KERNEL_SCALAR))
        << "seed " << seed << "\n"
        << spec::print(c);
  }
}

INSTANTIATE_TEST_SUITE_P(Kernel, EveryKernel,
                         testing::Values(SELVAGE_KERNEL_FASTEST, SELVAGE_KERNEL_SSE4,
                                         SELVAGE_KERNEL_AVX2, SELVAGE_KERNEL_AVX512,
                                         SELVAGE_KERNEL_NEON),
                         name_of);

// v is 3 at every pixel although v q and q change: all of them are near-ties. Rows of 1 to 30 px.
TEST(Kernel, DecidesNearTiesOfNarrowRows) {
  constexpr int32_t texel = SELVAGE_SUBTEXELS, px = SELVAGE_SUBPIXELS;
  spec::Case c;
  c.target_width_px = 40;
  c.target_height_px = 50;
  c.texture_width_texel = c.texture_height_texel = 64;
  for (int32_t width_px = 1; width_px <= 30; ++width_px) {
    const int32_t right = (3 + width_px) * px;
    c.vertices = {{3 * px, 2 * px, 8 * texel, 3 * texel, 100},
                  {right, 2 * px, 40 * texel, 3 * texel, 301},
                  {right - px / 2, 49 * px, 40 * texel, 3 * texel, 403}};
    const spec::Canvas scalar = drawing_of(c, SELVAGE_KERNEL_SCALAR);
    for (const selvage_kernel kernel : usable_kernels()) {
      ASSERT_TRUE(drawing_of(c, kernel) == scalar) << "kernel " << kernel << "\n" << spec::print(c);
    }
    const spec::Judgement judgement = spec::find_law("MAP")->check(spec::built_in(), c);
    ASSERT_FALSE(judgement.violation) << spec::explain(*judgement.violation);
  }
}

// More rows than a batch has, about as wide as the widest that are drawn by strips.
TEST(Kernel, DrawsRowsAboutAsWideAsStripsGo) {
  constexpr int32_t texel = SELVAGE_SUBTEXELS, px = SELVAGE_SUBPIXELS;
  spec::Case c;
  c.target_width_px = 70;
  c.target_height_px = 140;
  c.texture_width_texel = c.texture_height_texel = 256;
  for (int32_t width_px = 62; width_px <= 67; ++width_px) {
    for (const int32_t texels_per_px : {1, 3}) {  // in windows, and not
      const int32_t right_u = width_px * texels_per_px * texel, low_v = 140 * texel;
      c.vertices = {{0, 0, 0, 7, 1},
                    {width_px * px, 0, right_u, 7, 1},
                    {width_px * px, 140 * px, right_u, low_v, 1},
                    {0, 140 * px, 0, low_v, 1}};
      const spec::Canvas scalar = drawing_of(c, SELVAGE_KERNEL_SCALAR);
      for (const selvage_kernel kernel : usable_kernels()) {
        ASSERT_TRUE(drawing_of(c, kernel) == scalar) << "kernel " << kernel << "\n" << print(c);
      }
    }
  }
}

// What the 32-bit places of the vector kernels cannot reach is drawn all the same.
TEST(Kernel, AddressesATextureOfAnyPitch) {
  const std::vector<uint8_t> texels = {10, 11, 12};
  std::vector<uint8_t> row(7, 99);
  const Surface far{{row.data(), 7, 1, 7, SELVAGE_INDEX8},
                    {texels.data(), 3, 1, kFar_bytes, SELVAGE_INDEX8, 0, nullptr},
                    SELVAGE_ADDRESS_CLAMP};
  const Surface near{
      far.target, {texels.data(), 3, 1, 3, SELVAGE_INDEX8, 0, nullptr}, SELVAGE_ADDRESS_CLAMP};
  const Kernels* const scalar = &scalar_kernels(SELVAGE_FILTER_NEAREST);
  for (const ptrdiff_t pitch : {ptrdiff_t{1} << 30, -(ptrdiff_t{1} << 30), -kFar_bytes}) {
    const Surface tall{
        far.target, {texels.data(), 3, 3, pitch, SELVAGE_INDEX8, 0, nullptr}, far.address};
    EXPECT_EQ(&kernels_for(nearest_by(SELVAGE_KERNEL_FASTEST), tall.texture, {}), scalar) << pitch;
  }
  Polygon at_the_end;
  at_the_end.texels.least_v_fx16 = INT32_MIN + 65535;
  EXPECT_EQ(&kernels_for(nearest_by(SELVAGE_KERNEL_FASTEST), far.texture, {}), scalar);
  for (const selvage_kernel kernel : usable_kernels()) {
    EXPECT_EQ(&kernels_for(nearest_by(kernel), far.texture, {}), scalar);
    EXPECT_EQ(&kernels_for(nearest_by(kernel), near.texture, {}) == scalar,
              kernel == SELVAGE_KERNEL_SCALAR);
    EXPECT_EQ(&kernels_for(nearest_by(kernel), near.texture, at_the_end), scalar);
  }
}

TEST(Kernel, IsTheOneAskedForOrThePreferredOne) {
  const std::vector<uint8_t> texels = {10, 11, 12};
  std::vector<uint8_t> row(7, 99);
  const Surface surface{{row.data(), 7, 1, 7, SELVAGE_INDEX8},
                        {texels.data(), 3, 1, 3, SELVAGE_INDEX8, 0, nullptr},
                        SELVAGE_ADDRESS_CLAMP};
  const auto by = [](selvage_kernel kernel, selvage_filter filter) {
    const Kernels* const vector = vector_kernels(kernel, filter);
    return vector != nullptr ? vector : &scalar_kernels(filter);
  };
  for (const selvage_filter filter : {SELVAGE_FILTER_NEAREST, SELVAGE_FILTER_FOUR}) {
    selvage_options options = nearest_by(SELVAGE_KERNEL_FASTEST);
    options.filter = filter;
    for (const bool affine : {false, true}) {
      Polygon polygon;
      polygon.affine = affine;
      const KernelOrder& order = kernel_order(filter, work_of(polygon, 0));
      const auto first = std::ranges::find_if(order, is_usable);
      ASSERT_NE(first, order.end());
      EXPECT_EQ(&kernels_for(options, surface.texture, polygon), by(*first, filter));
    }
    for (const selvage_kernel kernel : usable_kernels()) {
      options.kernel = kernel;
      EXPECT_EQ(&kernels_for(options, surface.texture, {}), by(kernel, filter)) << kernel;
    }
  }
}

// Of every work, and what does not fit vectors.
[[nodiscard]] std::vector<Polygon> polygons_of_every_work() {
  std::vector<Polygon> polygons;
  for (const bool affine : {false, true}) {
    for (const int32_t width_px : {kNarrow_px, kNarrow_px + 1}) {
      for (const int32_t least_fx16 : {0, INT32_MIN + 65535}) {
        Polygon polygon;
        polygon.affine = affine;
        polygon.right_px = width_px;
        polygon.texels.least_v_fx16 = least_fx16;
        polygons.push_back(polygon);
      }
    }
  }
  return polygons;
}

TEST(Kernel, IsTheSameChosenForAllPolygonsOfATextureAsForEach) {
  const std::vector<uint32_t> texels = {10, 11, 12};
  const std::vector<Polygon> polygons = polygons_of_every_work();
  std::vector<selvage_kernel> kernels = usable_kernels();
  kernels.push_back(SELVAGE_KERNEL_FASTEST);
  for (const ptrdiff_t pitch : {ptrdiff_t{12}, kFar_bytes}) {
    const selvage_texture texture{texels.data(), 3, 1, pitch, SELVAGE_RGBA8888, 0, nullptr};
    for (const selvage_filter filter : {SELVAGE_FILTER_NEAREST, SELVAGE_FILTER_AREA}) {
      for (const selvage_kernel kernel : kernels) {
        for (const int32_t tolerance : {0, 1}) {
          selvage_options options = nearest_by(kernel);
          options.filter = filter;
          options.tolerance = tolerance;
          const KernelChoice choice(options, texture);
          for (const Polygon& polygon : polygons) {
            EXPECT_EQ(&choice.of(polygon), &kernels_for(options, texture, polygon));
          }
        }
      }
    }
  }
}

TEST(Kernel, OnlyTheFastestAndTheScalarOneAreEverywhere) {
  EXPECT_TRUE(is_usable(SELVAGE_KERNEL_FASTEST));
  EXPECT_TRUE(is_usable(SELVAGE_KERNEL_SCALAR));
  EXPECT_FALSE(is_usable(SELVAGE_KERNEL_NEON + 1));
  EXPECT_FALSE(is_usable(-1));
}

// The scalar kernel runs everywhere: none that follows it is looked for.
TEST(KernelOrder, EndsAtTheScalarKernel) {
  constexpr selvage_filter kNearest = SELVAGE_FILTER_NEAREST;
  for (const selvage_kernel each : usable_kernels()) {
    const KernelOrder order{each, SELVAGE_KERNEL_SCALAR, SELVAGE_KERNEL_SSE4, SELVAGE_KERNEL_AVX2,
                            SELVAGE_KERNEL_NEON};
    EXPECT_EQ(first_vector_kernels(order, kNearest), vector_kernels(each, kNearest)) << each;
  }
  EXPECT_EQ(first_vector_kernels({}, kNearest), nullptr);
}

// Whatever the machine: no machine has both of these.
TEST(FirstVectorKernels, PassOverWhatThereIsNotAndEndWithTheScalarOne) {
  const selvage_kernel absent =
      is_usable(SELVAGE_KERNEL_NEON) ? SELVAGE_KERNEL_AVX2 : SELVAGE_KERNEL_NEON;
  const std::vector<selvage_kernel> order = {absent, SELVAGE_KERNEL_SCALAR};
  EXPECT_EQ(first_vector_kernels(order, SELVAGE_FILTER_NEAREST), nullptr);
}

}  // namespace
}  // namespace selvage::mapper
