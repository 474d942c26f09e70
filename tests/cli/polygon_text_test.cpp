#include "cli/polygon_text.h"

#include "support.h"

namespace selvage::cli::test {
namespace {

[[nodiscard]] std::string polygon_text_refusal(const std::string& text) {
  return error_of([&] { static_cast<void>(parse_polygon_text(text)); });
}

TEST(PolygonText, GivesEachVertexItsNumbers) {
  const std::vector<JobVertex> expected = {
      {10, 10, 0, 0, 1}, {200.5, -20, 640, 1e3, 2.5}, {-0.25, 180, 640, 480, 1}};
  EXPECT_EQ(parse_polygon_text("10,10,0,0 200.5,-20,640,1e3,2.5 -0.25,180,640,480"), expected);
  EXPECT_EQ(parse_polygon_text("\n 10,10,0,0\t200.5,-20,640,1e3,2.5\r\n-.25,180,640,480  "),
            expected);
}

TEST(PolygonText, SaysWhichVertexIsWrong) {
  EXPECT_EQ(polygon_text_refusal("1,2,3,4 1,2,3 1,2,3,4"),
            "vertex 2: '1,2,3' has 3 numbers; a vertex is x,y,u,v or x,y,u,v,w without blanks");
  EXPECT_EQ(polygon_text_refusal("1, 2,3,4 1,2,3,4 1,2,3,4"),
            "vertex 1: '1,' has 2 numbers; a vertex is x,y,u,v or x,y,u,v,w without blanks");
  EXPECT_EQ(polygon_text_refusal("1,2,3,4 1,2,3,4 1,2,3,4,5,6"),
            "vertex 3: '1,2,3,4,5,6' has 6 numbers; a vertex is x,y,u,v or x,y,u,v,w without "
            "blanks");
  EXPECT_EQ(polygon_text_refusal("12 1,2,3,4 1,2,3,4"),
            "vertex 1: '12' has 1 number; a vertex is x,y,u,v or x,y,u,v,w without blanks");
}

TEST(PolygonText, RefusesWhatIsNoNumber) {
  for (const char* field :
       {"", "a", "1a", "0x10", "nan", "inf", "-inf", "1e999", "+1", "--1", "1.2.3", "1;2"}) {
    const std::string vertex = "1,2," + std::string(field) + ",4";
    EXPECT_EQ(polygon_text_refusal("1,2,3,4 " + vertex + " 1,2,3,4"),
              "vertex 2: '" + std::string(field) + "' in '" + vertex +
                  "' is no number; 12, -0.5 and 1e3 are");
  }
}

TEST(PolygonText, NeedsThreeVertices) {
  EXPECT_EQ(polygon_text_refusal(""), "a polygon needs at least 3 vertices; this one has 0");
  EXPECT_EQ(polygon_text_refusal("1,2,3,4 1,2,3,4"),
            "a polygon needs at least 3 vertices; this one has 2");
}

TEST(ClipText, IsFourWholeNumbers) {
  const selvage_rect clip = parse_clip_text("-5,0,2147483647,-2147483648");
  EXPECT_EQ(clip.left, -5);
  EXPECT_EQ(clip.top, 0);
  EXPECT_EQ(clip.right, 2147483647);
  EXPECT_EQ(clip.bottom, INT32_MIN);
  for (const char* text : {"", "1,2,3", "1,2,3,4,5", "1,2,3,4.5", "1,2,3,", "1,2,3,2147483648",
                           "1 ,2,3,4", "a,b,c,d"}) {
    EXPECT_EQ(error_of([&] { static_cast<void>(parse_clip_text(text)); }),
              "'" + std::string(text) + "' is no clip; left,top,right,bottom in whole pixels is");
  }
}

TEST(SizeText, IsTwoWholeNumbersWithinTheLimits) {
  EXPECT_EQ(parse_size_text("256x192").width_px, 256);
  EXPECT_EQ(parse_size_text("256x192").height_px, 192);
  for (const char* text :
       {"", "x", "256", "256x", "x192", "256x192x3", "256X192", "2.5x2", "256 x 192"}) {
    EXPECT_EQ(error_of([&] { static_cast<void>(parse_size_text(text)); }),
              "'" + std::string(text) + "' is no size; WIDTHxHEIGHT in pixels is, as in 256x192");
  }
  for (const char* text : {"0x5", "5x0", "-5x5", "32769x1", "1x32769", "32768x32768"}) {
    expect_contains(error_of([&] { static_cast<void>(parse_size_text(text)); }), "not accepted");
  }
}

}  // namespace
}  // namespace selvage::cli::test
