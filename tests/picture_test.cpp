#include "spec/picture.h"

#include <gtest/gtest.h>

#include <cstring>
#include <functional>

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
  EXPECT_EQ(describe_texel(*picture.at(2, 3)), "texel (1, 2)");
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
    EXPECT_EQ(*picture.at(0, 0), coordinate_texel(value & 15, value >> 4));
    EXPECT_FALSE(picture.at(1, 0));
  }
}

// Draws one pixel, of the texel at (u, v) of the first vertex.
[[nodiscard]] Subject painter_of(std::function<bool(uint8_t value)> wants) {
  return {"painter",
          [wants](const selvage_image* target, const selvage_rect*, const selvage_vertex* v, size_t,
                  const selvage_texture* texture, auto...) {
            const uint8_t texel = static_cast<const uint8_t*>(
                texture->texels)[(v->v >> 16) * texture->pitch + (v->u >> 16)];
            if (wants(texel)) std::memcpy(target->pixels, &texel, 1);
            return SELVAGE_OK;
          }};
}

[[nodiscard]] Case large_index8(int32_t s, int32_t t) {
  Case c = square();
  c.format = SELVAGE_INDEX8;
  c.texture_width_texel = 300;
  c.texture_height_texel = 40;
  c.vertices[0].u = s * SELVAGE_SUBTEXELS;
  c.vertices[0].v = t * SELVAGE_SUBTEXELS;
  return c;
}

TEST(Picture, TellsPlacesThatTheFormatHasNoValueFor) {
  const Subject painter = painter_of([](uint8_t) { return true; });
  for (const int32_t s : {0, 15, 16, 32, 255, 256, 299}) {
    for (const int32_t t : {0, 1, 16, 39}) {
      const Picture picture = draw(painter, large_index8(s, t));
      EXPECT_EQ(picture.at(0, 0), coordinate_texel(s, t)) << s << ", " << t;
      EXPECT_FALSE(picture.at(1, 0));
      EXPECT_EQ(picture.memory_fault, "");
    }
  }
}

TEST(Picture, SeesAPixelThatIsDrawnForSomeTexelsAlone) {
  const Subject keyed = painter_of([](uint8_t value) { return value != 0; });
  EXPECT_EQ(draw(keyed, large_index8(273, 17)).memory_fault, "");
  for (const int32_t s : {5, 16}) {
    const Picture picture = draw(keyed, large_index8(s, 0));
    EXPECT_EQ(picture.memory_fault, "whether a pixel is drawn depends on the texels") << s;
  }
}

TEST(FoldedTexture, TellsTexelsApartThatOneBitTells) {
  for (const selvage_format format : {SELVAGE_INDEX8, SELVAGE_RGB565, SELVAGE_RGBA8888}) {
    const TexelAt texture = folded_texture(format);
    for (int32_t bit = 1; bit < 65536; bit *= 2) {
      for (const int32_t s : {0, 7, 15, 255, 300, 1021, 40000}) {
        if ((s & bit) != 0) continue;
        EXPECT_NE(texture({s, 9}), texture({s + bit, 9})) << format << ' ' << s << ' ' << bit;
        EXPECT_NE(texture({9, s}), texture({9, s + bit})) << format << ' ' << s << ' ' << bit;
      }
    }
  }
}

TEST(FoldedTexture, TellsPlacesInSmallTextures) {
  Case c;
  c.format = SELVAGE_INDEX8;
  c.texture_width_texel = 16;
  c.texture_height_texel = 9;
  const TexelAt texture = folded_texture(c.format);
  const std::optional<Texel> texel = texel_of_folded(c, texture({11, 8}));
  ASSERT_TRUE(texel);
  EXPECT_EQ(texel->s, 11);
  EXPECT_EQ(texel->t, 8);
  EXPECT_FALSE(texel_of_folded(c, texture({11, 9})));
  c.texture_width_texel = 17;
  EXPECT_FALSE(texel_of_folded(c, texture({11, 8})));
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
