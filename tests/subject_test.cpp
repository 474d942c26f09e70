// Subjects whose calls are all made with one kernel.
#include "spec/subject.h"

#include <gtest/gtest.h>

#include <optional>

#include "spec/case.h"
#include "spec/laws.h"

namespace selvage::spec {
namespace {

// Notes which kernel each call asked it for.
struct Asked {
  selvage_kernel draw = -1, draw_many = -1, choose = -1;
};

[[nodiscard]] Subject noting(Asked* asked) {
  Subject subject;
  subject.draw = [asked](auto*, auto*, auto*, size_t, auto*, auto* options) {
    asked->draw = options->kernel;
    return SELVAGE_OK;
  };
  subject.draw_many = [asked](auto*, auto*, auto*, size_t, auto* options, int32_t, size_t*) {
    asked->draw_many = options->kernel;
    return SELVAGE_OK;
  };
  subject.choose = [asked](auto*, auto*, auto*, size_t, auto*, auto* options, auto*) {
    asked->choose = options->kernel;
    return SELVAGE_OK;
  };
  return subject;
}

void call_all(const Subject& subject, const selvage_options* options) {
  ASSERT_EQ(subject.draw(nullptr, nullptr, nullptr, 0, nullptr, options), SELVAGE_OK);
  ASSERT_EQ(subject.draw_many(nullptr, nullptr, nullptr, 0, options, 1, nullptr), SELVAGE_OK);
  ASSERT_EQ(subject.choose(nullptr, nullptr, nullptr, 0, nullptr, options, nullptr), SELVAGE_OK);
}

void expect_all(const Asked& asked, selvage_kernel kernel) {
  EXPECT_EQ(asked.draw, kernel);
  EXPECT_EQ(asked.draw_many, kernel);
  EXPECT_EQ(asked.choose, kernel);
}

TEST(TakenKernel, IsAskedForByAllCalls) {
  Asked asked;
  Subject subject = noting(&asked);
  take_kernel(SELVAGE_KERNEL_SCALAR, &subject);
  call_all(subject, nullptr);
  expect_all(asked, SELVAGE_KERNEL_SCALAR);
}

TEST(TakenKernel, LeavesOthersToTheCaller) {
  Asked asked;
  Subject subject = noting(&asked);
  take_kernel(SELVAGE_KERNEL_SCALAR, &subject);
  selvage_options options{};
  call_all(subject, &options);
  expect_all(asked, SELVAGE_KERNEL_SCALAR);
  options.kernel = SELVAGE_KERNEL_AVX2;
  call_all(subject, &options);
  expect_all(asked, SELVAGE_KERNEL_AVX2);
}

TEST(TakenKernel, NeedsNoMoreThanDraw) {
  Subject subject;
  subject.draw = built_in().draw;
  take_kernel(SELVAGE_KERNEL_SCALAR, &subject);
  EXPECT_FALSE(subject.draw_many);
  EXPECT_FALSE(subject.choose);
}

// Kernels step rows of different widths: told by another kernel, this case's bounds are not kept.
TEST(TakenKernel, TellsItsOwnBounds) {
  Case c;
  c.address = SELVAGE_ADDRESS_WRAP;
  c.target_width_px = c.target_height_px = 1;
  c.texture_width_texel = 1;
  c.texture_height_texel = 2;
  c.choice = 1;
  c.vertices = {{0, 256, 0, 0, 1}, {0, 0, 0, 0, 1}, {256, 0, 0, 0, 2}};
  const Law* const law = find_law("TOLERANCE");
  ASSERT_NE(law, nullptr);
  for (selvage_kernel kernel = SELVAGE_KERNEL_FASTEST; kernel <= SELVAGE_KERNEL_NEON; ++kernel) {
    if (selvage_has_kernel(kernel) == 0) continue;
    Subject subject = built_in();
    take_kernel(kernel, &subject);
    EXPECT_FALSE(law->check(subject, c).violation) << "kernel " << kernel;
  }
}

}  // namespace
}  // namespace selvage::spec
