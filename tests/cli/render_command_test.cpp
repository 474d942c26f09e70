// Pictures of scenes.
#include "cli/render_command.h"

#include <filesystem>

#include "cli/apng.h"
#include "cli/png.h"
#include "render_scene.h"

namespace selvage::cli::test {
namespace {

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

TEST_F(Render, WritesOneFrameToTheStandardOutput) {
  EXPECT_EQ(run(), kExitFine);
  options_.output = "-";
  EXPECT_EQ(run(), kExitFine);
  EXPECT_EQ(out_.str(), get("out.png"));
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
  const std::string all_frames = "--time: all frames must lie within 1000000000 s of 0";
  expect(all_frames, [](RenderOptions& o) { o.start_s = -1e300; });
  expect(all_frames, [](RenderOptions& o) {
    o.frames = 2;
    o.frames_per_s = 1e-10;
  });
  expect("--size: a picture of 20000 x 10 px is not accepted; 1 to 16384 px a side",
         [](RenderOptions& o) { o.size = "20000x10"; });
  expect("--size: a picture of 40000 x 10 px is not accepted; 1 to 16384 px a side",
         [](RenderOptions& o) { o.size = "40000x10"; });
  expect("--filter: 'best' is no filter; auto, nearest, four, bilinear and area are",
         [](RenderOptions& o) { o.filter = "best"; });
  expect("--json: it prints what --explain and --stats tell; give one of them too",
         [](RenderOptions& o) { o.json = true; });
  expect("--hidden", [](RenderOptions& o) { o.hidden = "magic"; });
  expect("--tolerance", [](RenderOptions& o) { o.tolerance = "-1"; });
  for (const char* name : {"out.jpg", "out", "/dev/stdout"}) {
    expect("name it .png or .apng, or - for a PNG on the standard output",
           [&](RenderOptions& o) { o.output = name; });
  }
  expect("--frames 1 is right with -o -", [](RenderOptions& o) {
    o.output = "-";
    o.frames = 2;
  });
  expect("cannot both go to the standard output", [](RenderOptions& o) {
    o.output = "-";
    o.stats = true;
  });
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
