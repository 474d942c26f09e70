// The codec and the printer of cases.
#include "spec/case.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "case_support.h"
#include "spec/random.h"

namespace selvage::spec {
namespace {

constexpr size_t kHeaderBytes = 22;
constexpr size_t kVertexBytes = 17;

// Every field at a value of its own, none at its default.
[[nodiscard]] Case distinct() {
  Case c;
  c.format = SELVAGE_RGB565;
  c.filter = SELVAGE_FILTER_BILINEAR;
  c.address = SELVAGE_ADDRESS_WRAP;
  c.target_width_px = 3;
  c.target_height_px = 260;
  c.texture_width_texel = 17;
  c.texture_height_texel = 5;
  c.padding_px = 11;
  c.layout = Layout::kPadded;
  c.flip_texture = true;
  c.has_clip = true;
  c.clip = {-1, 2, 300, -32768};
  c.choice = 0x89abcdef;
  c.vertices = {{-1, 256, 65536, -65536, 1}, {384, -2, 3, 4, 70000}};
  return c;
}

TEST(CaseEquality, SeesEveryField) {
  const Case c = distinct();
  EXPECT_TRUE(c == distinct());
  const std::vector<void (*)(Case&)> changes = {[](Case& d) { d.format = SELVAGE_INDEX8; },
                                                [](Case& d) { d.filter = SELVAGE_FILTER_FOUR; },
                                                [](Case& d) { d.address = SELVAGE_ADDRESS_CLAMP; },
                                                [](Case& d) { ++d.target_width_px; },
                                                [](Case& d) { ++d.target_height_px; },
                                                [](Case& d) { ++d.texture_width_texel; },
                                                [](Case& d) { ++d.texture_height_texel; },
                                                [](Case& d) { ++d.padding_px; },
                                                [](Case& d) { d.layout = Layout::kTiled; },
                                                [](Case& d) { d.flip_target = !d.flip_target; },
                                                [](Case& d) { d.flip_texture = !d.flip_texture; },
                                                [](Case& d) { d.has_clip = !d.has_clip; },
                                                [](Case& d) { ++d.clip.left; },
                                                [](Case& d) { ++d.clip.top; },
                                                [](Case& d) { ++d.clip.right; },
                                                [](Case& d) { ++d.clip.bottom; },
                                                [](Case& d) { ++d.choice; },
                                                [](Case& d) { ++d.vertices[1].x; },
                                                [](Case& d) { ++d.vertices[1].y; },
                                                [](Case& d) { ++d.vertices[1].u; },
                                                [](Case& d) { ++d.vertices[1].v; },
                                                [](Case& d) { ++d.vertices[1].q; },
                                                [](Case& d) { d.vertices.pop_back(); }};
  for (size_t i = 0; i < changes.size(); ++i) {
    Case changed = c;
    changes[i](changed);
    EXPECT_FALSE(changed == c) << "change " << i;
    EXPECT_TRUE(decode(encode(changed)) == changed) << "change " << i;
    EXPECT_NE(encode(changed), encode(c)) << "change " << i;
  }
}

TEST(CaseCodec, HasTheLayoutThatTheHeaderStates) {
  const std::vector<uint8_t> wanted = {2,
                                       0,
                                       3,
                                       1,
                                       16,
                                       0,
                                       4,
                                       0,  // sizes less one
                                       1 + 4 + 16 + 32,
                                       11 + 32 + 64,  // flags; padding, filter and layout
                                       0xff,
                                       0xff,
                                       2,
                                       0,
                                       0x2c,
                                       1,
                                       0,
                                       0x80,  // clip
                                       0xef,
                                       0xcd,
                                       0xab,
                                       0x89,  // choice
                                       0xff,
                                       0xff,
                                       0xff,
                                       0,
                                       1,
                                       0,  // x, y
                                       0,
                                       0,
                                       1,
                                       0,
                                       0,
                                       0,
                                       0xff,
                                       0xff,
                                       0,
                                       0,
                                       0,  // u, v, q - 1
                                       0x80,
                                       1,
                                       0,
                                       0xfe,
                                       0xff,
                                       0xff,  // x, y
                                       3,
                                       0,
                                       0,
                                       0,
                                       4,
                                       0,
                                       0,
                                       0,
                                       0x6f,
                                       0x11,
                                       1};  // u, v, q - 1
  EXPECT_EQ(encode(distinct()), wanted);
}

TEST(CaseCodec, KeepsTheEndsOfEveryRange) {
  constexpr int32_t kLeast = std::numeric_limits<int32_t>::min();
  constexpr int32_t kGreatest = std::numeric_limits<int32_t>::max();
  Case c;
  for (const auto& [width, height] : {std::pair(1, 1), std::pair(65536, 1), std::pair(1, 65536),
                                      std::pair(256, 256), std::pair(3, 21845)}) {
    c.target_width_px = c.texture_height_texel = width;
    c.target_height_px = c.texture_width_texel = height;
    for (const selvage_format format : {SELVAGE_INDEX8, SELVAGE_RGB565, SELVAGE_RGBA8888}) {
      c.format = format;
      c.filter = format + 1;
      c.layout = static_cast<Layout>(format);
      for (const int32_t end : {0, 1}) {
        c.padding_px = end * 15;
        c.choice = end == 0 ? 0 : std::numeric_limits<uint32_t>::max();
        c.clip = end == 0 ? selvage_rect{-32768, 32767, -32768, 32767}
                          : selvage_rect{32767, -32768, 32767, -32768};
        c.vertices = {{SELVAGE_X_MIN, SELVAGE_X_END - 1, kLeast, kGreatest, 1},
                      {SELVAGE_X_END - 1, SELVAGE_X_MIN, kGreatest, kLeast, SELVAGE_Q_MAX},
                      {0, -1, -1, 0, 2}};
        ASSERT_EQ(out_of_range(c), "");
        EXPECT_TRUE(decode(encode(c)) == c) << print(c);
        EXPECT_TRUE(from_hex(to_hex(c)) == c) << print(c);
      }
    }
  }
}

TEST(CaseCodec, DecodesNothingToTheLeastCase) {
  const Case c = decode({});
  EXPECT_EQ(out_of_range(c), "");
  EXPECT_EQ(c.target_width_px, 1);
  EXPECT_EQ(c.texture_height_texel, 1);
  EXPECT_EQ(c.format, SELVAGE_INDEX8);
  EXPECT_FALSE(c.has_clip);
  EXPECT_TRUE(c.vertices.empty());
}

TEST(CaseCodec, LowersTheHeightOfWhatIsTooLarge) {
  const Case all = decode(std::vector<uint8_t>(kHeaderBytes, 0xff));
  EXPECT_EQ(all.target_width_px, 65536);
  EXPECT_EQ(all.target_height_px, 1);
  const Case some = decode(std::vector<uint8_t>{0, 0, 255, 255, 255, 2, 255, 0});
  EXPECT_EQ(some.target_height_px, 65536);
  EXPECT_EQ(some.texture_width_texel, 768);
  EXPECT_EQ(some.texture_height_texel, 85);  // 65536 / 768 is 85 and a third
}

// The fourth value that two bits have means the first again.
TEST(CaseCodec, ReadsEveryLayout) {
  const std::vector<uint8_t> sizes(9, 0);
  for (const int bits : {0, 1, 2, 3}) {
    std::vector<uint8_t> bytes = sizes;
    bytes.push_back(static_cast<uint8_t>(bits << 6));
    EXPECT_EQ(static_cast<int>(decode(bytes).layout), bits % 3);
  }
}

TEST(CaseCodec, IgnoresWhatIsShortOfAVertexAndVerticesBeyondTheMost) {
  std::vector<uint8_t> bytes(kHeaderBytes + kVertexBytes - 1, 1);
  EXPECT_EQ(decode(bytes).vertices.size(), 0U);
  bytes.push_back(1);
  EXPECT_EQ(decode(bytes).vertices.size(), 1U);
  bytes.resize(kHeaderBytes + kVertexBytes * (kMaxVertices + 3), 1);
  EXPECT_EQ(decode(bytes).vertices.size(), kMaxVertices);
}

TEST(CaseCodec, MakesACaseOfAnyBytes) {
  Random random(1);
  for (int i = 0; i < 20000; ++i) {
    std::vector<uint8_t> bytes(random.below(120));
    for (uint8_t& byte : bytes)
      byte = static_cast<uint8_t>(random.pick({0, 255, random.in(0, 256)}));
    const Case c = decode(bytes);
    ASSERT_EQ(out_of_range(c), "") << print(c);
    ASSERT_EQ(c.vertices.size(),
              bytes.size() < kHeaderBytes ? 0 : (bytes.size() - kHeaderBytes) / kVertexBytes);
    ASSERT_TRUE(decode(encode(c)) == c) << print(c);
  }
}

TEST(CaseHex, ReadsWhatItWrites) {
  const std::string hex = to_hex(distinct());
  EXPECT_EQ(hex.substr(0, 20),
            "020003011000"
            "0400"
            "356b");
  EXPECT_EQ(hex.size(), 2 * (kHeaderBytes + 2 * kVertexBytes));
  EXPECT_TRUE(from_hex(hex) == distinct());
  std::string upper = hex;
  for (char& digit : upper) digit = static_cast<char>(std::toupper(digit));
  EXPECT_TRUE(from_hex(upper) == distinct());
  EXPECT_TRUE(from_hex("") == decode({}));
}

TEST(CaseHex, RefusesWhatIsNoHexadecimal) {
  for (const char* text :
       {"0", "000", "0g", "g0", " 0", "0 ", "0x", "-1", "00\n", "/0", ":0", "@0"}) {
    EXPECT_FALSE(from_hex(text).has_value()) << text;
  }
}

TEST(CasePrint, TellsEverythingExactly) {
  EXPECT_EQ(print(distinct()),
            "exact, RGB565, bilinear, wrap, choice 2309737967\n"
            "target   3 x 260 px, padding 11 px a row\n"
            "texture  17 x 5 texels, padding 11 px a row, bottom row first (negative pitch), "
            "prepared in rows\n"
            "clip     columns [-1, 300), rows [2, -32768)\n"
            "2 vertices: (x, y) px, (u, v) texels, q\n"
            "  (-0.00390625, 1), (1, -1), 1\n"
            "  (1.5, -0.0078125), (0.0000457763671875, 0.00006103515625), 70000\n");
}

TEST(CasePrint, TellsThePlainCasePlainly) {
  Case c;
  c.flip_target = true;
  c.vertices = {{SELVAGE_X_MIN, SELVAGE_X_END - 1, std::numeric_limits<int32_t>::min(),
                 std::numeric_limits<int32_t>::max(), 1}};
  EXPECT_EQ(print(c),
            "exact, RGBA8888, clamp, choice 0\n"
            "target   16 x 16 px, bottom row first (negative pitch)\n"
            "texture  16 x 16 texels\n"
            "1 vertex: (x, y) px, (u, v) texels, q\n"
            "  (-32768, 32767.99609375), (-32768, 32767.9999847412109375), 1\n");
  c.format = SELVAGE_INDEX8;
  EXPECT_EQ(print(c).substr(0, 13), "exact, INDEX8");
  c.layout = Layout::kTiled;
  EXPECT_NE(print(c).find("16 x 16 texels, prepared in tiles\n"), std::string::npos);
  c.profile = SELVAGE_PROFILE_DKIT;
  EXPECT_EQ(print(c).substr(0, 12), "dkit, INDEX8");
  c.filter = SELVAGE_FILTER_FOUR;
  EXPECT_EQ(print(c).substr(0, 19), "dkit, INDEX8, four,");
  c.filter = SELVAGE_FILTER_AREA;
  EXPECT_EQ(print(c).substr(0, 19), "dkit, INDEX8, area,");
}

}  // namespace
}  // namespace selvage::spec
