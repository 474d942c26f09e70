// Boxes out of sums, by every kernel that this machine can run, up to the largest that vectors
// take.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <initializer_list>
#include <memory>
#include <vector>

#include "mapper/filter_box.h"
#include "mapper/sums.h"
#include "tests/box_support.h"
#include "tests/kernel_support.h"

namespace selvage::mapper {
namespace {

constexpr int32_t kMostSide_texel = 1 << 12;  // that vectors take
constexpr int32_t kMiddle_texel = kMostSide_texel / 2 + 2, kSize_texel = 2 * kMiddle_texel;

// A texture of four quarters, of which only sums are there (boxes of more than 128 texels are
// looked up by every kernel), and of these only what is asked for: all of them would take a quarter
// of a gigabyte.
class Quarters {
 public:
  // `same` in the first and the last quarter, `other` in the other two.
  Quarters(uint32_t same, uint32_t other) : same_(same), other_(other) {
    texture_ = {nullptr,          kSize_texel,         kSize_texel, ptrdiff_t{4} * kSize_texel,
                SELVAGE_RGBA8888, SELVAGE_LAYOUT_ROWS, nullptr};
    const SumsShape shape = SumsShape::of(texture_);
    pitch_bytes_ = shape.pitch_bytes;
    memory_ =
        std::make_unique_for_overwrite<std::byte[]>(static_cast<size_t>(pitch_bytes_ * shape.rows));
    texture_.prepared = memory_.get();
  }
  [[nodiscard]] const selvage_texture& texture() const { return texture_; }

  // Writes what a box is looked up by.
  void provide(const Box& box) {
    for (const int32_t t : entries(box.top_fx8, box.height_fx8)) {
      for (const int32_t s : entries(box.left_fx8, box.width_fx8)) {
        const ChannelSums sums = at(s, t);
        std::memcpy(memory_.get() + t * pitch_bytes_ + s * ptrdiff_t{sizeof sums}, &sums,
                    sizeof sums);
      }
    }
  }

 private:
  [[nodiscard]] static std::vector<int32_t> entries(int32_t begin_fx8, int32_t side_fx8) {
    const int32_t first = begin_fx8 >> 8, end = (begin_fx8 + side_fx8) >> 8;
    const int32_t last = (begin_fx8 + side_fx8 - 1) >> 8;
    return {first, first + 1, last, last + 1, end, std::min(end + 1, kSize_texel)};
  }
  [[nodiscard]] ChannelSums at(int64_t s, int64_t t) const {
    constexpr int64_t kMiddle = kMiddle_texel;
    const int64_t alike = std::min(s, kMiddle) * std::min(t, kMiddle) +
                          std::max<int64_t>(s - kMiddle, 0) * std::max<int64_t>(t - kMiddle, 0);
    ChannelSums sums;
    for (size_t k = 0; k < sums.size(); ++k) {
      const int64_t same = same_ >> (8 * k) & 0xFF, other = other_ >> (8 * k) & 0xFF;
      sums[k] = static_cast<uint32_t>(alike * same + (s * t - alike) * other);
    }
    return sums;
  }

  uint32_t same_, other_;
  std::unique_ptr<std::byte[]> memory_;
  int64_t pitch_bytes_;
  selvage_texture texture_;
};

void expect_mean(Quarters* quarters, const BoxLine& line, uint32_t mean) {
  quarters->provide(box_of(line, 0));
  for (const selvage_kernel kernel : usable_kernels()) {
    ASSERT_EQ(drawn_boxes(line, 1, quarters->texture(), SELVAGE_ADDRESS_CLAMP, kernel)[0], mean)
        << "kernel " << kernel << ", box " << line.sides.u_fx8 << " x " << line.sides.v_fx8;
  }
}

// The point around which a side begins there.
[[nodiscard]] int32_t point_of(int32_t begin_fx8, int32_t side_fx8) {
  return begin_fx8 + ((side_fx8 - kTexel_fx8) >> 1);
}

// The largest sums.
TEST(BoxSums, OfWhiteAreWhite) {
  Quarters white(0xFFFFFFFF, 0xFFFFFFFF);
  constexpr int32_t kMost_fx8 = kMostSide_texel * kTexel_fx8;
  for (const int32_t width : {kMost_fx8, kMost_fx8 - 1, kMost_fx8 + 1, 8192, 3000}) {
    for (const int32_t height : {kMost_fx8, kMost_fx8 - 1, kMost_fx8 + 1, 8192, 3000}) {
      for (const int32_t begin : {0, 1, 255, 256, 512}) {
        expect_mean(&white,
                    {{point_of(begin, width), point_of(begin, height)}, {}, {width, height}},
                    0xFFFFFFFF);
        ASSERT_FALSE(HasFatalFailure()) << begin;
      }
    }
  }
}

// As far as the texture reaches, where no entry is next to the last.
TEST(BoxSums, AreThoseUpToTheLastTexel) {
  Quarters quarters(0x10203040, 0x10203040);
  for (const int32_t side : {3000, 4097, kMostSide_texel * kTexel_fx8}) {
    const int32_t end = point_of(kSize_texel * kTexel_fx8 - side, side);
    expect_mean(&quarters, {{end, end}, {}, {side, side}}, 0x10203040);
    ASSERT_FALSE(HasFatalFailure()) << side;
  }
}

// Along a row, where those of the pixels to come are asked for ahead.
TEST(BoxSums, AreThoseOfARow) {
  constexpr int32_t kCount = 40;
  constexpr uint32_t kColour = 0x10F0207F;
  Quarters quarters(kColour, kColour);
  const BoxLine line{{40000, 40000}, {700, -300}, {8191, 8193}};
  for (int32_t i = 0; i < kCount; ++i) quarters.provide(box_of(line, i));
  for (const selvage_address address : {SELVAGE_ADDRESS_CLAMP, SELVAGE_ADDRESS_WRAP}) {
    for (const selvage_kernel kernel : usable_kernels()) {
      EXPECT_EQ(drawn_boxes(line, kCount, quarters.texture(), address, kernel),
                std::vector<uint32_t>(kCount, kColour))
          << "kernel " << kernel;
    }
  }
}

// About the corner of the quarters a box has a mean of 254.5, or less by as little as can be: by
// 1 / (2 area).
TEST(BoxSums, RoundHalvesUpAndWhatIsBarelyBelowDown) {
  constexpr uint32_t kLower = 0x01FEFE00, kUpper = 0x02FFFF01;
  Quarters quarters(kLower, kUpper);
  constexpr int32_t kMiddle_fx8 = kMiddle_texel * kTexel_fx8;
  for (int32_t side = 2900; side <= kMostSide_texel * kTexel_fx8; side += side / 50 | 1) {
    const int32_t point = point_of(kMiddle_fx8 - (side + 1) / 2, side);
    expect_mean(&quarters, {{point, point}, {}, {side, side}}, side % 2 == 0 ? kUpper : kLower);
    ASSERT_FALSE(HasFatalFailure()) << side;
  }
}

// Sums that are none, for they are memory of the caller.
TEST(BoxSums, WhatTheyAreWhateverTheMemoryHolds) {
  spec::Random random(11);
  Quarters none(0, 0);
  const BoxLine line{{40000, 40000}, {}, {8191, 8193}};
  none.provide(box_of(line, 0));
  auto* const sums = static_cast<unsigned char*>(const_cast<void*>(none.texture().prepared));
  const int64_t pitch_bytes = SumsShape::of(none.texture()).pitch_bytes;
  for (int i = 0; i < 1000; ++i) {
    for (const int64_t t : {140, 141, 172, 173}) {
      for (int64_t byte = 140 * 16; byte < 180 * 16; ++byte) {
        sums[t * pitch_bytes + byte] = static_cast<unsigned char>(random.in(0, 256));
      }
    }
    for (const selvage_kernel kernel : usable_kernels()) {
      (void)drawn_boxes(line, 1, none.texture(), SELVAGE_ADDRESS_CLAMP, kernel);
    }
  }
}

}  // namespace
}  // namespace selvage::mapper
