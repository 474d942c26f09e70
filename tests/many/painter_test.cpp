// The kernels of many polygons are found once a texture.
#include <gtest/gtest.h>
#include <sys/mman.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "tests/kernel_support.h"

namespace selvage::many {
namespace {

using mapper::usable_kernels;

// The last of three rows is 2^31 texels away, or as far as addresses reach.
constexpr ptrdiff_t kFar_bytes = std::min(ptrdiff_t{1} << 30, PTRDIFF_MAX / 4 + 1);

[[nodiscard]] selvage_texture three_rows(const void* texels, ptrdiff_t pitch) {
  return {texels, 3, 3, pitch, SELVAGE_INDEX8, SELVAGE_LAYOUT_ROWS, nullptr};
}

// Pages that are there when they are touched.
class Memory2GB {
 public:
  Memory2GB()
      : begin_(mmap(nullptr, kBytes, PROT_READ | PROT_WRITE,
                    MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0)) {}
  ~Memory2GB() {
    if (begin_ != MAP_FAILED) munmap(begin_, kBytes);
  }
  Memory2GB(const Memory2GB&) = delete;
  Memory2GB& operator=(const Memory2GB&) = delete;

  [[nodiscard]] uint8_t* begin() const {
    return begin_ == MAP_FAILED ? nullptr : static_cast<uint8_t*>(begin_);
  }

 private:
  static constexpr size_t kBytes = 2 * size_t{kFar_bytes} + 4096;
  void* begin_;
};

// A texture that vectors can address, one that they cannot, and the first one again.
TEST(Painter, ChangesKernelsWithTheTexture) {
  const Memory2GB memory;
  ASSERT_NE(memory.begin(), nullptr);
  const uint8_t near_texels[] = {1, 2, 3, 4, 5, 6, 7, 8, 9};
  for (ptrdiff_t row = 0; row < 3; ++row) std::memset(memory.begin() + row * kFar_bytes, 10, 3);
  const selvage_texture near = three_rows(near_texels, 3),
                        far = three_rows(memory.begin(), kFar_bytes);
  constexpr int32_t kSide = 40 * SELVAGE_SUBPIXELS, kTexels = 3 * SELVAGE_SUBTEXELS;
  const selvage_vertex left[] = {
      {0, 0, 0, 0, 1}, {kSide, 0, kTexels, 0, 1}, {0, kSide, 0, kTexels, 1}};
  const selvage_vertex right[] = {
      {kSide, 0, 0, 0, 1}, {kSide, kSide, kTexels, kTexels, 1}, {0, kSide, 0, kTexels, 1}};
  const selvage_polygon polygons[] = {{left, 3, &near}, {right, 3, &far}, {left, 3, &near}};
  for (const selvage_kernel kernel : usable_kernels()) {
    const selvage_options options{SELVAGE_PROFILE_EXACT, SELVAGE_FILTER_NEAREST,
                                  SELVAGE_ADDRESS_CLAMP, 0, kernel};
    std::vector<uint8_t> one(40 * 40), many(40 * 40);
    const selvage_image one_image{one.data(), 40, 40, 40, SELVAGE_INDEX8},
        many_image{many.data(), 40, 40, 40, SELVAGE_INDEX8};
    for (const auto& [vertices, count, texture] : polygons) {
      ASSERT_EQ(selvage_draw(&one_image, nullptr, vertices, count, texture, &options), SELVAGE_OK);
    }
    std::vector<std::max_align_t> scratch(selvage_draw_many_bytes(3) / sizeof(std::max_align_t) +
                                          1);
    ASSERT_EQ(selvage_draw_many(&many_image, nullptr, polygons, 3, &options, 1, scratch.data(),
                                scratch.size() * sizeof(std::max_align_t), nullptr),
              SELVAGE_OK);
    EXPECT_EQ(many, one) << "kernel " << kernel;
  }
}

}  // namespace
}  // namespace selvage::many
