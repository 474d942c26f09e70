#include "spec/laws.h"

#include <gtest/gtest.h>

#include <set>

#include "spec/picture.h"

namespace selvage::spec {
namespace {

TEST(Laws, HaveNamesAndStatementsOfTheirOwn) {
  std::set<std::string_view> names, statements;
  for (const Law& law : laws()) {
    EXPECT_TRUE(names.insert(law.name).second) << law.name;
    EXPECT_TRUE(statements.insert(law.statement).second) << law.statement;
    EXPECT_EQ(find_law(law.name), &law);
  }
  EXPECT_EQ(find_law("NONE"), nullptr);
  for (const char* name :
       {"COV", "PART", "PINWHEEL", "CLIP", "VERT", "MAP", "GAMUT", "SHIFT", "ORDER", "MIRROR",
        "SPLIT", "IDENTITY", "AFFINE", "FILTER", "TOLERANCE", "MEM", "TOTAL", "SAME"}) {
    EXPECT_TRUE(names.contains(name)) << name;
  }
}

TEST(Laws, ExplainFiltersByChannels) {
  Case c;
  c.filter = SELVAGE_FILTER_BILINEAR;
  c.vertices = {{0, 0, 0, 0, 1}, {1024, 0, 65536, 0, 1}, {0, 1024, 0, 65536, 1}};
  const Subject nearest{
      "nearest",
      [](const selvage_image* target, const selvage_rect* clip, const selvage_vertex* vertices,
         size_t count, const selvage_texture* texture, const selvage_options* options) {
        selvage_options changed = *options;
        changed.filter = SELVAGE_FILTER_NEAREST;
        return selvage_draw(target, clip, vertices, count, texture, &changed);
      }};
  const Judgement judgement = find_law("FILTER")->check(nearest, c);
  ASSERT_TRUE(judgement.violation);
  EXPECT_EQ(judgement.violation->allowed.substr(0, 8), "channels");
  EXPECT_NE(judgement.violation->allowed, judgement.violation->drawn);
  EXPECT_FALSE(find_law("COV")->check(nearest, c).violation);
}

TEST(Laws, ExplainThemselves) {
  Case c;
  c.vertices = {{0, 0, 0, 0, 1}, {1024, 0, 65536, 0, 1}, {0, 1024, 0, 65536, 1}};
  const Subject lazy{"lazy", [](auto...) { return SELVAGE_OK; }};
  const Judgement judgement = find_law("COV")->check(lazy, c);
  ASSERT_TRUE(judgement.violation);
  EXPECT_EQ(judgement.violation->x_px, 0);
  EXPECT_EQ(judgement.violation->u, "1/8");
  EXPECT_EQ(judgement.violation->drawn, "nothing");
  const std::string text = explain(*judgement.violation);
  for (const char* part : {"COV", "(0, 0)", "1/8", "nothing"}) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace selvage::spec
