#include "spec/picture.h"

#include <gtest/gtest.h>

#include <cstring>

namespace selvage::spec {
namespace {

[[nodiscard]] Case square() {
  Case c;
  c.vertices = {{256, 256, 0, 0, 1},
                {1024, 256, 3 * 65536, 0, 1},
                {1024, 1024, 3 * 65536, 3 * 65536, 1},
                {256, 1024, 0, 3 * 65536, 1}};
  return c;
}

TEST(Picture, ShowsWhatWasDrawnAndWhatWasNot) {
  const Picture picture = draw(built_in(), square());
  EXPECT_EQ(picture.status, SELVAGE_OK);
  EXPECT_EQ(picture.memory_fault, "");
  EXPECT_FALSE(picture.at(0, 0));
  ASSERT_TRUE(picture.at(2, 3));
  EXPECT_EQ(describe_texel(SELVAGE_RGBA8888, *picture.at(2, 3)), "texel (1, 2)");
  EXPECT_EQ(picture.pixels, expected(square()).pixels);
}

// A drawn pixel may have the value of a background.
TEST(Picture, TellsATexelFromABackgroundOfItsValue) {
  for (const int value : {0x5A, 0xA5}) {
    const Subject painter{"painter", [value](const selvage_image* target, auto...) {
                            std::memset(target->pixels, value, 1);
                            return SELVAGE_OK;
                          }};
    Case c;
    c.format = SELVAGE_INDEX8;
    const Picture picture = draw(painter, c);
    ASSERT_TRUE(picture.at(0, 0));
    EXPECT_EQ(*picture.at(0, 0), static_cast<uint32_t>(value));
    EXPECT_FALSE(picture.at(1, 0));
  }
}

TEST(Picture, SeesForbiddenWrites) {
  const auto fault_of = [](auto draw_call) {
    return draw(Subject{"vandal", draw_call}, square()).memory_fault;
  };
  EXPECT_NE(fault_of([](const selvage_image* target, auto...) {
              static_cast<char*>(target->pixels)[-1] = 1;
              return SELVAGE_OK;
            }),
            "");
  EXPECT_NE(fault_of([](const selvage_image* target, auto...) {
              static_cast<char*>(target->pixels)[0] ^= 1;  // a blend with the background
              return SELVAGE_OK;
            }),
            "");
  EXPECT_NE(
      fault_of([](const selvage_image*, const selvage_rect*, const selvage_vertex* v, auto...) {
        const_cast<selvage_vertex*>(v)->q = 9;
        return SELVAGE_OK;
      }),
      "");
  EXPECT_NE(fault_of([](const selvage_image*, const selvage_rect*, const selvage_vertex*, size_t,
                        const selvage_texture* texture, auto...) {
              std::memset(const_cast<void*>(texture->texels), 3, 1);
              return SELVAGE_OK;
            }),
            "");
}

}  // namespace
}  // namespace selvage::spec
