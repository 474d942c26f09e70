#include "cli/render_command.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/apng.h"
#include "cli/png.h"
#include "support.h"

namespace selvage::cli::test {
namespace {

// A square of 2 by 2 in front of the camera, of one colour as it is.
constexpr const char* kSquare =
    "mtllib square.mtl\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nusemtl red\nf 1 2 3 4\n";
constexpr const char* kScene =
    R"({"camera": {"position": [0, 0, 4], "view_deg": 53.13010235415598},
        "background": "#000040", "objects": [{"file": "square.obj", "velocity": [1, 0, 0]}]})";

class Render : public InDirectory {
 protected:
  Render() {
    put("square.obj", std::string(kSquare));
    put("square.mtl", std::string("newmtl red\nKd 1 0 0\nillum 0\n"));
    put("scene.json", std::string(kScene));
    options_.scene = "scene.json";
    options_.output = "out.png";
    options_.size = "80x60";
  }

  int run() {
    err_.str("");
    return run_render(options_, {out_, err_});
  }
  [[nodiscard]] static Raster picture(const std::string& name) {
    const std::string bytes = get(name);
    return decode_png(std::span(reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size()));
  }
  [[nodiscard]] static int red_pixels(const Raster& raster) {
    int count = 0;
    for (int32_t y = 0; y < raster.height_px; ++y) {
      for (int32_t x = 0; x < raster.width_px; ++x)
        count += raster.at(x, y) == Colour{255, 0, 0, 255};
    }
    return count;
  }

  RenderOptions options_;
  std::ostringstream out_, err_;
};

// At distance 4 a picture 60 px high shows 4 units: the square is 30 px wide, in the middle.
TEST_F(Render, DrawsTheSceneToItsScale) {
  EXPECT_EQ(run(), kExitFine);
  const Raster raster = picture("out.png");
  EXPECT_EQ(raster.width_px, 80);
  EXPECT_EQ(raster.height_px, 60);
  EXPECT_EQ(red_pixels(raster), 30 * 30);
  EXPECT_EQ(raster.at(25, 15), (Colour{255, 0, 0, 255}));
  EXPECT_EQ(raster.at(54, 44), (Colour{255, 0, 0, 255}));
  EXPECT_EQ(raster.at(24, 15), (Colour{0, 0, 0x40, 255}));
}

TEST_F(Render, DrawsFramesOfMovingObjects) {
  options_.frames = 3;
  options_.frames_per_s = 15;  // a fifteenth of a unit, one pixel, a frame
  EXPECT_EQ(run(), kExitFine);
  for (const int32_t frame : {0, 1, 2}) {
    const Raster raster = picture("out-0000" + std::to_string(frame + 1) + ".png");
    EXPECT_EQ(raster.at(24 + frame, 30), (Colour{0, 0, 0x40, 255}));
    EXPECT_EQ(raster.at(25 + frame, 30), (Colour{255, 0, 0, 255}));
  }
}

// The same pictures as those in files of their own (apng_test.cpp takes animations apart).
TEST_F(Render, AnimatesFrames) {
  options_.frames = 3;
  EXPECT_EQ(run(), kExitFine);
  Apng expected(3, {1, 25});
  for (const char* frame : {"out-00001.png", "out-00002.png", "out-00003.png"}) {
    expected.add(picture(frame));
    std::filesystem::remove(frame);
  }
  options_.output = "out.apng";
  EXPECT_EQ(run(), kExitFine);
  const std::string bytes = get("out.apng");
  EXPECT_EQ(std::vector<uint8_t>(bytes.begin(), bytes.end()), expected.finish());
  EXPECT_EQ(files(),
            (std::vector<std::string>{"out.apng", "scene.json", "square.mtl", "square.obj"}));
}

TEST_F(Render, TakesAnotherTexture) {
  put("square.obj", std::string("mtllib square.mtl\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nvt 0 0\nvt 1 0\n"
                                "vt 1 1\nusemtl red\nf 1/1 2/2 3/3\n"));
  put("square.mtl", std::string("newmtl red\nmap_Kd own.png\n"));
  put("own.png", encode_png(filled(2, 2, {0, 255, 0, 255})));
  put("other.png", encode_png(filled(5, 3, {255, 0, 0, 255})));
  EXPECT_EQ(run(), kExitFine);
  EXPECT_EQ(red_pixels(picture("out.png")), 0);
  options_.textures = {"red=other.png"};
  EXPECT_EQ(run(), kExitFine);
  EXPECT_GT(red_pixels(picture("out.png")), 400);
  std::filesystem::remove("own.png");  // is not even read
  EXPECT_EQ(run(), kExitFine);
  put("own.png", encode_png(filled(2, 2, {0, 255, 0, 255})));
  options_.textures = {"blue=other.png"};
  expect_contains(error_of([&] { run(); }), "'blue' is no material with a texture; these are: red");
  options_.textures = {"red=none.png"};
  expect_contains(error_of([&] { run(); }), "none.png");
}

TEST_F(Render, ExplainsAndCounts) {
  options_.explain = options_.stats = options_.json = true;
  EXPECT_EQ(run(), kExitFine);
  const auto told = nlohmann::json::parse(out_.str());
  ASSERT_EQ(told["faces"].size(), 1U);
  EXPECT_EQ(told["faces"][0]["object"], "square");
  EXPECT_EQ(told["faces"][0]["bound_texel"], 0);
  EXPECT_EQ(told["stats"]["faces_drawn"], 1);
  EXPECT_EQ(told["stats"]["pixels_written"], 900);
}

// A wall of 1024 texels from 10 to 40 units away, beside a triangle at 0.001: few bits of q are
// left to the wall.
TEST_F(Render, TellsWhatRoundingDepthsCosts) {
  put("square.obj",
      std::string("mtllib square.mtl\nv -6 -9 -10\nv 24 -9 -40\nv 24 9 -40\nv -6 9 -10\nvt 0 0\n"
                  "vt 1024 0\nvt 1024 1\nvt 0 1\nusemtl red\nf 1/1 2/2 3/3 4/4\n"));
  put("square.mtl", std::string("newmtl red\nmap_Kd own.png\nillum 0\n"));
  put("own.png", encode_png(filled(1, 1, {0, 255, 0, 255})));
  put("near.obj", std::string("v -1e-5 0 -1e-3\nv 1e-5 0 -1e-3\nv 0 1e-5 -1e-3\nf 1 2 3\n"));
  const auto scene = [](const std::string& more) {
    return R"({"camera": {"position": [0, 0, 0], "target": [0, 0, -1], "nearest": 0.001,
                          "farthest": 1000},
               "tolerance": 0.25, "objects": [{"file": "square.obj"})" +
           more + "]}";
  };
  options_.explain = options_.json = true;
  const auto wall = [&] {
    EXPECT_EQ(run(), kExitFine);
    const auto face = nlohmann::json::parse(out_.str())["faces"][0];
    out_.str("");
    EXPECT_EQ(face["bound_texel"], face["mapping_bound_texel"].get<double>() +
                                       face["rounding_bound_texel"].get<double>());
    return face;
  };
  put("scene.json", scene(""));
  EXPECT_LE(wall()["bound_texel"], 0.25);
  EXPECT_EQ(err_.str(), "");
  put("scene.json", scene(R"(, {"file": "near.obj"})"));
  const auto face = wall();
  // q of the far side is 2^24 0.001 / 40 = 419: half of 1024 texels times 1 / (2 * 419 - 2).
  EXPECT_NEAR(face["rounding_bound_texel"], 512.0 / 836, 1e-3);
  EXPECT_EQ(face["mapping_bound_texel"], 0);
  expect_contains(face["reason"], "rounding depths alone may cost more than 0.25 texel");
  expect_contains(err_.str(),
                  "warning: rounding depths to whole q may move the texture of 1 face by "
                  "more than 0.25 texel, that of square face 1 by up to 0.612");
  const std::string warned = err_.str();
  EXPECT_EQ(std::count(warned.begin(), warned.end(), '\n'), 1);
  options_.tolerance = "1";
  EXPECT_LE(wall()["bound_texel"], 1);
  EXPECT_EQ(err_.str(), "");
  options_.tolerance = "0";
  (void)wall();
  expect_contains(err_.str(), "by more than 0.0625 texel");
}

// Squares: in front, behind it, behind half of it, turned away, aside of the picture in an object
// that reaches into it, in one that does not, behind the eye; and one between pixels' centres.
TEST_F(Render, CountsWhatBecomesOfEveryFace) {
  std::string all = "mtllib square.mtl\nusemtl red\n";
  const auto square = [&](double x, double y, double z, double half, bool turned) {
    const double at[][2] = {{-half, -half}, {half, -half}, {half, half}, {-half, half}};
    for (const auto& corner : at) {
      all += "v " + std::to_string(x + corner[0]) + " " + std::to_string(y + corner[1]) + " " +
             std::to_string(z) + "\n";
    }
    all += turned ? "f -1 -2 -3 -4\n" : "f -4 -3 -2 -1\n";
  };
  square(0, 0, 0, 1, false);
  square(0, 0, -0.5, 0.5, false);
  square(1, 0, -1, 0.5, false);
  square(0, 1, 0, 0.1, true);
  square(5, 0, 0, 0.5, false);
  square(0, 0, 5, 0.5, false);
  square(0, 1.5, 0, 0.01, false);
  put("square.obj", all);
  put("scene.json",
      std::string(R"({"camera": {"position": [0, 0, 4], "view_deg": 53.13010235415598},
          "objects": [{"file": "square.obj"}, {"file": "square.obj", "position": [90, 0, 0]}]})"));
  options_.stats = options_.json = true;
  EXPECT_EQ(run(), kExitFine);
  const auto stats = nlohmann::json::parse(out_.str())["stats"];
  EXPECT_EQ(stats["objects"], 2);
  EXPECT_EQ(stats["objects_culled"], 1);
  EXPECT_EQ(stats["faces"], 14);
  EXPECT_EQ(stats["faces_culled"], (nlohmann::json{{"with their object", 7},
                                                   {"clipped away", 1},
                                                   {"from behind", 1},
                                                   {"off screen", 1},
                                                   {"refused", 0},
                                                   {"without a pixel", 2}}));
  EXPECT_EQ(stats["faces_drawn"], 2);
  // The third is 12 px wide from column 46, the first ends at 55.
  const int pixels = 900 + 12 * (46 + 12 - 55);
  EXPECT_EQ(stats["drawn_by"],
            (nlohmann::json{{"exact affine", {{"faces", 2}, {"pixels", pixels}}}}));
  EXPECT_EQ(stats["draw_calls"], 2);
  EXPECT_EQ(stats["pixels_written"], pixels);
  EXPECT_EQ(stats["pixels_shown"], pixels);
  EXPECT_GT(stats["draw_ns"], 0);
  EXPECT_DOUBLE_EQ(stats["draw_ns_per_pixel"], stats["draw_ns"].get<double>() / pixels);
}

// Painter's order draws the hidden one too, and its pixels twice.
TEST_F(Render, CountsWhatIsPaintedOver) {
  put("square.obj", kSquare + std::string("v -1 -1 -4\nv 1 -1 -4\nv 1 1 -4\nv -1 1 -4\n"
                                          "f 5 6 7 8\n"));
  options_.hidden = "painter";
  options_.stats = options_.json = true;
  EXPECT_EQ(run(), kExitFine);
  const auto stats = nlohmann::json::parse(out_.str())["stats"];
  EXPECT_EQ(stats["faces_drawn"], 2);
  EXPECT_EQ(stats["pixels_written"], 900 + 15 * 15);
  EXPECT_EQ(stats["pixels_shown"], 900);
}

// Corners half way between two rows of the grid: the face is drawn as triangles, and is one face.
TEST_F(Render, CountsFacesAndNotTheirTriangles) {
  std::string bent = "mtllib square.mtl\nusemtl red\n";
  for (int i = 0; i < 5; ++i) {
    bent +=
        "v " + std::to_string(1 - i * 0.5) + (i % 2 ? " 0.99607421876 0\n" : " 0.99607421874 0\n");
  }
  put("square.obj", bent + "v -1 -0.5 0\nv 1 -0.5 0\nf 1 2 3 4 5 6 7\n");
  put("scene.json", std::string(R"({"camera": {"position": [0, 0, 1], "view_deg": 90},
                                    "objects": [{"file": "square.obj"}]})"));
  options_.size = "320x200";
  options_.frames = 2;
  options_.stats = options_.json = true;
  EXPECT_EQ(run(), kExitFine);
  const auto stats = nlohmann::json::parse(out_.str())["stats"];
  EXPECT_EQ(stats["faces"], 2);  // one a frame
  EXPECT_EQ(stats["faces_drawn"], 2);
  EXPECT_GT(stats["draw_calls"], 2);
  EXPECT_EQ(stats["pixels_written"], 2 * 200 * 150);
}

TEST_F(Render, TellsPeopleTheSame) {
  options_.explain = options_.stats = true;
  EXPECT_EQ(run(), kExitFine);
  expect_contains(out_.str(), "square face 1: ");
  expect_contains(out_.str(), "one colour");
  expect_contains(out_.str(), "faces_drawn: 1\n");
  expect_contains(out_.str(), "faces_culled:\n  with their object: 0\n");
  expect_contains(out_.str(), "drawn_by:\n  exact affine: 1 faces, 900 pixels\n");
  expect_contains(out_.str(), "pixels_written: 900\n");
}

TEST_F(Render, HidesEitherWay) {
  for (const char* way : {"painter", "scan-line"}) {
    options_.hidden = way;
    EXPECT_EQ(run(), kExitFine);
    EXPECT_EQ(red_pixels(picture("out.png")), 900);
  }
}

TEST_F(Render, RefusesWhatCannotBe) {
  const auto expect = [&](const std::string& words, auto&& spoil) {
    const RenderOptions before = options_;
    spoil(options_);
    expect_contains(error_of([&] { run(); }), words);
    options_ = before;
    for (const std::string& file : files()) EXPECT_EQ(file.find(".png"), std::string::npos) << file;
  };
  expect("--frames", [](RenderOptions& o) { o.frames = 0; });
  expect("--rate", [](RenderOptions& o) { o.frames_per_s = 0; });
  expect("--size", [](RenderOptions& o) { o.size = "20000x10"; });
  expect("--filter", [](RenderOptions& o) { o.filter = "best"; });
  expect("--hidden", [](RenderOptions& o) { o.hidden = "magic"; });
  expect("--tolerance", [](RenderOptions& o) { o.tolerance = "-1"; });
  expect("name it .png or .apng", [](RenderOptions& o) { o.output = "out.jpg"; });
  expect("--rate: an animated PNG shows", [](RenderOptions& o) {
    o.output = "out.apng";
    o.frames_per_s = 1e6;
  });
  expect("--texture: 'earth': MATERIAL=FILE", [](RenderOptions& o) { o.textures = {"earth"}; });
  expect("--texture: 'a' stands twice", [](RenderOptions& o) { o.textures = {"a=b", "a=c"}; });
  expect("none.json", [](RenderOptions& o) { o.scene = "none.json"; });
}

}  // namespace
}  // namespace selvage::cli::test
