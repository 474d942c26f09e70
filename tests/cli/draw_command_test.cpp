// What `selvage draw` draws and reports.
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "draw_files.h"

namespace selvage::cli::test {
namespace {

using Names = std::vector<std::string>;

// By selvage_draw itself, nothing of the program between.
[[nodiscard]] Raster drawn_directly(Raster target, Raster texture, const selvage_rect* clip,
                                    selvage_address address,
                                    const std::vector<selvage_vertex>& vertices,
                                    selvage_filter filter = SELVAGE_FILTER_NEAREST) {
  const selvage_image image{target.rgba.data(), target.width_px, target.height_px,
                            4 * ptrdiff_t{target.width_px}, SELVAGE_RGBA8888};
  const selvage_texture source{texture.rgba.data(),
                               texture.width_px,
                               texture.height_px,
                               4 * ptrdiff_t{texture.width_px},
                               SELVAGE_RGBA8888,
                               SELVAGE_LAYOUT_ROWS,
                               nullptr};
  selvage_options options{};
  options.filter = filter;
  options.address = address;
  EXPECT_EQ(selvage_draw(&image, clip, vertices.data(), vertices.size(), &source, &options),
            SELVAGE_OK);
  return target;
}

[[nodiscard]] selvage_vertex vertex(double x, double y, int u, int v, int q = SELVAGE_Q_MAX) {
  return {static_cast<int32_t>(x * 256), static_cast<int32_t>(y * 256), u * 65536, v * 65536, q};
}

const std::vector<selvage_vertex> kQuadVertices = {vertex(10, 10, 0, 0), vertex(100, 12.25, 24, 0),
                                                   vertex(90, 70, 24, 18), vertex(4, 60, 0, 18)};

TEST_F(Draw, WritesWhatTheMapperDraws) {
  EXPECT_EQ(run(), kExitFine);
  const Raster expected = drawn_directly(filled(120, 80, {0x20, 0x30, 0x40}), texture_, nullptr,
                                         SELVAGE_ADDRESS_CLAMP, kQuadVertices);
  EXPECT_EQ(output(), expected);
  EXPECT_NE(expected, filled(120, 80, {0x20, 0x30, 0x40}));
  EXPECT_EQ(out_.str(), "");
  EXPECT_EQ(files(), (Names{"out.png", "texture.png"}));
}

TEST_F(Draw, ClipsAndWrapsAsAsked) {
  options_.polygons = {"0,0,-30,-30,1 120,0,60,-30,2 120,80,60,60,2 0,80,-30,60,1"};
  options_.clip = "5,6,70,40";
  options_.address = "wrap";
  EXPECT_EQ(run(), kExitFine);
  const selvage_rect clip{5, 6, 70, 40};
  const int half = SELVAGE_Q_MAX / 2;
  EXPECT_EQ(output(), drawn_directly(filled(120, 80, {0x20, 0x30, 0x40}), texture_, &clip,
                                     SELVAGE_ADDRESS_WRAP,
                                     {vertex(0, 0, -30, -30), vertex(120, 0, 60, -30, half),
                                      vertex(120, 80, 60, 60, half), vertex(0, 80, -30, 60)}));
}

TEST_F(Draw, FiltersAsAsked) {
  std::vector<Raster> pictures;
  for (const auto& [name, filter] :
       {std::pair("nearest", SELVAGE_FILTER_NEAREST), std::pair("four", SELVAGE_FILTER_FOUR),
        std::pair("bilinear", SELVAGE_FILTER_BILINEAR), std::pair("area", SELVAGE_FILTER_AREA)}) {
    options_.polygons = {"0,0,-30,-30 20,0,60,-30 20,30,60,60 0,30,-30,60"};
    options_.filter = name;
    EXPECT_EQ(run(), kExitFine);
    pictures.push_back(output());
    EXPECT_EQ(pictures.back(), drawn_directly(filled(120, 80, {0x20, 0x30, 0x40}), texture_,
                                              nullptr, SELVAGE_ADDRESS_CLAMP,
                                              {vertex(0, 0, -30, -30), vertex(20, 0, 60, -30),
                                               vertex(20, 30, 60, 60), vertex(0, 30, -30, 60)},
                                              filter));
    for (size_t i = 0; i + 1 < pictures.size(); ++i) EXPECT_NE(pictures[i], pictures.back());
  }
  options_.format = "rgb565";
  expect_contains(refusal(), selvage_status_text(SELVAGE_ERROR_FILTER_FORMAT));
  options_.format = "rgba8888";
  options_.profile = "dkit";
  expect_contains(refusal(), selvage_status_text(SELVAGE_ERROR_FILTER_PROFILE));
}

TEST_F(Draw, DrawsOverAPictureOfItsSize) {
  const Raster background = sample_raster(120, 80, true);
  put("background.png", encode_png(background));
  options_.background = "background.png";
  for (const char* size : {"", "120x80"}) {
    options_.size = size;
    EXPECT_EQ(run(), kExitFine);
    EXPECT_EQ(output(),
              drawn_directly(background, texture_, nullptr, SELVAGE_ADDRESS_CLAMP, kQuadVertices));
  }
  options_.size = "120x81";
  EXPECT_EQ(error_of([&] { run(); }),
            "--size 120x81 is not the size of the background 'background.png', 120x80; leave "
            "--size out");
}

TEST_F(Draw, ReadsTheSamePolygonFromAFile) {
  run();
  const Raster expected = output();
  put("job.json", R"({"vertices": [[10,10,0,0],[100,12.25,24,0],{"x":90,"y":70,"u":24,"v":18},
                                   [4,60,0,18]]})");
  options_.polygons.clear();
  options_.polygon_file = "job.json";
  options_.output = "other.png";
  EXPECT_EQ(run(), kExitFine);
  EXPECT_EQ(decode_picture_file("other.png"), expected);
}

TEST_F(Draw, LetsTheCommandLineWinOverThePolygonFile) {
  put("job.json", R"({"vertices": [[0,0,-30,0],[120,0,60,0],[120,80,60,18]],
                      "clip": [0, 0, 1, 1], "address": "clamp"})");
  options_.polygons.clear();
  options_.polygon_file = "job.json";
  options_.clip = "0,0,120,80";
  options_.address = "wrap";
  run();
  EXPECT_EQ(
      output(),
      drawn_directly(filled(120, 80, {0x20, 0x30, 0x40}), texture_, nullptr, SELVAGE_ADDRESS_WRAP,
                     {vertex(0, 0, -30, 0), vertex(120, 0, 60, 0), vertex(120, 80, 60, 18)}));
}

TEST_F(Draw, DrawsSeveralPolygonsInOrder) {
  options_.polygons = {"0,0,0,0 120,0,1,0 120,80,1,1 0,80,0,1", kQuad};
  run();
  const Raster first = drawn_directly(
      filled(120, 80, {0x20, 0x30, 0x40}), texture_, nullptr, SELVAGE_ADDRESS_CLAMP,
      {vertex(0, 0, 0, 0), vertex(120, 0, 1, 0), vertex(120, 80, 1, 1), vertex(0, 80, 0, 1)});
  EXPECT_EQ(output(),
            drawn_directly(first, texture_, nullptr, SELVAGE_ADDRESS_CLAMP, kQuadVertices));
}

TEST_F(Draw, DrawsTheSameWithAnyNumberOfThreads) {
  options_.polygons = {"0,0,0,0 120,0,24,0 120,80,24,18 0,80,0,18", kQuad,
                       "60,-10,0,0 110,90,24,0 20,70,24,18"};
  options_.threads = 1;
  run();
  const Raster alone = output();
  for (const int32_t threads : {0, 2, 5}) {
    options_.threads = threads;
    EXPECT_EQ(run(), kExitFine);
    EXPECT_EQ(output(), alone) << threads;
  }
  options_.threads = -1;
  expect_contains(error_of([&] { run(); }), "--threads: -1 is no number of threads");
}

// Clips and options that differ take calls of their own.
TEST_F(Draw, DrawsEachPolygonOfAFileByItsOwnClipAndOptions) {
  put("job.json", R"({"polygons": [
      {"vertices": [[0,0,0,0],[120,0,24,0],[120,80,24,18],[0,80,0,18]], "clip": [0,0,60,80]},
      {"vertices": [[0,0,0,0],[120,0,24,0],[120,80,24,18],[0,80,0,18]], "clip": [60,0,120,80]},
      {"vertices": [[10,10,0,0],[110,10,90,0],[60,70,24,40]], "address": "wrap"},
      {"vertices": [[10,70,0,0],[110,70,90,0],[60,10,24,40]]}]})");
  options_.polygons.clear();
  options_.polygon_file = "job.json";
  EXPECT_EQ(run(), kExitFine);
  const Raster whole = drawn_directly(
      filled(120, 80, {0x20, 0x30, 0x40}), texture_, nullptr, SELVAGE_ADDRESS_CLAMP,
      {vertex(0, 0, 0, 0), vertex(120, 0, 24, 0), vertex(120, 80, 24, 18), vertex(0, 80, 0, 18)});
  const Raster wrapped =
      drawn_directly(whole, texture_, nullptr, SELVAGE_ADDRESS_WRAP,
                     {vertex(10, 10, 0, 0), vertex(110, 10, 90, 0), vertex(60, 70, 24, 40)});
  EXPECT_EQ(output(),
            drawn_directly(wrapped, texture_, nullptr, SELVAGE_ADDRESS_CLAMP,
                           {vertex(10, 70, 0, 0), vertex(110, 70, 90, 0), vertex(60, 10, 24, 40)}));
}

TEST_F(Draw, DrawsInTheOtherFormats) {
  options_.texture = "opaque.png";
  put("opaque.png", encode_png(sample_raster(24, 18, true)));
  run();
  const Raster full = output();
  for (const selvage_format format : {SELVAGE_RGB565, SELVAGE_INDEX8}) {
    options_.format = format_name(format);
    EXPECT_EQ(run(), kExitFine);
    // Nearest moves texels and computes none: reducing first or last is the same.
    EXPECT_EQ(output(), to_raster(to_bitmap(full, format)));
  }
}

TEST_F(Draw, WritesToTheStandardOutput) {
  EXPECT_EQ(run(), kExitFine);
  const std::vector<std::string> before = files();
  options_.output = "-";
  EXPECT_EQ(run(), kExitFine);
  EXPECT_EQ(out_.str(), get("out.png"));
  EXPECT_EQ(files(), before);
}

TEST_F(Draw, ReportsInJson) {
  options_.polygons = {"0,0,0,0 10,0,0,0 10,5,0,0 0,5,0,0", "5,0,0,0 15,0,0,0 15,5,0,0 5,5,0,0",
                       "119,0,0,0 500,0,0,0 500,2,0,0 119,2,0,0"};
  options_.json = true;
  run();
  const nlohmann::json report = nlohmann::json::parse(out_.str());
  EXPECT_EQ(report["output"], "out.png");
  EXPECT_EQ(report["width_px"], 120);
  EXPECT_EQ(report["height_px"], 80);
  EXPECT_EQ(report["format"], "rgba8888");
  EXPECT_EQ(report["polygons"], 3);
  EXPECT_EQ(report["covered_px"], 75 + 2);  // the first two share 25
  EXPECT_GT(report["draw_ns"], 0);
}

// Of a trapezoid's rows the short ones are exact: the method of the whole, by its order, says less.
TEST_F(Draw, TellsHowManyRowsAreDrawnByWhat) {
  options_.polygons = {"0,0,0,0,1 640,50,16,0,1.02 640,150,16,16,1.02 0,200,0,16,1"};
  options_.size = "640x300";
  options_.background = "#000";
  options_.json = true;
  options_.tolerance = "0.5";
  run();
  const nlohmann::json drawn_by = nlohmann::json::parse(out_.str())["methods"][0];
  EXPECT_EQ(drawn_by["method"], "exact perspective");
  EXPECT_GT(drawn_by["bound_texel"], 0);
  const auto rows = drawn_by["rows"].get<std::map<std::string, int>>();
  ASSERT_EQ(rows.size(), 2U) << drawn_by;
  EXPECT_GE(rows.at("affine for perspective"), 100);
  EXPECT_EQ(rows.at("affine for perspective") + rows.at("exact perspective"), 200);
}

TEST_F(Draw, TellsWhatIsDrawnByWithinATolerance) {
  options_.polygons = {"0,0,0,0,1 200,0,16,0,1.02 200,5,16,16,1.02 0,5,0,16,1",
                       "0,0,0,0 9,0,3,0 0,9,0,3"};
  options_.json = true;
  options_.tolerance = "0.5";
  run();
  const nlohmann::json report = nlohmann::json::parse(out_.str());
  const bool is_exact = selvage_has_kernel(SELVAGE_KERNEL_AVX512) != 0;  // it costs that less
  EXPECT_EQ(report["methods"][0]["method"],
            is_exact ? "exact perspective" : "affine for perspective");
  EXPECT_EQ(report["methods"][0]["segment_px"], 0);
  EXPECT_EQ(report["methods"][0]["bound_texel"] == 0, is_exact);
  EXPECT_LE(report["methods"][0]["bound_texel"], 0.5);
  EXPECT_EQ(report["methods"][1]["method"], "exact affine");
  EXPECT_EQ(report["methods"][1]["bound_texel"], 0);
  using Rows = std::map<std::string, int>;
  EXPECT_EQ(report["methods"][0]["rows"].get<Rows>(),
            (Rows{{is_exact ? "exact perspective" : "affine for perspective", 5}}));
  EXPECT_EQ(report["methods"][1]["rows"].get<Rows>().at("exact affine"), 8);
  options_.tolerance = "-1";
  EXPECT_THROW(run(), UserError);
  options_.tolerance = "0,5";
  EXPECT_THROW(run(), UserError);
}

TEST_F(Draw, TellsATerminalWhatItDoesAndWipesIt) {
  std::ostringstream err;
  EXPECT_EQ(run_draw(options_, {out_, err, true}), kExitFine);
  expect_contains(err.str(), "writing out.png");
  EXPECT_TRUE(err.str().ends_with("\r\x1b[K"));
}

// Coverage is counted whatever the filter, and the format that it wants.
TEST_F(Draw, ReportsThroughEachFilter) {
  options_.polygons = {"0,0,0,0 10,0,7,0 10,5,7,9 0,5,0,9"};
  options_.json = true;
  for (const char* filter : {"nearest", "four", "bilinear", "area"}) {
    options_.filter = filter;
    out_.str("");
    ASSERT_EQ(run(), kExitFine) << filter;
    EXPECT_EQ(nlohmann::json::parse(out_.str())["covered_px"], 50) << filter;
  }
}

TEST_F(Draw, TellsThatNothingWasDrawn) {
  EXPECT_EQ(run(), kExitFine);
  EXPECT_EQ(err_.str(), "");
  options_.clip = "0,0,5,5";
  EXPECT_EQ(run(), kExitFine);
  expect_contains(err_.str(),
                  "nothing was drawn: no polygon covers a visible pixel's sample point\n");
  options_.clip.clear();
  options_.polygons = {"10,10,0,0 4,60,0,18 90,70,24,18"};
  options_.profile = "abrash56";
  EXPECT_EQ(run(), kExitFine);
  expect_contains(err_.str(), "counter-clockwise, which this profile does not draw");
}

}  // namespace
}  // namespace selvage::cli::test
