#include "measure/work_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "mapper/kernel.h"

namespace selvage::measure {
namespace {

inline constexpr std::byte kGuard{0xC3};
inline constexpr size_t kGuardBytes = 64;
inline constexpr size_t kPixels =
    static_cast<size_t>(WorkPicture::kWidth_px) * static_cast<size_t>(WorkPicture::kHeight_px);

// The memory of a picture between guard bytes.
class Memory {
 public:
  [[nodiscard]] std::byte* data() { return all_.data() + kGuardBytes; }
  [[nodiscard]] bool guards_stand() const {
    const auto is_guard = [](std::byte each) { return each == kGuard; };
    return std::all_of(all_.begin(), all_.begin() + kGuardBytes, is_guard) &&
           std::all_of(all_.end() - kGuardBytes, all_.end(), is_guard);
  }

 private:
  std::vector<std::byte> all_ =
      std::vector<std::byte>(SELVAGE_FASTEST_KERNEL_BYTES + 2 * kGuardBytes, kGuard);
};

// The target after one drawing.
[[nodiscard]] std::vector<std::byte> drawn(selvage_work work, selvage_format format,
                                           selvage_filter filter, selvage_kernel kernel) {
  Memory memory;
  const WorkPicture picture(format, memory.data());
  const selvage_image& target = picture.target();
  const auto bytes = static_cast<size_t>(target.pitch * target.height);
  auto* const pixels = static_cast<std::byte*>(target.pixels);
  std::fill_n(pixels, bytes, std::byte{0});
  picture.draw(work, filter, kernel);
  EXPECT_TRUE(memory.guards_stand());
  return {pixels, pixels + bytes};
}

// It would measure nothing if polygons were refused: nearly all of the target is drawn.
TEST(WorkPicture, FillsItsTargetAndNothingElse) {
  for (const selvage_format format : {SELVAGE_INDEX8, SELVAGE_RGB565, SELVAGE_RGBA8888}) {
    for (const selvage_work work :
         {SELVAGE_WORK_LARGE, SELVAGE_WORK_MESH, SELVAGE_WORK_PERSPECTIVE}) {
      const auto pixels = drawn(work, format, SELVAGE_FILTER_NEAREST, SELVAGE_KERNEL_SCALAR);
      const auto bytes_drawn = std::ranges::count(pixels, std::byte{0x5A});
      const auto share = static_cast<double>(bytes_drawn) / static_cast<double>(pixels.size());
      EXPECT_GT(share, 0.85) << "format " << format << ", work " << work;
      EXPECT_EQ(pixels.size() % kPixels, 0U);
    }
  }
}

TEST(WorkPicture, IsTheSameByEveryKernel) {
  for (const selvage_filter filter :
       {SELVAGE_FILTER_NEAREST, SELVAGE_FILTER_FOUR, SELVAGE_FILTER_BILINEAR}) {
    for (const selvage_work work :
         {SELVAGE_WORK_LARGE, SELVAGE_WORK_MESH, SELVAGE_WORK_PERSPECTIVE}) {
      const auto scalar = drawn(work, SELVAGE_RGBA8888, filter, SELVAGE_KERNEL_SCALAR);
      for (selvage_kernel each = SELVAGE_KERNEL_SSE4; each <= SELVAGE_KERNEL_NEON; ++each) {
        if (!mapper::is_usable(each)) continue;
        EXPECT_EQ(drawn(work, SELVAGE_RGBA8888, filter, each), scalar)
            << "kernel " << each << ", filter " << filter << ", work " << work;
      }
    }
  }
}

}  // namespace
}  // namespace selvage::measure
