// The matrix as a value and as a page, from verdicts that are written down here.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "reports/page/again.h"
#include "reports/page/known.h"
#include "reports/page/matrix.h"
#include "spec/case.h"
#include "tests/page/contains.h"

namespace selvage::reports {
namespace {

using json = nlohmann::ordered_json;

const json kLaws = {{{"law", "COV"}, {"statement", "covered <is> covered"}},
                    {{"law", "MAP"}, {"statement", "the texel"}},
                    {{"law", "TOTAL"}, {"statement", "errors"}},
                    {{"law", "DDA"},
                     {"statement", "its arithmetic"},
                     {"profiles",
                      {{"exact", {{"standing", "says nothing of it"}, {"note", "MAP <does>"}}},
                       {"dkit", {{"standing", "promised"}}}}}}};

[[nodiscard]] json verdict() {
  spec::Case shown;
  shown.vertices = {{0, 0, 0, 0, 1}, {256, 0, 0, 0, 1}, {0, 256, 0, 0, 1}};
  const json violation = {{"what", "texel & place"},
                          {"u_texel", "1/3"},
                          {"v_texel", "2/7"},
                          {"allowed", "texel (0, 0)"},
                          {"drawn", "nothing"},
                          {"shown_case", spec::to_hex(shown)},
                          {"pixel_px", {4, 5}},
                          {"sample", "(4.5, 5.5) px, in the polygon"},
                          {"case_number", 12},
                          {"case", spec::to_hex(shown)},
                          {"replay", "selvage verify --subject a.so --law MAP --case 02"},
                          {"picture", "/some/where/one-MAP.png"}};
  return {{"selvage", "1"},
          {"subject", "one 2.0"},
          {"profile", "exact"},
          {"passed", false},
          {"arguments", " --subject a.so"},
          {"seed", 7},
          {"cases", 90},
          {"laws",
           {{{"law", "COV"},
             {"verdict", "holds"},
             {"cases", 90},
             {"judged_px", 12345},
             {"time_ns", 5},
             {"nearest", {{"measured", 1.0}, {"bound", 4.0}}},
             {"not_claimed", {{"perspective", 3}}}},
            {{"law", "MAP"},
             {"verdict", "violated"},
             {"cases", 13},
             {"judged_px", 2},
             {"time_ns", 5},
             {"violation", violation}}}},
          {"not_promised", {{{"law", "TOTAL"}, {"why", "names no errors"}}}}};
}

[[nodiscard]] json matrix_with(const json& findings, const std::string& group = "peers") {
  return matrix_of({{.group = group, .id = "one", .verdict = verdict(), .error = ""},
                    {.group = "peers", .id = "two", .verdict = nullptr, .error = "no <library>"}},
                   kLaws, findings);
}

// `selvage verify --time` may end before a law had its turn.
TEST(Matrix, ShowsWhatWasNotJudged) {
  MatrixRow row{.group = "ours", .id = "one", .verdict = verdict(), .error = ""};
  row.verdict["laws"].erase(1);
  row.verdict["laws"][0] = {
      {"law", "COV"}, {"verdict", "not judged"}, {"cases", 0}, {"judged_px", 0}, {"time_ns", 0}};
  const json matrix = matrix_of({row}, kLaws, json::object());
  EXPECT_EQ(matrix.at("subjects")[0].at("cells")[0].at("verdict"), "not judged");
  EXPECT_TRUE(contains(matrix_section(matrix), "<td class=quiet>not judged"));
  EXPECT_FALSE(ours_hold(matrix)) << "it has shown nothing";
}

TEST(Matrix, TakesFromEachVerdictWhatItsCellsSay) {
  const json matrix = matrix_with(json::object());
  EXPECT_EQ(matrix.at("seed"), 7);
  EXPECT_EQ(matrix.at("cases"), 90);
  const json& cells = matrix.at("subjects")[0].at("cells");
  ASSERT_EQ(cells.size(), 3u);
  EXPECT_EQ(cells[1].at("page"), "matrix/one-MAP.html");
  EXPECT_EQ(cells[1].at("violation").at("picture"), "one-MAP.png");
  EXPECT_EQ(cells[2].at("verdict"), "not promised");
  EXPECT_EQ(matrix["subjects"][1].at("error"), "no <library>");
}

TEST(Matrix, IsNoFailureUnlessAMapperOfOursBreaksALaw) {
  EXPECT_TRUE(ours_hold(matrix_with(json::object())));
  EXPECT_FALSE(ours_hold(matrix_with(json::object(), "ours")));
}

TEST(Matrix, SectionShowsEveryKindOfCell) {
  const std::string html = matrix_section(matrix_with(json::object()));
  EXPECT_TRUE(contains(html, "one 2.0"));
  EXPECT_TRUE(contains(html, "title=\"covered &lt;is&gt; covered\""));
  EXPECT_TRUE(contains(html, "0.250 of bound"));
  EXPECT_TRUE(contains(html, "90 cases, 12&nbsp;345 px; not claimed: 3 cases: perspective"));
  EXPECT_TRUE(contains(html, "href=\"matrix/one-MAP.html\""));
  EXPECT_TRUE(contains(html, "unexamined"));
  EXPECT_TRUE(contains(html, "names no errors"));
  EXPECT_TRUE(contains(html, "not judged: no &lt;library&gt;"));
  EXPECT_TRUE(contains(html, "<td class=quiet title=\"MAP &lt;does&gt;\"></td>"));
  EXPECT_FALSE(contains(html, "promised\"></td>")) << "only what says nothing tells why";
  EXPECT_EQ(matrix_section(nullptr), "");
}

TEST(Matrix, FindingsAreShownWhereTheLawWasBrokenAlone) {
  const json finding = {
      {"kind", "defect"}, {"text", "it promises <more>"}, {"source", "its manual"}};
  const json findings = {{"one",
                          {{"convention", "samples corners"},
                           {"examined", "1.9"},
                           {"laws", {{"MAP", finding}, {"COV", finding}}}}}};
  const json matrix = matrix_with(findings);
  EXPECT_FALSE(matrix.at("subjects")[0].at("cells")[0].contains("finding"));
  const std::string html = matrix_section(matrix);
  EXPECT_TRUE(contains(html, ">defect</a>"));
  EXPECT_TRUE(contains(html, "it promises &lt;more&gt;"));
  EXPECT_TRUE(contains(html, "Source: its manual"));
  EXPECT_TRUE(contains(html, "samples corners"));
  EXPECT_TRUE(contains(html, "(examined: 1.9)"));
  EXPECT_FALSE(contains(html, "unexamined"));
}

// A finding is about the case that it was found on. Where that holds now it is stale, and another
// violation of its law is one that nobody has looked at.
TEST(Matrix, FindingsWhoseCaseHoldsAreStale) {
  const json finding = {{"kind", "limit"}, {"text", "t"}, {"source", "s"}, {"case", "02"}};
  const json findings = {
      {"one",
       {{"examined", "1"}, {"convention", "c"}, {"laws", {{"MAP", finding}, {"COV", finding}}}}}};
  const json matrix = matrix_with(findings);
  EXPECT_EQ(matrix["subjects"][0].at("stale"), json::array({"COV", "MAP"}));
  EXPECT_TRUE(contains(matrix_section(matrix),
                       "<strong>COV</strong>: the case that the finding is about holds now"));
  EXPECT_TRUE(contains(matrix_section(matrix), "unexamined"));
  const auto open = open_questions(matrix);
  ASSERT_EQ(open.size(), 3u);
  EXPECT_EQ(open[1], "one: MAP: the finding is stale: its case holds");
  EXPECT_EQ(open[2], "one: MAP: the violation is unexamined");

  json replayed = verdict();
  replayed["laws"][1]["violation"]["found_by"] = "corpus";
  const json known = {{"one", {{"laws", {{"MAP", finding}}}}}};
  const json again =
      matrix_of({{.group = "peers", .id = "one", .verdict = replayed, .error = ""}}, kLaws, known);
  EXPECT_EQ(again["subjects"][0]["cells"][1].at("finding").at("kind"), "limit");
  EXPECT_TRUE(open_questions(again).empty());
}

TEST(Matrix, TriesTheCasesOfItsFindingsFirst) {
  const auto hex = [](int32_t side_px) {
    spec::Case c;
    c.target_width_px = side_px;
    return spec::to_hex(c);
  };
  const json findings = {
      {"one", {{"laws", {{"MAP", {{"case", hex(1)}}}}}}},
      {"two", {{"laws", {{"MAP", {{"case", hex(2)}}}, {"COV", {{"case", hex(3)}}}}}}}};
  spec::Case old;
  old.target_width_px = 4;
  const auto widths = [&](const std::string& id) {
    std::string text;
    for (const cli::KnownCase& known : known_cases(findings, id, {{"CLIP", old}, {"MAP", old}})) {
      text += known.law + std::to_string(known.found.target_width_px) + " ";
    }
    return text;
  };
  EXPECT_EQ(widths("one"), "MAP1 COV3 CLIP4 ");
  EXPECT_EQ(widths("two"), "MAP2 COV3 CLIP4 ");
  EXPECT_EQ(widths("three"), "MAP1 MAP2 COV3 CLIP4 MAP4 ");
}

TEST(Matrix, TriesAgainWhatIsNewWhereTheLawWasKept) {
  const auto row = [](const char* id, const char* standing, const char* found_by) {
    json values = verdict();
    values["laws"][1]["verdict"] = standing;
    values["laws"][1]["violation"]["found_by"] = found_by;
    if (standing == std::string("holds")) values["laws"][1].erase("violation");
    return MatrixRow{.group = "others", .id = id, .verdict = values, .error = ""};
  };
  const std::vector<MatrixRow> rows = {
      row("new", "violated", "hunt"),
      row("known", "violated", "corpus"),
      row("kept", "holds", ""),
      {.group = "others", .id = "none", .verdict = nullptr, .error = "x"}};
  const json none = json::object();
  ASSERT_EQ(to_try_again(rows, none, "kept").size(), 1u);
  EXPECT_EQ(to_try_again(rows, none, "kept")[0].law, "MAP");
  EXPECT_TRUE(to_try_again(rows, none, "new").empty());
  EXPECT_TRUE(to_try_again(rows, none, "known").empty());
  EXPECT_TRUE(to_try_again(rows, none, "none").empty());
  const json examined = {{"kept", {{"laws", {{"MAP", {{"case", "02"}}}}}}}};
  EXPECT_TRUE(to_try_again(rows, examined, "kept").empty()) << "its finding has a case of its own";
}

TEST(Matrix, TakesFromASecondPassWhatItBroke) {
  json first = verdict(), second = verdict();
  first["passed"] = true;
  first["laws"][1]["verdict"] = "holds";
  second["laws"][0]["cases"] = 1;
  const json both = with_second(first, second);
  EXPECT_EQ(both["laws"][0], first["laws"][0]);
  EXPECT_EQ(both["laws"][1], second["laws"][1]);
  EXPECT_EQ(both["passed"], false);
}

TEST(Matrix, CounterexampleTellsAllThatIsNeeded) {
  const json matrix = matrix_with(json::object());
  const json& subject = matrix.at("subjects")[0];
  const std::string html = counterexample_page(matrix, subject, subject.at("cells")[1]);
  for (const char* part :
       {"one 2.0: MAP", "the texel", "texel &amp; place", "(4, 5)", "(4.5, 5.5) px", "1/3", "2/7",
        "texel (0, 0)", "nothing", "case 12", "one-MAP.png", "drawn | expected | difference",
        "(1, 0), (0, 0), 1", "selvage verify --subject a.so --law MAP --case 02",
        "../index.html#matrix"})
    EXPECT_TRUE(contains(html, part)) << part;

  EXPECT_FALSE(contains(html, "tile"));

  json cell = subject.at("cells")[1];
  cell["violation"]["notes"] = {"cut <short>"};
  EXPECT_TRUE(contains(counterexample_page(matrix, subject, cell), "cut &lt;short&gt;"));
  cell["violation"]["found_by"] = "hunt";
  EXPECT_TRUE(contains(counterexample_page(matrix, subject, cell), "in hunted case 12"));
  cell["violation"]["found_by"] = "corpus";
  EXPECT_TRUE(
      contains(counterexample_page(matrix, subject, cell), "known before, and tried first"));
  cell["finding"] = {{"kind", "defect"}, {"text", "t"}};
  EXPECT_FALSE(contains(counterexample_page(matrix, subject, cell), "by itself the case can hold"));
  cell["finding"]["varies"] = true;
  EXPECT_TRUE(contains(counterexample_page(matrix, subject, cell), "by itself the case can hold"));
  cell["law"] = "PINWHEEL";
  const std::string fan = counterexample_page(matrix, subject, cell);
  EXPECT_TRUE(contains(fan, "drawn in tiles: triangles from (4.5, 5.5) px to each side"));
  EXPECT_TRUE(contains(fan, "blue is drawn by one tile"));
}

}  // namespace
}  // namespace selvage::reports
