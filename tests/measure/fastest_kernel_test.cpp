// selvage_fastest_kernel: what it answers, what it writes, what it refuses. How fast anything is is
// not tested.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>

#include "mapper/kernel_preference.h"
#include "selvage.hpp"

namespace selvage {
namespace {

inline constexpr std::byte kFill{0x6B};
inline constexpr size_t kBytes = SELVAGE_FASTEST_KERNEL_BYTES, kMore = 64;
inline constexpr selvage_kernel kNone = -7;

class FastestKernel : public testing::Test {
 protected:
  FastestKernel() { memory_.fill(kFill); }

  void expect_refused(selvage_status wanted, selvage_filter filter, selvage_format format,
                      selvage_work work, void* scratch, size_t bytes) {
    EXPECT_EQ(selvage_fastest_kernel(filter, format, work, scratch, bytes, &fastest_), wanted);
    EXPECT_EQ(fastest_, kNone);
    EXPECT_EQ(std::ranges::count(memory_, kFill), std::ssize(memory_)) << "something was written";
  }

  alignas(std::max_align_t) std::array<std::byte, kBytes + kMore> memory_;
  selvage_kernel fastest_ = kNone;
};

TEST_F(FastestKernel, IsOneThatThisMachineCanRun) {
  for (const selvage_format format : {SELVAGE_INDEX8, SELVAGE_RGB565, SELVAGE_RGBA8888}) {
    for (const selvage_work work :
         {SELVAGE_WORK_LARGE, SELVAGE_WORK_MESH, SELVAGE_WORK_PERSPECTIVE}) {
      for (const selvage_filter filter : {SELVAGE_FILTER_NEAREST, SELVAGE_FILTER_FOUR,
                                          SELVAGE_FILTER_BILINEAR, SELVAGE_FILTER_AREA}) {
        if (filter != SELVAGE_FILTER_NEAREST && format != SELVAGE_RGBA8888) continue;
        fastest_ = kNone;
        ASSERT_EQ(fastest_kernel(filter, format, work, std::span(memory_).first(kBytes), fastest_),
                  SELVAGE_OK);
        EXPECT_EQ(selvage_has_kernel(fastest_), 1) << fastest_;
        EXPECT_NE(fastest_, SELVAGE_KERNEL_FASTEST);
      }
    }
  }
  EXPECT_EQ(std::count(memory_.begin() + kBytes, memory_.end(), kFill), kMore) << "beyond scratch";
}

TEST_F(FastestKernel, RefusesWhatItDoesNotKnow) {
  const auto refused = [&](selvage_status wanted, selvage_filter filter, selvage_format format,
                           selvage_work work) {
    expect_refused(wanted, filter, format, work, memory_.data(), kBytes);
  };
  for (const int32_t unknown : {-1, 77, INT32_MIN, INT32_MAX}) {
    refused(SELVAGE_ERROR_FILTER, unknown, SELVAGE_RGBA8888, SELVAGE_WORK_LARGE);
    refused(SELVAGE_ERROR_TARGET_FORMAT, SELVAGE_FILTER_NEAREST, unknown, SELVAGE_WORK_LARGE);
    refused(SELVAGE_ERROR_MEASURE_WORK, SELVAGE_FILTER_NEAREST, SELVAGE_RGB565, unknown);
    refused(SELVAGE_ERROR_FILTER, unknown, unknown, unknown);
  }
  refused(SELVAGE_ERROR_FILTER, 4, SELVAGE_RGBA8888, SELVAGE_WORK_LARGE);
  refused(SELVAGE_ERROR_TARGET_FORMAT, SELVAGE_FILTER_NEAREST, 3, SELVAGE_WORK_LARGE);
  refused(SELVAGE_ERROR_MEASURE_WORK, SELVAGE_FILTER_AREA, SELVAGE_RGBA8888, 3);
  for (const selvage_filter filter :
       {SELVAGE_FILTER_FOUR, SELVAGE_FILTER_BILINEAR, SELVAGE_FILTER_AREA}) {
    refused(SELVAGE_ERROR_FILTER_FORMAT, filter, SELVAGE_INDEX8, SELVAGE_WORK_LARGE);
    refused(SELVAGE_ERROR_FILTER_FORMAT, filter, SELVAGE_RGB565, 3);
  }
}

TEST_F(FastestKernel, RefusesMemoryThatItCannotUse) {
  for (const selvage_filter filter : {SELVAGE_FILTER_NEAREST, SELVAGE_FILTER_AREA}) {
    const auto refused = [&](selvage_status wanted, void* scratch, size_t bytes) {
      expect_refused(wanted, filter, SELVAGE_RGBA8888, SELVAGE_WORK_LARGE, scratch, bytes);
    };
    refused(SELVAGE_ERROR_MEASURE_NULL, nullptr, kBytes);
    refused(SELVAGE_ERROR_MEASURE_ALIGNMENT, memory_.data() + 1, kBytes);
    refused(SELVAGE_ERROR_MEASURE_ALIGNMENT, memory_.data() + 1, 0);
    refused(SELVAGE_ERROR_MEASURE_SIZE, memory_.data(), kBytes - 1);
    refused(SELVAGE_ERROR_MEASURE_SIZE, memory_.data(), 0);
    EXPECT_EQ(selvage_fastest_kernel(filter, SELVAGE_RGBA8888, SELVAGE_WORK_LARGE, memory_.data(),
                                     kBytes, nullptr),
              SELVAGE_ERROR_MEASURE_NULL);
  }
}

TEST_F(FastestKernel, RefusesToWriteItsAnswerIntoItsScratchMemory) {
  const auto status_at = [&](size_t offset) {
    auto* const fastest = reinterpret_cast<selvage_kernel*>(memory_.data() + offset);
    return selvage_fastest_kernel(SELVAGE_FILTER_AREA, SELVAGE_RGBA8888, SELVAGE_WORK_LARGE,
                                  memory_.data() + sizeof(std::max_align_t), kBytes, fastest);
  };
  constexpr size_t kFirst = sizeof(std::max_align_t);
  for (const size_t offset : {kFirst, kFirst + 4, kFirst + kBytes - 4}) {
    EXPECT_EQ(status_at(offset), SELVAGE_ERROR_MEASURE_OVERLAP) << offset;
  }
  EXPECT_EQ(std::ranges::count(memory_, kFill), std::ssize(memory_));
  EXPECT_EQ(status_at(kFirst - 4), SELVAGE_OK);
  EXPECT_EQ(status_at(kFirst + kBytes), SELVAGE_OK);
}

// The static order: each kernel once, and of a polygon the work that it is.
TEST(KernelPreference, OrdersEveryKernel) {
  for (selvage_filter filter = SELVAGE_FILTER_NEAREST; filter <= SELVAGE_FILTER_AREA; ++filter) {
    for (selvage_work work = SELVAGE_WORK_LARGE; work <= SELVAGE_WORK_PERSPECTIVE; ++work) {
      mapper::KernelOrder order = mapper::kernel_order(filter, work);
      std::ranges::sort(order);
      EXPECT_EQ(order, (mapper::KernelOrder{SELVAGE_KERNEL_SCALAR, SELVAGE_KERNEL_SSE4,
                                            SELVAGE_KERNEL_AVX2, SELVAGE_KERNEL_AVX512,
                                            SELVAGE_KERNEL_NEON}));
    }
  }
}

TEST(KernelPreference, TellsPolygonsApart) {
  mapper::Polygon polygon;
  polygon.right_px = 32;
  EXPECT_EQ(mapper::work_of(polygon, 0), SELVAGE_WORK_MESH);
  polygon.right_px = 33;
  EXPECT_EQ(mapper::work_of(polygon, 1), SELVAGE_WORK_LARGE);
  polygon.affine = false;
  EXPECT_EQ(mapper::work_of(polygon, 0), SELVAGE_WORK_PERSPECTIVE);
  EXPECT_EQ(mapper::work_of(polygon, 1), SELVAGE_WORK_LARGE);
  polygon.left_px = 1;
  EXPECT_EQ(mapper::work_of(polygon, 1), SELVAGE_WORK_MESH);
}

}  // namespace
}  // namespace selvage
