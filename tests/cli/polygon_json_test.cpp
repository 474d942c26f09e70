#include "cli/polygon_json.h"

#include "support.h"

namespace selvage::cli::test {
namespace {

constexpr const char* kWhole = R"({
  "vertices": [[10, 10, 0, 0], [200.5, -20, 640, 1e3, 2.5],
               {"x": -0.25, "y": 180, "u": 640, "v": 480, "w": 3}, {"x": 1, "y": 2, "u": 3, "v": 4}],
  "clip": [-1, 2, 300, 400], "address": "wrap", "filter": "nearest"
})";

[[nodiscard]] std::string polygon_json_refusal(std::string_view text) {
  return error_of([&] { static_cast<void>(parse_polygon_json("p.json", text)); });
}

// A polygon file that is right but for `vertices`, or but for what else it says.
[[nodiscard]] std::string refused_vertices(const std::string& vertices) {
  return polygon_json_refusal("{\"vertices\": " + vertices + "}");
}
[[nodiscard]] std::string refused_beside(const std::string& members) {
  return polygon_json_refusal(R"({"vertices": [[0,0,0,0],[1,0,0,0],[0,1,0,0]], )" + members + "}");
}

TEST(PolygonJson, GivesOnePolygon) {
  const Job job = parse_polygon_json("p.json", kWhole);
  ASSERT_EQ(job.size(), 1u);
  EXPECT_EQ(job[0].vertices, (std::vector<JobVertex>{{10, 10, 0, 0, 1},
                                                     {200.5, -20, 640, 1000, 2.5},
                                                     {-0.25, 180, 640, 480, 3},
                                                     {1, 2, 3, 4, 1}}));
  ASSERT_TRUE(job[0].clip.has_value());
  EXPECT_EQ(job[0].clip->left, -1);
  EXPECT_EQ(job[0].clip->top, 2);
  EXPECT_EQ(job[0].clip->right, 300);
  EXPECT_EQ(job[0].clip->bottom, 400);
  EXPECT_EQ(job[0].options.address, SELVAGE_ADDRESS_WRAP);
}

TEST(PolygonJson, GivesSeveralPolygonsWithCommonSettings) {
  const Job job =
      parse_polygon_json("p.json", R"({"address": "wrap", "clip": [0, 0, 9, 9], "polygons": [
      {"vertices": [[0,0,0,0],[1,0,0,0],[0,1,0,0]]},
      {"vertices": [[0,0,0,0],[2,0,0,0],[0,2,0,0]], "address": "clamp", "clip": [1, 1, 2, 2]}]})");
  ASSERT_EQ(job.size(), 2u);
  EXPECT_EQ(job[0].options.address, SELVAGE_ADDRESS_WRAP);
  EXPECT_EQ(job[0].clip->right, 9);
  EXPECT_EQ(job[1].options.address, SELVAGE_ADDRESS_CLAMP);
  EXPECT_EQ(job[1].clip->right, 2);
  EXPECT_EQ(job[1].vertices[1].x_px, 2);
}

TEST(PolygonJson, CutShortIsRefusedAtEveryLength) {
  const std::string_view whole = kWhole;
  for (size_t length = 0; length < whole.size(); ++length) {
    expect_contains(polygon_json_refusal(whole.substr(0, length)), "not JSON: ");
  }
}

TEST(PolygonJson, SaysWhereItIsNotJson) {
  expect_contains(polygon_json_refusal("{\n  \"vertices\": [,]}"),
                  "p.json:2: not JSON: column 16: syntax error");
  expect_contains(polygon_json_refusal(R"({"vertices": []} x)"), "not JSON: ");
  expect_contains(polygon_json_refusal(R"({"vertices": [[1e999, 0, 0, 0]]})"),
                  "not JSON: number overflow");
  expect_contains(polygon_json_refusal("\xff\xfe{}"), "not JSON: ");
  expect_contains(polygon_json_refusal("{\"\xc3\x28\": 1}"), "not JSON: ");
}

TEST(PolygonJson, NamesAnUnknownKeyAndTheKnownOnes) {
  EXPECT_EQ(
      refused_beside(R"("colour": 3)"),
      "p.json:1: unknown key \"colour\"; known here: vertices, clip, address, filter, profile");
  EXPECT_EQ(
      polygon_json_refusal(R"({"polygons": [], "vertices": []})"),
      "p.json:1: unknown key \"vertices\"; known here: polygons, clip, address, filter, profile");
  EXPECT_EQ(refused_vertices(R"([{"x": 1, "y": 2, "u": 3, "v": 4, "z": 5}])"),
            "p.json:1: vertices: vertex 1: unknown key \"z\"; known here: x, y, u, v, w");
}

TEST(PolygonJson, RefusesAKeyThatStandsTwice) {
  EXPECT_EQ(refused_beside(R"("clip": [0,0,1,1], "clip": [0,0,2,2])"),
            "p.json:1: the key \"clip\" stands twice");
  EXPECT_EQ(refused_vertices(R"([{"x": 1, "x": 2, "y": 2, "u": 3, "v": 4}])"),
            "p.json:1: the key \"x\" stands twice");
}

TEST(PolygonJson, NamesWhatIsMissing) {
  EXPECT_EQ(polygon_json_refusal("{}"),
            "p.json:1: 'vertices' is missing (or 'polygons', for several)");
  EXPECT_EQ(polygon_json_refusal(R"({"polygons": [{}]})"),
            "p.json:1: polygons: polygon 1: 'vertices' is missing");
  EXPECT_EQ(refused_vertices(R"([[0,0,0,0], {"x": 1, "y": 2, "v": 4}])"),
            "p.json:1: vertices: vertex 2: 'u' is missing");
  EXPECT_EQ(refused_vertices("[[0,0,0,0], [1,0,0,0]]"),
            "p.json:1: vertices: a polygon needs at least 3 vertices; this one has 2");
  EXPECT_EQ(polygon_json_refusal(R"({"polygons": []})"),
            "p.json:1: polygons: an array of at least one polygon is needed, not []");
}

TEST(PolygonJson, NamesWhatIsOfTheWrongKind) {
  EXPECT_EQ(polygon_json_refusal("[1, 2]"), "p.json:1: an object is needed, not [1,2]");
  EXPECT_EQ(refused_vertices("7"), "p.json:1: vertices: an array is needed, not 7");
  EXPECT_EQ(refused_vertices(R"([[0,0,0,0], "no"])"),
            "p.json:1: vertices: vertex 2: [x, y, u, v] or an object is needed, not \"no\"");
  EXPECT_EQ(refused_vertices("[[0,0,0,null]]"),
            "p.json:1: vertices: vertex 1: number 4: a number is needed, not null");
  EXPECT_EQ(refused_vertices(R"([{"x": "1", "y": 2, "u": 3, "v": 4}])"),
            "p.json:1: vertices: vertex 1: x: a number is needed, not \"1\"");
  EXPECT_EQ(refused_vertices("[[0,0,0]]"),
            "p.json:1: vertices: vertex 1: [0,0,0] has 3 numbers; a vertex is [x, y, u, v] or "
            "[x, y, u, v, w]");
  EXPECT_EQ(refused_beside(R"("address": "mirror")"),
            "p.json:1: address: 'mirror' is no address mode; clamp and wrap are");
  EXPECT_EQ(refused_beside(R"("address": 1)"), "p.json:1: address: a text is needed, not 1");
  EXPECT_EQ(refused_beside(R"("filter": "cubic")"),
            "p.json:1: filter: 'cubic' is no filter; nearest, four, bilinear and area are");
}

TEST(PolygonJson, NamesTheLine) {
  const auto expect = [](const char* polygon, const char* error) {
    const std::string other = R"({"vertices": [[0,0,0,0],[1,0,0,0],[0,1,0,0]]})";
    EXPECT_EQ(polygon_json_refusal("{\n\"polygons\":\n[" + other + ",\n" + polygon + "]}"), error);
  };
  expect("7", "p.json:2: polygons: polygon 2: an object is needed, not 7");  // its array's line
  expect("{\"vertices\":\n[[0,0,0,0],\n[1,0]]}",
         "p.json:6: polygons: polygon 2: vertices: vertex 2: [1,0] has 2 numbers; a vertex is "
         "[x, y, u, v] or [x, y, u, v, w]");
  expect("{\"vertices\": [],\n\"filter\":\n\"best\"}",
         "p.json:5: polygons: polygon 2: filter: 'best' is no filter; nearest, four, bilinear and "
         "area are");
  expect("{\"filter\":\n3}", "p.json:4: polygons: polygon 2: filter: a text is needed, not 3");
  expect("{\"clip\": 1,\n\"clip\": 2}", "p.json:5: the key \"clip\" stands twice");
}

TEST(PolygonJson, WantsFourWholeNumbersForAClip) {
  for (const char* clip :
       {"[1,2,3]", "[1,2,3,4,5]", "[1,2,3,4.5]", "[1,2,3,2147483648]", "[1,2,3,-2147483649]",
        "[1,2,3,18446744073709551615]", "\"1,2,3,4\"", "null"}) {
    EXPECT_EQ(refused_beside("\"clip\": " + std::string(clip)),
              "p.json:1: clip: [left, top, right, bottom] in whole pixels is needed, not " +
                  std::string(clip));
  }
}

TEST(PolygonJson, QuotesOnlyTheBeginningOfWhatIsLong) {
  const std::string many(100000, 'a');
  for (const std::string& members : {"\"clip\": \"" + many + "\"", "\"" + many + "\": 1",
                                     "\"" + many + "\": 1, \"" + many + "\": 2"}) {
    const std::string error = refused_beside(members);
    EXPECT_LT(error.size(), 200u);
    expect_contains(error, "aaa...");
  }
}

TEST(PolygonJson, NestedDeeplyIsRefusedEarly) {
  EXPECT_EQ(polygon_json_refusal(std::string(1000000, '[')),
            "p.json:1: nested deeper than any file here is");
  std::string objects;
  for (int i = 0; i < 100000; ++i) objects += "{\"a\":";
  EXPECT_EQ(polygon_json_refusal(objects), "p.json:1: nested deeper than any file here is");
}

}  // namespace
}  // namespace selvage::cli::test
