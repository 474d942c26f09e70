#include "mapper/filter_box.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <memory>
#include <vector>

#include "mapper/filter_blend.h"
#include "mapper/layout.h"
#include "mapper/sums.h"
#include "spec/filter.h"
#include "spec/random.h"

namespace selvage::mapper {
namespace {

// A texture of random colours in rows with padding.
class RandomTexture {
 public:
  RandomTexture(spec::Random& random, int32_t width, int32_t height)
      : width_(width), height_(height) {
    for (int32_t i = 0; i < (width + 1) * height; ++i) {
      texels_.push_back(static_cast<uint32_t>(random.bits()));
    }
  }
  [[nodiscard]] selvage_texture texture() const {
    return {texels_.data(),      width_, height_, 4 * (ptrdiff_t{width_} + 1), SELVAGE_RGBA8888,
            SELVAGE_LAYOUT_ROWS, nullptr};
  }
  [[nodiscard]] uint32_t at(spec::Texel texel) const {
    return texels_[static_cast<size_t>(texel.t * (width_ + 1) + texel.s)];
  }

 private:
  int32_t width_, height_;
  std::vector<uint32_t> texels_;
};

// One side of a box by the specification, whose coordinate is the middle.
[[nodiscard]] spec::Taps side(int32_t begin_fx8, int32_t side_fx8, int32_t size,
                              selvage_address address) {
  const spec::Rational point(begin_fx8 + (side_fx8 - 256) / 2 + 128);
  return spec::addressed(spec::taps(SELVAGE_FILTER_AREA, point / 256, side_fx8), size, address);
}

[[nodiscard]] int32_t any_side(spec::Random& random) {
  const int32_t any = random.in(256, 4000);
  return random.pick({256, 257, 511, 512, any, any, random.in(256, 1 << 17)});
}

TEST(BoxSum, IsTheSpecificationsForEverySizeAndPlace) {
  spec::Random random(1);
  for (int i = 0; i < 4000; ++i) {
    const int32_t width = random.in(1, 9), height = random.in(1, 9);
    const RandomTexture texels(random, width, height);
    const selvage_address address =
        random.percent(50) ? SELVAGE_ADDRESS_CLAMP : SELVAGE_ADDRESS_WRAP;
    Box box{random.in(-5000, 5000), random.in(-5000, 5000), any_side(random), any_side(random)};
    if (random.percent(20)) box.width_fx8 = 256 * width * random.in(1, 4);  // whole periods
    if (random.percent(20)) box.left_fx8 = 256 * random.in(-9, 18);
    const spec::Taps columns = side(box.left_fx8, box.width_fx8, width, address);
    const spec::Taps rows = side(box.top_fx8, box.height_fx8, height, address);
    BoxSum wanted{};
    for (const spec::Tap& row : rows) {
      for (const spec::Tap& column : columns) {
        for (int k = 0; k < 4; ++k) {
          wanted[static_cast<size_t>(k)] += static_cast<uint64_t>(row.weight * column.weight) *
                                            spec::channel(texels.at({column.texel, row.texel}), k);
        }
      }
    }
    ASSERT_EQ(box_sum(texels.texture(), address, box), wanted)
        << box.left_fx8 << " " << box.top_fx8 << " " << box.width_fx8 << " x " << box.height_fx8
        << " of " << width << " x " << height;
    ASSERT_EQ(box_mean(texels.texture(), address, box),
              spec::weighted_mean(columns, rows, [&](spec::Texel t) { return texels.at(t); }));
  }
}

// Sizes about those where looking up begins to pay, and boxes over several periods.
TEST(BoxSum, IsTheSameByVisitingAndByLookingUp) {
  spec::Random random(3);
  for (int i = 0; i < 4000; ++i) {
    const RandomTexture texels(random, random.in(1, 40), random.in(1, 40));
    const selvage_texture plain = texels.texture();
    const selvage_layout layout = random.pick({SELVAGE_LAYOUT_ROWS, SELVAGE_LAYOUT_TILES});
    const size_t bytes = selvage_prepare_bytes(&plain, layout, 1);
    std::vector<std::byte> memory(bytes + SELVAGE_PREPARED_ALIGNMENT);
    void* aligned = memory.data();
    size_t space = memory.size();
    ASSERT_NE(std::align(SELVAGE_PREPARED_ALIGNMENT, bytes, aligned, space), nullptr);
    selvage_texture summed{};
    ASSERT_EQ(selvage_prepare(&plain, layout, 1, aligned, bytes, &summed), SELVAGE_OK);
    selvage_texture tiled = summed;
    tiled.prepared = nullptr;
    const selvage_address address =
        random.percent(50) ? SELVAGE_ADDRESS_CLAMP : SELVAGE_ADDRESS_WRAP;
    for (int k = 0; k < 10; ++k) {
      const Box box{random.in(-9000, 12000), random.in(-9000, 12000), random.in(256, 12000),
                    random.in(256, 12000)};
      const BoxSum wanted = box_sum(plain, address, box);
      ASSERT_EQ(box_sum(summed, address, box), wanted);
      ASSERT_EQ(box_sum(tiled, address, box), wanted);
    }
  }
}

// More texels of 255 than 32 bits can sum: rectangles are cut into strips.
TEST(BoxSum, OfMoreTexelsThan32BitsHold) {
  constexpr int32_t kWidth = 4111, kHeight = 4127;
  static_assert(int64_t{kWidth - 3} * (kHeight - 2) > kMostSummed);
  selvage_texture white{
      nullptr, kWidth, kHeight, padded_pitch(4 * kWidth), SELVAGE_RGBA8888, SELVAGE_LAYOUT_ROWS,
      nullptr};
  const auto texel_bytes = static_cast<size_t>(white.pitch * kHeight);
  std::vector<char> memory(texel_bytes + static_cast<size_t>(SumsShape::of(white).bytes()), -1);
  white.texels = memory.data();
  white.prepared = place_of_sums(white);
  write_sums(white, memory.data() + texel_bytes);
  for (const selvage_address address : {SELVAGE_ADDRESS_CLAMP, SELVAGE_ADDRESS_WRAP}) {
    const Box box{300, 200, 256 * (kWidth - 1), 256 * (kHeight - 1) - 77};
    const uint64_t area = uint64_t{256} * (kWidth - 1) * (uint64_t{256} * (kHeight - 1) - 77);
    for (const uint64_t sum : box_sum(white, address, box)) ASSERT_EQ(sum, 255 * area);
  }
}

TEST(BoxSum, HoldsTheLargestBoxes) {
  const uint32_t white = 0xFFFFFFFF;
  const selvage_texture texture{&white, 1, 1, 4, SELVAGE_RGBA8888, SELVAGE_LAYOUT_ROWS, nullptr};
  for (const selvage_address address : {SELVAGE_ADDRESS_CLAMP, SELVAGE_ADDRESS_WRAP}) {
    for (const int32_t begin : {-(1 << 24), 0, 1 << 23}) {
      const Box box{begin, begin, kMostSide_fx8, kMostSide_fx8};
      const BoxSum sum = box_sum(texture, address, box);
      for (const uint64_t channel : sum) EXPECT_EQ(channel, uint64_t{255} << 48);
      EXPECT_EQ(box_mean(texture, address, box), white);
    }
  }
}

// The quotient is whole then, and an estimate of it may lie just below.
TEST(BoxMean, RoundsHalvesUpWhateverTheArea) {
  const std::vector<uint32_t> texels = {0x00FD0200, 0x01FE0301};  // a column each
  const selvage_texture texture{texels.data(),       2,      1, 8, SELVAGE_RGBA8888,
                                SELVAGE_LAYOUT_ROWS, nullptr};
  for (int32_t half_fx8 = 128; half_fx8 < 1500; ++half_fx8) {
    for (const int32_t height_fx8 : {256, 259, 1001, 65537}) {
      const Box box{256 - half_fx8, 0, 2 * half_fx8, height_fx8};
      ASSERT_EQ(box_mean(texture, SELVAGE_ADDRESS_CLAMP, box), 0x01FE0301U)
          << half_fx8 << " " << height_fx8;
    }
  }
}

// Half a unit of 1 / area below the half: in double the quotient rounds to the next whole number.
TEST(BoxMean, RoundsDownWhatIsBarelyBelowAHalf) {
  const std::vector<uint32_t> texels = {0x01FEFEFE, 0x02FFFFFF, 0x02FFFFFF, 0x01FEFEFE};
  const selvage_texture texture{texels.data(),       2,      2, 8, SELVAGE_RGBA8888,
                                SELVAGE_LAYOUT_ROWS, nullptr};
  // Of both columns 2^15 each, one of them less 1/256 texel; and so of the rows.
  const Box box{0, 0, kMostSide_fx8 - 1, kMostSide_fx8 - 1};
  const BoxSum sum = box_sum(texture, SELVAGE_ADDRESS_WRAP, box);
  const uint64_t side = kMostSide_fx8 - 1, area = side * side;
  ASSERT_EQ(2 * sum[0] + area, 2 * area * 255 - 1);
  EXPECT_EQ(box_mean(texture, SELVAGE_ADDRESS_WRAP, box), 0x01FEFEFEU);
}

TEST(BoxMean, OfTheLeastBoxIsBilinear) {
  spec::Random random(2);
  for (int i = 0; i < 2000; ++i) {
    const RandomTexture texels(random, random.in(1, 6), random.in(1, 6));
    const FilterPoint point{random.in(-3000, 3000), random.in(-3000, 3000)};
    const BoxSides least{kLeastSide_fx8, kLeastSide_fx8};
    for (const selvage_address address : {SELVAGE_ADDRESS_CLAMP, SELVAGE_ADDRESS_WRAP}) {
      uint32_t bilinear = 0;
      blend_bilinear({&point, 1}, texels.texture(), address, reinterpret_cast<char*>(&bilinear));
      ASSERT_EQ(box_mean(texels.texture(), address, Box::around(point, least)), bilinear);
    }
  }
}

}  // namespace
}  // namespace selvage::mapper
