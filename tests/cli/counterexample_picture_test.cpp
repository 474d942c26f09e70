#include "cli/counterexample_picture.h"

#include <algorithm>
#include <string>

#include "comparison_panels.h"
#include "spec/filter_texture.h"
#include "spec/generate.h"
#include "spec/picture.h"
#include "support.h"
#include "wrong_subjects.h"

namespace selvage::cli::test {
namespace {

// A rectangle over columns [1, 7) and rows [2, 6) of an 8 x 8 target, u = x, v = y.
[[nodiscard]] spec::Case rectangle() {
  const auto vertex = [](int32_t x, int32_t y) {
    return selvage_vertex{x * 256, y * 256, x * 65536, y * 65536, 1};
  };
  spec::Case c;
  c.target_width_px = c.target_height_px = 8;
  c.texture_width_texel = c.texture_height_texel = 8;
  c.vertices = {vertex(1, 2), vertex(7, 2), vertex(7, 6), vertex(1, 6)};
  return c;
}

[[nodiscard]] spec::Violation violation_of(const spec::Case& c, int32_t x_px, int32_t y_px) {
  spec::Violation violation;
  violation.law = "MAP";
  violation.x_px = x_px;
  violation.y_px = y_px;
  violation.shown = c;
  return violation;
}

constexpr Colour kRed{255, 0, 0};
constexpr Colour kWhite{255, 255, 255};
constexpr Colour kInk{222, 224, 228};
constexpr Colour kMagenta{255, 0, 255};

[[nodiscard]] bool covered(int32_t x, int32_t y) { return x >= 1 && x < 7 && y >= 2 && y < 6; }

[[nodiscard]] bool is_grey(const Colour& colour) {
  return colour.red == colour.green && colour.green == colour.blue;
}

TEST(CounterexamplePicture, HasThreePanels) {
  const Raster picture = counterexample_picture(spec::built_in(), violation_of(rectangle(), 3, 3));
  EXPECT_EQ(picture.width_px, 3 * kSide_px * kScale_px + 4 * kGap_px);
  EXPECT_EQ(picture.height_px, kCaption_px + kSide_px * kScale_px + 2 * kGap_px);
}

// Of small targets, too, each panel has a caption of its own.
TEST(CounterexamplePicture, HasCaptions) {
  for (const auto& [width_px, height_px] : {std::pair{8, 8}, {1, 1}, {1, 400}, {400, 1}}) {
    spec::Case c = rectangle();
    c.target_width_px = width_px;
    c.target_height_px = height_px;
    const Raster picture = counterexample_picture(spec::built_in(), violation_of(c, 0, 0));
    const bool stacked = width_px > 3 * height_px;
    int32_t across = 0;  // pixels of captions' letters along the panels
    for (int32_t y = kGap_px; y < kGap_px + kCaption_px; ++y) {
      for (int32_t x = 0; x < picture.width_px; ++x) across += picture.at(x, y) == kInk;
    }
    EXPECT_GT(across, stacked ? 200 : 900) << width_px << " x " << height_px;
    EXPECT_GE(picture.width_px, 120);
  }
}

TEST(CounterexamplePicture, OfAFilterShowsColours) {
  spec::Case c = rectangle();
  c.filter = SELVAGE_FILTER_BILINEAR;
  const Raster picture = counterexample_picture(spec::built_in(), violation_of(c, 3, 3));
  const spec::Picture colours = spec::expected(c, spec::filter_texture(c));
  const auto channel = [&](int i) {
    return static_cast<uint8_t>(spec::channel(*colours.at(3, 3), i));
  };
  EXPECT_EQ(colour_at(picture, kExpected, 3, 3), (Colour{channel(0), channel(1), channel(2)}));
  EXPECT_EQ(colour_at(picture, kDrawn, 3, 3), colour_at(picture, kExpected, 3, 3));
  EXPECT_NE(colour_at(picture, kDifference, 3, 3), kRed);
  EXPECT_EQ(colour_at(counterexample_picture(shifted_texture(1), violation_of(c, 3, 3)),
                      kDifference, 3, 3),
            kRed);
}

TEST(CounterexamplePicture, OfARightDrawingShowsNoDifference) {
  const Raster picture = counterexample_picture(spec::built_in(), violation_of(rectangle(), 3, 3));
  for (int32_t y = 0; y < 8; ++y) {
    for (int32_t x = 0; x < 8; ++x) {
      EXPECT_EQ(colour_at(picture, kDrawn, x, y), colour_at(picture, kExpected, x, y));
      EXPECT_NE(colour_at(picture, kDifference, x, y), kRed);
      EXPECT_EQ(is_grey(colour_at(picture, kDrawn, x, y)), !covered(x, y));
    }
  }
}

// Red grows with the column of the texel and green with its row.
// Whose values have no room for the places of a larger texture: they are drawn digit by digit.
TEST(CounterexamplePicture, OfARightDrawingInANarrowFormatShowsNoDifference) {
  spec::Case c = rectangle();
  c.texture_width_texel = c.texture_height_texel = 300;
  for (selvage_vertex& v : c.vertices) {
    v.u *= 40;
    v.v *= 40;
  }
  for (const selvage_format format : {SELVAGE_INDEX8, SELVAGE_RGB565}) {
    c.format = format;
    const PictureComparison seen =
        counterexample(spec::built_in(), violation_of(c, 3, 3), /*drawings=*/nullptr);
    EXPECT_FALSE(differs(seen)) << format;
    EXPECT_EQ(seen.drawn.at(6, 5), spec::coordinate_texel(260, 220)) << format;
  }
}

TEST(CounterexamplePicture, ColoursATexelByItsPlace) {
  const Raster picture = counterexample_picture(spec::built_in(), violation_of(rectangle(), 3, 3));
  for (int32_t x = 2; x < 7; ++x) {
    EXPECT_GT(colour_at(picture, kDrawn, x, 3).red, colour_at(picture, kDrawn, x - 1, 3).red);
    EXPECT_EQ(colour_at(picture, kDrawn, x, 3).green, colour_at(picture, kDrawn, 1, 3).green);
  }
  for (int32_t y = 3; y < 6; ++y) {
    EXPECT_GT(colour_at(picture, kDrawn, 4, y).green, colour_at(picture, kDrawn, 4, y - 1).green);
  }
}

TEST(CounterexamplePicture, OfAWrongTexelIsRedThere) {
  const Raster picture =
      counterexample_picture(shifted_texture(1), violation_of(rectangle(), 3, 3));
  for (int32_t y = 0; y < 8; ++y) {
    for (int32_t x = 0; x < 8; ++x) {
      EXPECT_EQ(colour_at(picture, kDifference, x, y) == kRed, covered(x, y)) << x << ", " << y;
    }
  }
  EXPECT_GT(colour_at(picture, kDrawn, 3, 3).red, colour_at(picture, kExpected, 3, 3).red);
}

TEST(CounterexamplePicture, OfAnEmptyDrawingIsGreyAndRed) {
  const Raster picture = counterexample_picture(blank(), violation_of(rectangle(), 1, 2));
  EXPECT_TRUE(is_grey(colour_at(picture, kDrawn, 3, 3)));
  EXPECT_FALSE(is_grey(colour_at(picture, kExpected, 3, 3)));
  EXPECT_EQ(colour_at(picture, kDifference, 3, 3), kRed);
  EXPECT_NE(colour_at(picture, kDifference, 0, 0), kRed);
}

TEST(CounterexamplePicture, FramesTheBlamedPixelInEveryPanel) {
  const Raster picture =
      counterexample_picture(shifted_texture(1), violation_of(rectangle(), 4, 5));
  for (const Panel panel : {kDrawn, kExpected, kDifference}) {
    EXPECT_EQ(colour_at(picture, panel, 4, 5, 0), kWhite);
    EXPECT_EQ(colour_at(picture, panel, 4, 5, kScale_px - 1), kWhite);
    EXPECT_NE(colour_at(picture, panel, 3, 5, 0), kWhite);
  }
}

TEST(CounterexamplePicture, ShowsAValueThatNoTexelHasInMagenta) {
  const spec::Subject painter{
      "painter",
      [](const selvage_image* target, const selvage_rect*, const selvage_vertex*, size_t,
         const selvage_texture*, const selvage_options*) -> selvage_status {
        const uint8_t pixel[] = {77, 77, 77, 77};
        std::copy(pixel, pixel + 4, static_cast<uint8_t*>(target->pixels));
        return SELVAGE_OK;
      }};
  const Raster picture = counterexample_picture(painter, violation_of(rectangle(), 0, 0));
  EXPECT_EQ(colour_at(picture, kDrawn, 0, 0), kMagenta);
}

// Draws every pixel of the target, whatever the polygon.
[[nodiscard]] spec::Subject everywhere() {
  return {
      "everywhere",
      [](const selvage_image* target, const selvage_rect*, const selvage_vertex*, size_t,
         const selvage_texture*, const selvage_options*) -> selvage_status {
        const auto side = [](int32_t px) { return px * SELVAGE_SUBPIXELS; };
        const int32_t right = side(target->width), bottom = side(target->height);
        const uint32_t texel = 0;
        const selvage_texture texture{&texel, 1, 1, 4, target->format, 0, nullptr};
        const selvage_vertex all[] = {
            {0, 0, 0, 0, 1}, {right, 0, 0, 0, 1}, {right, bottom, 0, 0, 1}, {0, bottom, 0, 0, 1}};
        return selvage_draw(target, nullptr, all, 4, &texture, nullptr);
      }};
}

TEST(CounterexamplePicture, OfAFanShowsHowManyTilesDrawAPixel) {
  constexpr Colour once{60, 150, 224}, many = kWhite;
  const spec::Law& law = *spec::find_law("PINWHEEL");
  const auto none = law.check(blank(), rectangle()).violation;
  const auto all = law.check(everywhere(), rectangle()).violation;
  ASSERT_TRUE(none && all);
  const int32_t x = none->x_px, y = none->y_px;
  const Raster without = counterexample_picture(blank(), *none);
  EXPECT_TRUE(is_grey(colour_at(without, kDrawn, x, y)));
  EXPECT_EQ(colour_at(without, kExpected, x, y), once);
  EXPECT_EQ(colour_at(without, kDifference, x, y), kRed);
  const Raster with = counterexample_picture(everywhere(), *all);
  EXPECT_EQ(colour_at(with, kDrawn, x, y), many);
  EXPECT_EQ(colour_at(with, kExpected, x, y), once);
  EXPECT_EQ(colour_at(with, kDifference, x, y), kRed);
}

[[nodiscard]] bool has_red_in_a_frame(const Raster& picture) {
  for (int32_t y = 0; y < picture.height_px; ++y) {
    for (int32_t x = 1; x < picture.width_px; ++x) {
      if (picture.at(x - 1, y) == kWhite && picture.at(x, y) == kRed) return true;
    }
  }
  return false;
}

TEST(CounterexamplePicture, OfAFanShowsTheOneThatTheLawDrew) {
  for (const char* name : {"PART", "PINWHEEL"}) {
    for (const spec::Subject& wrong : {blank(), everywhere()}) {
      int seen = 0;
      for (uint64_t seed = 0; seed < 100; ++seed) {
        const auto found = spec::find_law(name)->check(wrong, spec::generate(seed)).violation;
        if (!found || found->x_px < 0) continue;
        ++seen;
        EXPECT_TRUE(has_red_in_a_frame(counterexample_picture(wrong, *found)))
            << name << ", " << wrong.name << ", seed " << seed;
      }
      EXPECT_GT(seen, 15) << name << ", " << wrong.name;
    }
  }
}

// Shows texels further right as one bit of its arguments has it: of two drawings that should be
// alike one may be wrong.
[[nodiscard]] spec::Subject moody() {
  return {"moody",
          [steady = spec::built_in(), shifted = shifted_texture(1)](
              const selvage_image* target, const selvage_rect* clip, const selvage_vertex* vertices,
              size_t count, const selvage_texture* texture, const selvage_options* options) {
            uint32_t hash = clip != nullptr ? static_cast<uint32_t>(clip->left) * 3U + 1 : 0;
            for (size_t i = 0; vertices != nullptr && i < count; ++i) {
              for (const int32_t part : {vertices[i].x, vertices[i].y, vertices[i].u, vertices[i].q,
                                         texture != nullptr ? texture->layout : 0}) {
                hash = (hash ^ static_cast<uint32_t>(part)) * 0x9E3779B9U;
              }
            }
            const spec::Subject& chosen = hash >> 31 != 0 ? shifted : steady;
            return chosen.draw(target, clip, vertices, count, texture, options);
          }};
}

TEST(CounterexamplePicture, OfTwoDrawingsShowsThoseThatTheLawHeldAgainstEachOther) {
  for (const char* name : {"CLIP", "SHIFT", "ORDER", "MIRROR", "SPLIT", "AFFINE", "SAME"}) {
    int seen = 0;
    for (uint64_t seed = 0; seed < 200; ++seed) {
      const auto found = spec::find_law(name)->check(moody(), spec::generate(seed)).violation;
      if (!found || !found->comparison) continue;
      ++seen;
      EXPECT_NE(found->allowed.find(", as "), std::string::npos) << found->allowed;
      const PictureComparison seen_by = counterexample(moody(), *found);
      EXPECT_TRUE(differs(seen_by));
      EXPECT_TRUE(has_red_in_a_frame(comparison_picture(seen_by))) << name << ", seed " << seed;
    }
    EXPECT_GT(seen, 15) << name;
  }
}

// Of a quad turned by a quarter, coverage alone is judged: no texel is called the allowed one.
TEST(CounterexamplePicture, OfCoverageNamesNoTexelAsAllowed) {
  const spec::Subject absent{
      "absent at times",
      [](const selvage_image* target, const selvage_rect* clip, const selvage_vertex* vertices,
         size_t count, const selvage_texture* texture, const selvage_options* options) {
        const bool is_absent = count > 3 && (vertices[0].x ^ vertices[1].y) % 2 != 0;
        return is_absent ? selvage_status{SELVAGE_OK}
                         : selvage_draw(target, clip, vertices, count, texture, options);
      }};
  int seen = 0;
  for (uint64_t seed = 0; seed < 2000; ++seed) {
    const auto found = spec::find_law("MIRROR")->check(absent, spec::generate(seed)).violation;
    if (!found || found->what.find("turned by a quarter") == std::string::npos) continue;
    if (found->shown.vertices.size() == 3 || found->drawn != "nothing") continue;
    ++seen;
    EXPECT_TRUE(found->allowed.starts_with("a texel, as the polygon")) << found->allowed;
  }
  EXPECT_GT(seen, 3);
}

// A pixel that is not drawn has no value, and the other drawing is named.
TEST(CounterexamplePicture, OfTilesTellsWhatTheyDrewInstead) {
  const spec::Subject without_clip{
      "whole pictures alone",
      [](const selvage_image* target, const selvage_rect* clip, const selvage_vertex* vertices,
         size_t count, const selvage_texture* texture, const selvage_options* options) {
        const bool is_part = clip != nullptr && clip->top > 0;
        return is_part ? selvage_status{SELVAGE_OK}
                       : selvage_draw(target, clip, vertices, count, texture, options);
      }};
  spec::Case c = rectangle();
  c.target_height_px = 64;
  c.choice = 2;
  const auto found = spec::find_law("SAME")->check(without_clip, c).violation;
  ASSERT_TRUE(found && found->comparison);
  EXPECT_EQ(found->drawn, "nothing");
  EXPECT_NE(found->allowed.find(" texture, as one after another"), std::string::npos)
      << found->allowed;
  EXPECT_NE(found->what.find("tile by tile show what they show one after another"),
            std::string::npos);
}

TEST(CounterexamplePicture, OfALargeTargetShowsTheBlamedPart) {
  spec::Case c = rectangle();
  c.target_width_px = 65536;
  c.target_height_px = 1;
  for (const int32_t x : {0, 30000, 65535, -1}) {
    const Raster picture =
        counterexample_picture(shifted_texture(1), violation_of(c, x, x < 0 ? -1 : 0));
    EXPECT_LE(picture.width_px, 1300);
    EXPECT_LE(picture.height_px, 500);
    const auto& rgba = picture.rgba;
    const bool framed = std::search_n(rgba.begin(), rgba.end(), 4, uint8_t{255}) != rgba.end();
    EXPECT_EQ(framed, x >= 0);
  }
}

}  // namespace
}  // namespace selvage::cli::test
