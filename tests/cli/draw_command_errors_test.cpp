// What `selvage draw` refuses, and what it leaves then.
#include <filesystem>
#include <utility>

#include "draw_files.h"

namespace selvage::cli::test {
namespace {

TEST_F(Draw, RefusesWhatItCannotDraw) {
  options_.polygons = {kQuad, "0,0,0,0 40,40,0,0 80,0,0,0 80,80,0,0 40,20,0,0 0,80,0,0"};
  EXPECT_EQ(refusal(), std::string("polygon 2: ") +
                           selvage_status_text(SELVAGE_ERROR_NOT_MONOTONE) +
                           " (cut it into convex pieces: those that share an edge leave no gap)");
  options_.polygons = {"0,0,0,0 99999,0,0,0 80,0,0,0"};
  expect_contains(refusal(), "vertex 2 (x 99999, ");
}

TEST_F(Draw, NamesTheVertexThatAHistoricProfileCannotTake) {
  options_.profile = "abrash56";
  options_.polygons = {"0,0,0,0 9,0,8,0 0,9.5,0,8"};
  EXPECT_EQ(refusal(), std::string("vertex 3 (x 0, y 9.5, u 0, v 8, w 1): ") +
                           selvage_status_text(SELVAGE_ERROR_VERTEX_FRACTION));
  options_.polygons = {"0,0,0,0 9,0,8,0 0,9,0,8", "0,0,0,0 -8.25,1,8,0 0,9,0,8"};
  EXPECT_EQ(refusal(), std::string("polygon 2, vertex 2 (x -8.25, y 1, u 8, v 0, w 1): ") +
                           selvage_status_text(SELVAGE_ERROR_VERTEX_FRACTION));
  options_.polygons = {"0,0,0,0,2 9,0,8,0,2 0,9,0,8,3"};
  EXPECT_EQ(refusal(), std::string("vertex 3 (x 0, y 9, u 0, v 8, w 3): ") +
                           selvage_status_text(SELVAGE_ERROR_VERTEX_Q_DIFFERS) +
                           " (q is 1/w: leave w out, or --profile exact)");
}

TEST_F(Draw, SaysWhichOptionsWouldBeRight) {
  options_.filter = "area";
  options_.format = "rgb565";
  EXPECT_EQ(refusal(), std::string(selvage_status_text(SELVAGE_ERROR_FILTER_FORMAT)) +
                           " (--filter nearest, or --format rgba8888)");
  options_.format = "rgba8888";
  options_.profile = "dkit";
  options_.polygons = {"0,0,0,0 9,0,8,0 0,9,0,8"};
  EXPECT_EQ(refusal(), std::string(selvage_status_text(SELVAGE_ERROR_FILTER_PROFILE)) +
                           " (--filter nearest, or --profile exact)");
}

TEST_F(Draw, NamesTheFileThatIsWrong) {
  put("bad.json", "{\"vertices\": 3}");
  put("bad.png", "no picture");
  options_.texture = "none.png";
  EXPECT_EQ(refusal(), "cannot read 'none.png': No such file or directory");
  options_.texture = "bad.png";
  EXPECT_EQ(refusal(), "'bad.png': neither a PNG nor a JPEG picture");
  options_.texture = "texture.png";
  options_.background = "bad.png";
  EXPECT_EQ(refusal(), "'bad.png': neither a PNG nor a JPEG picture");
  options_.background = "#000";
  options_.polygons.clear();
  options_.polygon_file = "bad.json";
  EXPECT_EQ(refusal(), "bad.json:1: vertices: an array is needed, not 3");
}

TEST_F(Draw, NamesTheOptionThatIsWrong) {
  const auto refused = [&](std::string DrawOptions::*option, const char* value) {
    const std::string before = std::exchange(options_.*option, value);
    const std::string error = refusal();
    options_.*option = before;
    return error;
  };
  expect_contains(refused(&DrawOptions::size, "wide"), "--size: 'wide' is no size");
  expect_contains(refused(&DrawOptions::size, "99999x1"), "--size: a picture of 99999 x 1 px");
  EXPECT_EQ(refused(&DrawOptions::size, ""),
            "--size is needed, for the background is not a picture");
  expect_contains(refused(&DrawOptions::background, "#12"), "--background: '#12' is no colour");
  expect_contains(refused(&DrawOptions::clip, "1,2"), "--clip: '1,2' is no clip");
  expect_contains(refused(&DrawOptions::address, "mirror"), "--address: 'mirror' is no address");
  expect_contains(refused(&DrawOptions::filter, "cubic"), "--filter: 'cubic' is no filter");
  expect_contains(refused(&DrawOptions::format, "cmyk"), "--format: 'cmyk' is no format");
  options_.polygons = {kQuad, "1,2,3,4"};
  expect_contains(refusal(), "--polygon 2: a polygon needs at least 3 vertices; this one has 1");
  options_.polygons.clear();
  EXPECT_EQ(refusal(), "exactly one of --polygon and --polygon-file is needed");
}

TEST_F(Draw, RefusesAnOutputItCannotWrite) {
  std::filesystem::create_directory("folder.png");
  options_.output = "folder.png";
  expect_contains(refusal(), "'folder.png': it is a directory");
  options_.output = "nowhere/out.png";
  expect_contains(refusal(), "there is no directory 'nowhere'");
  for (const char* name : {"out.jpg", "out.txt", "out.apng", "out", ".png", "./-", "/dev/stdout"}) {
    options_.output = name;
    EXPECT_EQ(refusal(), "cannot write '" + std::string(name) +
                             "': the output is a PNG; name it .png, or - for the standard output");
  }
}

TEST_F(Draw, RefusesAStandardOutputThatCannotTakeThePicture) {
  options_.output = "-";
  std::ostringstream err;
  EXPECT_EQ(error_of([&] {
              (void)run_draw(options_, {.out = out_, .err = err, .out_is_terminal = true});
            }),
            "the standard output is a terminal, which shows no PNG; redirect it, or name a file in "
            "the place of -");
  options_.json = true;
  expect_contains(refusal(),
                  "cannot both go to the standard output; name a file in the place of -");
  EXPECT_EQ(out_.str(), "");
}

TEST_F(Draw, KeepsTheOldOutputWhenItFails) {
  put("out.png", "precious");
  options_.texture = "none.png";
  refusal();
  EXPECT_EQ(get("out.png"), "precious");
}

}  // namespace
}  // namespace selvage::cli::test
