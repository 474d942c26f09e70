// What a violation tells whoever has to find the fault: where the sample point lies, coordinates
// that can be read, and texels that are none.
#include <gtest/gtest.h>

#include <string>

#include "spec/coordinate_texture.h"
#include "spec/law_tools.h"
#include "spec/laws.h"
#include "spec/sample_place.h"
#include "spec/texel_reach.h"

namespace selvage::spec {
namespace {

// From (0.5, 0.5) px to (2.5, 2.5) px: samples on each of its edges.
[[nodiscard]] Case square_through_samples() {
  Case c;
  c.target_width_px = c.target_height_px = 4;
  c.vertices = {{128, 128, 0, 0, 1}, {640, 128, 0, 0, 1}, {640, 640, 0, 0, 1}, {128, 640, 0, 0, 1}};
  return c;
}

TEST(DescribeSample, TellsTheEdgeAndWhoseItIs) {
  const std::string rule = " (left and top edges are in it, others are not)";
  EXPECT_EQ(describe_sample(square_through_samples(), 1, 0),
            "(1.5, 0.5) px, in the polygon: on the edge from (0.5, 0.5) to (2.5, 0.5)" + rule);
  EXPECT_EQ(describe_sample(square_through_samples(), 0, 1),
            "(0.5, 1.5) px, in the polygon: on the edge from (0.5, 2.5) to (0.5, 0.5)" + rule);
  EXPECT_EQ(describe_sample(square_through_samples(), 1, 2),
            "(1.5, 2.5) px, not in the polygon: on the edge from (2.5, 2.5) to (0.5, 2.5)" + rule);
  EXPECT_EQ(describe_sample(square_through_samples(), 2, 1),
            "(2.5, 1.5) px, not in the polygon: on the edge from (2.5, 0.5) to (2.5, 2.5)" + rule);
  EXPECT_EQ(describe_sample(square_through_samples(), 0, 0),
            "(0.5, 0.5) px, in the polygon: on the vertex (0.5, 0.5)" + rule);
  EXPECT_EQ(describe_sample(square_through_samples(), 1, 1), "(1.5, 1.5) px, in the polygon");
  EXPECT_EQ(describe_sample(square_through_samples(), 3, 3), "(3.5, 3.5) px, not in the polygon");
}

TEST(DescribeSample, TellsAnEdgeThatIsVeryNear) {
  Case c = square_through_samples();
  c.vertices = {{0, 0, 0, 0, 1}, {1001, 1000, 0, 0, 1}, {0, 1000, 0, 0, 1}};
  EXPECT_EQ(describe_sample(c, 1, 1),
            "(1.5, 1.5) px, in the polygon: 0.0015 px beside the edge from (0, 0) to "
            "(3.91015625, 3.90625)");
  c.vertices[1].x = 999;
  EXPECT_EQ(describe_sample(c, 1, 1),
            "(1.5, 1.5) px, not in the polygon: 0.0015 px beside the edge from (0, 0) to "
            "(3.90234375, 3.90625)");
}

TEST(DescribeSample, TellsTheClipAndNoRuleOfAnotherProfile) {
  Case c = square_through_samples();
  c.has_clip = true;
  c.clip = {0, 0, 1, 4};
  EXPECT_EQ(describe_sample(c, 1, 1), "(1.5, 1.5) px, in the polygon; outside of the clip");
  EXPECT_EQ(describe_sample(c, 0, 1).find("clip"), std::string::npos);
  c = square_through_samples();
  c.profile = SELVAGE_PROFILE_DKIT;
  for (selvage_vertex& v : c.vertices) v.x += 128, v.y += 128;
  EXPECT_EQ(describe_sample(c, 1, 3).find("(left and top"), std::string::npos);
}

[[nodiscard]] std::string told(const std::string& u) {
  return explain(
      {.law = "MAP", .x_px = 1, .y_px = 1, .u = u, .v = "1/3", .shown = square_through_samples()});
}

TEST(Explain, TellsLongFractionsInDecimalsAndOnWhichSideOfAWholeNumber) {
  EXPECT_NE(told("22016307/43874816").find("22016307/43874816, about 0.501798\n"),
            std::string::npos);
  EXPECT_NE(told("129999999997/10000000000").find(", about 13 - 3e-10\n"), std::string::npos);
  EXPECT_NE(told("-10000000001/10000000000").find(", about -1 - 1e-10\n"), std::string::npos);
  EXPECT_NE(told("20001/20000").find(", about 1 + 5e-05\n"), std::string::npos);
  for (const char* as_it_is : {"3/2", "1/0", "", "<u>", "1/-300", "300000000000000001/100"}) {
    EXPECT_EQ(told(as_it_is).find("about"), std::string::npos) << as_it_is;
  }
}

// u = x and v = y, of 4 x 4 texels.
[[nodiscard]] Case copy_of_texels() {
  constexpr int32_t kFour_px = 4 * SELVAGE_SUBPIXELS, kFour_texels = 4 * SELVAGE_SUBTEXELS;
  Case c;
  c.target_width_px = c.target_height_px = 4;
  c.texture_width_texel = c.texture_height_texel = 4;
  c.vertices = {{0, 0, 0, 0, 1},
                {kFour_px, 0, kFour_texels, 0, 1},
                {kFour_px, kFour_px, kFour_texels, kFour_texels, 1},
                {0, kFour_px, 0, kFour_texels, 1}};
  return c;
}

TEST(Explain, TellsHowFarOffATexelIs) {
  const auto off_by = [](const Case& c, int32_t s, int32_t t) {
    const Violation violation =
        violation_at("MAP", "it is", c, 1, 2, "that one", coordinate_texel(s, t));
    const std::string text = explain(violation);
    const size_t at = text.find("  off by   ");
    return at == std::string::npos ? "" : text.substr(at + 11, text.find('\n', at) - at - 11);
  };
  const Case c = copy_of_texels();  // (1.5, 2.5) texels at pixel (1, 2)
  EXPECT_EQ(off_by(c, 1, 2), "");
  EXPECT_EQ(off_by(c, 2, 2), "0.5 texel in u, 0 in v");
  EXPECT_EQ(off_by(c, 0, 0), "0.5 texel in u, 1.5 in v");
  EXPECT_EQ(off_by(c, 9, 2), "") << "no texel of the texture";
  Case tied = c;
  for (selvage_vertex& v : tied.vertices) v.u += SELVAGE_SUBTEXELS / 2;  // 2 texels at pixel (1, 2)
  EXPECT_EQ(off_by(tied, 1, 2), "0 texel in u, 0 in v") << "the border is the next one's";
  EXPECT_EQ(off_by(tied, 2, 2), "");
  Case wrapped = c;
  wrapped.address = SELVAGE_ADDRESS_WRAP;
  EXPECT_EQ(off_by(c, 3, 0), "1.5 texel in u, 1.5 in v");
  EXPECT_EQ(off_by(wrapped, 3, 0), "1.5 texel in u, 1.5 in v");
  for (selvage_vertex& v : wrapped.vertices) v.u -= SELVAGE_SUBTEXELS;
  EXPECT_EQ(off_by(wrapped, 3, 2), "0.5 texel in u, 0 in v") << "the copy to the left is nearer";
  Case filtered = c;
  filtered.filter = SELVAGE_FILTER_FOUR;
  EXPECT_EQ(off_by(filtered, 2, 2), "") << "a mean is no texel";
}

// How far its sample point lies from the outline that it is on the wrong side of.
TEST(Explain, TellsHowFarOffAnOutlineIs) {
  const auto off_by = [](const Case& c, int32_t x, int32_t y, bool is_drawn) {
    Violation violation = violation_at("COV", "it is", c, x, y, "that", std::nullopt);
    tell_outline_offset(&violation, is_drawn);
    const std::string text = explain(violation);
    const size_t at = text.find("  off by   ");
    return at == std::string::npos ? "" : text.substr(at + 11, text.find('\n', at) - at - 11);
  };
  Case c = copy_of_texels();  // 4 x 4 px
  EXPECT_EQ(off_by(c, 0, 1, false), "0.5 px, the outline");
  EXPECT_EQ(off_by(c, 0, 1, true), "") << "it is right";
  EXPECT_EQ(off_by(c, 5, 1, true), "1.5 px, the outline");
  c.has_clip = true;
  c.clip = {2, 0, 9, 9};
  EXPECT_EQ(off_by(c, 0, 1, true), "") << "the clip is wrong, and no outline";
}

TEST(TexelRange, IsToldAsItIsAddressed) {
  const auto text = [](int32_t first, int32_t last, selvage_address address) {
    return TexelRange{first, last, 8, address}.text();
  };
  EXPECT_EQ(text(15123, 15124, SELVAGE_ADDRESS_CLAMP), "7");
  EXPECT_EQ(text(-3, 2, SELVAGE_ADDRESS_CLAMP), "0 .. 2");
  EXPECT_EQ(text(16, 17, SELVAGE_ADDRESS_WRAP), "0 .. 1");
  EXPECT_EQ(text(-2, 1, SELVAGE_ADDRESS_WRAP), "6 .. 7 or 0 .. 1");
  EXPECT_EQ(text(-1, 0, SELVAGE_ADDRESS_WRAP), "7 or 0");
  EXPECT_EQ(text(3, 10, SELVAGE_ADDRESS_WRAP), "0 .. 7");
}

TEST(Explain, TellsTexelsThatAreNone) {
  Case c = square_through_samples();
  c.texture_width_texel = 1;
  c.texture_height_texel = 2;
  EXPECT_EQ(describe_pixel(c, 0x00010000u), "texel (0, 1)");
  EXPECT_EQ(describe_pixel(c, 0xEEEEEEEEu),
            "texel (61166, 61166), which the texture does not have");
  EXPECT_EQ(describe_pixel(c, 0x00020000u), "texel (0, 2), which the texture does not have");
}

}  // namespace
}  // namespace selvage::spec
