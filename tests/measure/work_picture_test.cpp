#include "measure/work_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <vector>

#include "mapper/kernel_choice.h"

namespace selvage::measure {
namespace {

inline constexpr std::byte kGuard{0xC3};
inline constexpr size_t kGuardBytes = 64;
inline constexpr selvage_filter kFilters[] = {SELVAGE_FILTER_NEAREST, SELVAGE_FILTER_FOUR,
                                              SELVAGE_FILTER_BILINEAR, SELVAGE_FILTER_AREA};

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

using Paint = std::function<uint32_t(int32_t s, int32_t t)>;

void paint(const selvage_texture& texture, std::byte* memory, const Paint& texel) {
  std::byte* const first = memory + (static_cast<const std::byte*>(texture.texels) - memory);
  for (int32_t t = 0; t < texture.height; ++t) {
    for (int32_t s = 0; s < texture.width; ++s) {
      const uint32_t value = texel(s, t);
      std::memcpy(first + t * texture.pitch + s * ptrdiff_t{sizeof value}, &value, sizeof value);
    }
  }
}

// The target after one drawing, maybe from other texels.
[[nodiscard]] std::vector<std::byte> drawn(selvage_work work, selvage_format format,
                                           selvage_filter filter, selvage_kernel kernel,
                                           const Paint& texel = nullptr) {
  Memory memory;
  const WorkPicture picture(filter, format, memory.data());
  if (texel) paint(picture.texture(), memory.data(), texel);
  const selvage_image& target = picture.target();
  const auto bytes = static_cast<size_t>(target.pitch * target.height);
  auto* const pixels = static_cast<std::byte*>(target.pixels);
  std::fill_n(pixels, bytes, std::byte{0});
  picture.draw(work, kernel);
  EXPECT_TRUE(memory.guards_stand());
  return {pixels, pixels + bytes};
}

// It would measure nothing if polygons were refused: nearly all of the target is drawn.
TEST(WorkPicture, FillsItsTargetAndNothingElse) {
  for (const selvage_filter filter : kFilters) {
    for (const selvage_format format : {SELVAGE_INDEX8, SELVAGE_RGB565, SELVAGE_RGBA8888}) {
      if (filter != SELVAGE_FILTER_NEAREST && format != SELVAGE_RGBA8888) continue;
      for (const selvage_work work :
           {SELVAGE_WORK_LARGE, SELVAGE_WORK_MESH, SELVAGE_WORK_PERSPECTIVE}) {
        const auto pixels = drawn(work, format, filter, SELVAGE_KERNEL_SCALAR);
        const auto bytes_drawn = std::ranges::count(pixels, std::byte{0x5A});
        const auto share = static_cast<double>(bytes_drawn) / static_cast<double>(pixels.size());
        EXPECT_GT(share, 0.85) << "filter " << filter << ", format " << format << ", work " << work;
      }
    }
  }
}

[[nodiscard]] uint32_t noise(int32_t s, int32_t t) {
  return static_cast<uint32_t>(s * 7919 + t) * 0x9E3779B1u | 1;
}

TEST(WorkPicture, IsTheSameByEveryKernel) {
  for (const selvage_filter filter : kFilters) {
    for (const selvage_work work :
         {SELVAGE_WORK_LARGE, SELVAGE_WORK_MESH, SELVAGE_WORK_PERSPECTIVE}) {
      const auto scalar = drawn(work, SELVAGE_RGBA8888, filter, SELVAGE_KERNEL_SCALAR, noise);
      for (selvage_kernel each = SELVAGE_KERNEL_SSE4; each <= SELVAGE_KERNEL_NEON; ++each) {
        if (!mapper::is_usable(each)) continue;
        EXPECT_EQ(drawn(work, SELVAGE_RGBA8888, filter, each, noise), scalar)
            << "kernel " << each << ", filter " << filter << ", work " << work;
      }
    }
  }
}

// Texels on the texture's rim stand for all that is beyond it.
TEST(WorkPicture, LiesWithinItsTexture) {
  for (const selvage_filter filter : kFilters) {
    Memory memory;
    const selvage_texture texture = WorkPicture(filter, SELVAGE_RGBA8888, memory.data()).texture();
    const auto rim = [&](int32_t s, int32_t t) {
      const bool inside = s > 0 && t > 0 && s < texture.width - 1 && t < texture.height - 1;
      return inside ? uint32_t{0} : UINT32_MAX;
    };
    for (const selvage_work work :
         {SELVAGE_WORK_LARGE, SELVAGE_WORK_MESH, SELVAGE_WORK_PERSPECTIVE}) {
      const auto pixels = drawn(work, SELVAGE_RGBA8888, filter, SELVAGE_KERNEL_SCALAR, rim);
      EXPECT_EQ(std::ranges::count(pixels, std::byte{0}), std::ssize(pixels))
          << "filter " << filter << ", work " << work;
    }
  }
}

// Of 2.3 columns in turn black and white at least one is white, and at most 1.3; of 1.8 rows at
// least 0.8, and at most one.
TEST(WorkPicture, IsMinifiedForTheAreaFilter) {
  const auto columns = [](int32_t s, int32_t) { return s % 2 == 0 ? 0xFF000000 : UINT32_MAX; };
  const auto rows = [](int32_t, int32_t t) { return t % 2 == 0 ? 0xFF000000 : UINT32_MAX; };
  const auto expect_between = [](const Paint& stripes, selvage_work work, int least, int most) {
    const auto pixels =
        drawn(work, SELVAGE_RGBA8888, SELVAGE_FILTER_AREA, SELVAGE_KERNEL_SCALAR, stripes);
    for (size_t i = 0; i < pixels.size(); i += 4) {
      if (pixels[i + 3] == std::byte{0}) continue;
      ASSERT_GE(std::to_integer<int>(pixels[i]), least) << "pixel " << i / 4;
      ASSERT_LE(std::to_integer<int>(pixels[i]), most) << "pixel " << i / 4;
    }
  };
  for (const selvage_work work : {SELVAGE_WORK_LARGE, SELVAGE_WORK_MESH}) {
    expect_between(columns, work, 110, 145);
    expect_between(rows, work, 112, 143);
  }
}

}  // namespace
}  // namespace selvage::measure
