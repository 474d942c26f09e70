// The section of the page, from numbers that are written down here.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "reports/page/scenes.h"
#include "tests/page/contains.h"

namespace selvage::reports {
namespace {

using json = nlohmann::ordered_json;

[[nodiscard]] json spread(double median) {
  return {{"median", median}, {"lower_quartile", median - 0.5}, {"upper_quartile", median + 0.5}};
}

[[nodiscard]] json trial(const std::string& tolerance, double error, int different, double ns) {
  return {{"filter", "nearest"},
          {"tolerance", tolerance},
          {"overlay", "one-" + tolerance + ".png"},
          {"choices", {{{"id", "exact-nearest"}, {"px", 4321}, {"faces", 1}}}},
          {"textured_px", 4321},
          {"largest_error_texel", error},
          {"mean_error_texel", error / 2},
          {"bound_texel", error},
          {"wrong_texels", 77 * different},
          {"different_px", different},
          {"largest_level", 9},
          {"breaches", 0},
          {"first_breach", ""},
          {"textured_ns_per_px", spread(ns)},
          {"ns_per_px", spread(ns)}};
}

[[nodiscard]] json scenes() {
  const json one = {{"id", "one"},
                    {"title", "A <thing>"},
                    {"sentence", "It turns."},
                    {"width_px", 64},
                    {"height_px", 48},
                    {"picture", "one.png"},
                    {"picture_filter", "auto"},
                    {"animation", "one.apng"},
                    {"frames", 7},
                    {"tolerance", "1/4"},
                    {"faces", 30},
                    {"faces_from_behind", 11},
                    {"faces_seen", 19},
                    {"faces_shown", 17},
                    {"shown_px", 5000},
                    {"trials",
                     {trial("0", 0, 0, 4), trial("1/4", 0, 0, 6), trial("1", 0.75, 13, 2),
                      trial("4", 0.75, 13, 2)}}};
  return {{"repetitions", 5},
          {"choices",
           {{{"id", "exact-nearest"}, {"title", "a division a pixel"}, {"colour", "#123456"}}}},
          {"scenes", {one}}};
}

TEST(ScenesPage, ShowsPicturesLegendAndNumbers) {
  const json all = scenes();
  EXPECT_TRUE(contains(scenes_head(all), "src=\"one.png\""));
  const std::string html = scenes_section(all);
  for (const char* part : {"id=scenes", "A &lt;thing&gt;", "one.apng", "one-1/4.png",
                           "background:#123456", "a division a pixel: 4&nbsp;321 pixels of 1 face",
                           "11 are turned away", "0.7500 &le; 0.7500 &le; 1<", "1&nbsp;001",
                           "by up to 9 of 255", "scenes-cost.svg", "scenes-error.svg"}) {
    EXPECT_TRUE(contains(html, part)) << part << "\n" << html;
  }
  EXPECT_FALSE(contains(html, "BROKEN"));
  EXPECT_EQ(kept_promises(all).kept, 4u);
}

// What a tolerance buys, and what it does not, is said.
TEST(ScenesPage, SaysFromWhereOnThePictureDiffersAndWhatItSaves) {
  const std::string remarks = tolerance_remarks(scenes()["scenes"][0]);
  for (const char* part :
       {"differs from the exact one is that within a tolerance of 1, in 13 pixels",
        "Beyond a tolerance of 1 nothing changes", "Within 4 texels a textured pixel takes 0.500",
        "Within 1/4 texel it takes more than the exact one"}) {
    EXPECT_TRUE(contains(remarks, part)) << part << "\n" << remarks;
  }
  json none = scenes()["scenes"][0];
  for (json& one : none["trials"]) one["different_px"] = 0;
  EXPECT_TRUE(contains(tolerance_remarks(none), "No pixel differs from the exact picture"));
}

TEST(ScenesPage, ABrokenPromiseStandsOutAndNothingWasTimed) {
  json all = scenes();
  json& bad = all["scenes"][0]["trials"][2];
  bad["breaches"] = 6;
  bad["first_breach"] = "pixel (1, 2), subdivided: measured 2 texel is above the bound, 1 texel";
  for (json& one : all["scenes"][0]["trials"])
    one["textured_ns_per_px"] = one["ns_per_px"] = nullptr;
  const std::string html = scenes_section(all);
  EXPECT_TRUE(contains(html, "class=bad>Promises are BROKEN"));
  EXPECT_TRUE(contains(html, "measured 2 texel is above the bound, 1 texel; 6 such pixels"));
  EXPECT_FALSE(contains(html, "scenes-cost.svg"));
  EXPECT_EQ(kept_promises(all).kept, 3u);
}

TEST(ScenesPage, SaysWhyThereIsNone) {
  EXPECT_EQ(scenes_head(nullptr), "");
  EXPECT_TRUE(contains(scenes_section(nullptr), "Not drawn: "));
  EXPECT_EQ(kept_promises(nullptr).all, 0u);
}

}  // namespace
}  // namespace selvage::reports
