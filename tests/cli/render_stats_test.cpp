// What `selvage render` tells by --explain and --stats.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>

#include "cli/job.h"
#include "cli/png.h"
#include "render_scene.h"

namespace selvage::cli::test {
namespace {

[[nodiscard]] bool is_kernel_here(const std::string& name) {
  for (selvage_kernel i = SELVAGE_KERNEL_SCALAR; i <= SELVAGE_KERNEL_NEON; ++i) {
    if (selvage_has_kernel(i) != 0 && kernel_name(i) == name) return true;
  }
  return false;
}

[[nodiscard]] std::string replaced_once(std::string text, const std::string& from,
                                        const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
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

// A wall of 1024 texels from 10 to 40 units away, alone or beside a triangle at 0.001, which leaves
// few bits of q to the wall.
class FarWall : public Render {
 protected:
  FarWall() {
    put("square.obj",
        std::string("mtllib square.mtl\nv -6 -9 -10\nv 24 -9 -40\nv 24 9 -40\nv -6 9 -10\nvt 0 0\n"
                    "vt 1024 0\nvt 1024 1\nvt 0 1\nusemtl red\nf 1/1 2/2 3/3 4/4\n"));
    put("square.mtl", std::string("newmtl red\nmap_Kd own.png\nillum 0\n"));
    put("own.png", encode_png(filled(1, 1, {0, 255, 0, 255})));
    put("near.obj", std::string("v -1e-5 0 -1e-3\nv 1e-5 0 -1e-3\nv 0 1e-5 -1e-3\nf 1 2 3\n"));
    options_.explain = options_.json = true;
  }

  static void put_scene(bool with_triangle) {
    const std::string triangle = with_triangle ? R"(, {"file": "near.obj"})" : "";
    put("scene.json",
        R"({"camera": {"position": [0, 0, 0], "target": [0, 0, -1], "nearest": 0.001,
                       "farthest": 1000},
            "tolerance": 0.25, "objects": [{"file": "square.obj"})" +
            triangle + "]}");
  }
  // What is told of the wall.
  nlohmann::json wall() {
    EXPECT_EQ(run(), kExitFine);
    const auto face = nlohmann::json::parse(out_.str())["faces"][0];
    out_.str("");
    EXPECT_EQ(face["bound_texel"], face["mapping_bound_texel"].get<double>() +
                                       face["rounding_bound_texel"].get<double>());
    return face;
  }
};

TEST_F(FarWall, IsWithinTheToleranceAlone) {
  put_scene(false);
  EXPECT_LE(wall()["bound_texel"], 0.25);
  EXPECT_EQ(err_.str(), "");
}

TEST_F(FarWall, TellsWhatRoundingDepthsCosts) {
  put_scene(true);
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

struct Square {
  double x, y, z, half;
  bool turned;
};

[[nodiscard]] std::string obj_of(std::span<const Square> squares) {
  std::string all = "mtllib square.mtl\nusemtl red\n";
  for (const Square& square : squares) {
    const double half = square.half;
    const double at[][2] = {{-half, -half}, {half, -half}, {half, half}, {-half, half}};
    for (const auto& corner : at) {
      all += "v " + std::to_string(square.x + corner[0]) + " " +
             std::to_string(square.y + corner[1]) + " " + std::to_string(square.z) + "\n";
    }
    all += square.turned ? "f -1 -2 -3 -4\n" : "f -4 -3 -2 -1\n";
  }
  return all;
}

// One object in the picture, one far beside it. Of each, in this order, squares: in front, behind
// it, behind half of it, turned away, aside of the picture, behind the eye, between pixels'
// centres.
class Squares : public Render {
 protected:
  Squares() {
    const Square squares[] = {{0, 0, 0, 1, false},     {0, 0, -0.5, 0.5, false},
                              {1, 0, -1, 0.5, false},  {0, 1, 0, 0.1, true},
                              {5, 0, 0, 0.5, false},   {0, 0, 5, 0.5, false},
                              {0, 1.5, 0, 0.01, false}};
    put("square.obj", obj_of(squares));
    put("scene.json",
        std::string(R"({"camera": {"position": [0, 0, 4], "view_deg": 53.13010235415598},
            "objects": [{"file": "square.obj"}, {"file": "square.obj", "position": [90, 0, 0]}]})"));
    options_.stats = options_.json = true;
  }
  nlohmann::json stats() {
    EXPECT_EQ(run(), kExitFine);
    return nlohmann::json::parse(out_.str())["stats"];
  }
};

TEST_F(Squares, AreCountedByWhatBecomesOfThem) {
  const auto stats = this->stats();
  EXPECT_EQ(stats["objects"], 2);
  EXPECT_EQ(stats["objects_culled"], 1);
  EXPECT_EQ(stats["faces"], 14);
  EXPECT_EQ(stats["faces_culled"], (nlohmann::json{{"with their object", 7},
                                                   {"clipped away", 1},
                                                   {"from behind", 1},
                                                   {"edge-on", 0},
                                                   {"off screen", 1},
                                                   {"refused", 0},
                                                   {"without a pixel", 2}}));
  EXPECT_EQ(stats["faces_drawn"], 2);
}

TEST_F(Squares, AreCountedByPixels) {
  const auto stats = this->stats();
  // The third is 12 px wide from column 46, the first ends at 55.
  const int pixels = 900 + 12 * (46 + 12 - 55);
  ASSERT_EQ(stats["drawn_by"].size(), 1U);
  const auto& way = stats["drawn_by"][0];
  EXPECT_EQ(way["method"], "exact affine");
  EXPECT_EQ(way["filter"], "nearest");
  EXPECT_TRUE(is_kernel_here(way["kernel"])) << way["kernel"];
  EXPECT_EQ(way["faces"], 2);
  EXPECT_EQ(way["pixels"], pixels);
  EXPECT_EQ(stats["draw_calls"], 2);
  EXPECT_EQ(stats["pixels_written"], pixels);
  EXPECT_EQ(stats["pixels_shown"], pixels);
  EXPECT_GT(stats["draw_ns"], 0);
  EXPECT_DOUBLE_EQ(stats["draw_ns_per_pixel"], stats["draw_ns"].get<double>() / pixels);
}

// A filter does not hide what the map is; area has no kernels.
TEST_F(Render, CountsByMapFilterAndKernel) {
  put("square.obj",
      std::string(
          "mtllib square.mtl\nv -3 -1 0\nv -1 -1 0\nv -1 1 0\nv -3 1 0\nv 0 -1 0\nv 2 -1 -3\n"
          "v 2 1 -3\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl red\n"
          "f 1/1 2/2 3/3 4/4\nf 5/1 6/2 7/3 8/4\n"));
  put("square.mtl", std::string("newmtl red\nmap_Kd own.png\n"));
  put("own.png", encode_png(filled(64, 64, {0, 255, 0, 255})));
  options_.stats = options_.json = true;
  for (const char* filter : {"nearest", "four", "bilinear", "area"}) {
    options_.filter = filter;
    EXPECT_EQ(run(), kExitFine);
    const auto drawn_by = nlohmann::json::parse(out_.str())["stats"]["drawn_by"];
    out_.str("");
    ASSERT_EQ(drawn_by.size(), 2U);
    EXPECT_EQ(drawn_by[0]["method"], "exact affine");
    EXPECT_EQ(drawn_by[1]["method"], "exact perspective");
    for (const auto& way : drawn_by) {
      EXPECT_EQ(way["filter"], filter);
      EXPECT_EQ(way["faces"], 1);
      EXPECT_TRUE(is_kernel_here(way["kernel"])) << way["kernel"];
    }
  }
}

// A texture in a light is copied with that light, where it is reached; drawing is without that.
TEST_F(Render, TellsWhatLightingCosts) {
  put("square.obj", std::string("mtllib square.mtl\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nvt 0 0\nvt 1 0\n"
                                "vt 1 1\nusemtl red\nf 1/1 2/2 3/3\n"));
  put("own.png", encode_png(filled(1024, 1024, {200, 100, 50, 255})));
  options_.filter = "nearest";
  options_.stats = options_.json = true;
  const auto stats_with = [&](const std::string& illum) {
    put("square.mtl", "newmtl red\nmap_Kd own.png\nillum " + illum + "\n");
    put("scene.json", replaced_once(kSquareScene, "\"background\"",
                                    "\"ambient\": [0.5, 0.5, 0.5], \"background\""));
    EXPECT_EQ(run(), kExitFine);
    const auto stats = nlohmann::json::parse(out_.str())["stats"];
    out_.str("");
    return stats;
  };
  EXPECT_EQ(stats_with("0")["light_ns"], 0);
  const auto lit = stats_with("1");
  EXPECT_EQ(picture("out.png").at(50, 40), (Colour{100, 50, 25, 255}));
  EXPECT_GT(lit["light_ns"], 0);
  EXPECT_GT(lit["draw_ns"], 0);
}

// A texture that is repeated often, far minified: all of it lies under each box.
TEST_F(Render, TellsWhatSumsCost) {
  put("square.obj", std::string("mtllib square.mtl\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nvt 0 0\nvt 40 0\n"
                                "vt 40 40\nusemtl red\nf 1/1 2/2 3/3\n"));
  put("square.mtl", "newmtl red\nmap_Kd own.png\nillum 0\n");
  put("own.png", encode_png(filled(32, 32, {200, 100, 50, 255})));
  options_.stats = options_.json = true;
  const auto stats_with = [&](const std::string& filter) {
    options_.filter = filter;
    EXPECT_EQ(run(), kExitFine);
    const auto stats = nlohmann::json::parse(out_.str())["stats"];
    out_.str("");
    EXPECT_EQ(picture("out.png").at(50, 40), (Colour{200, 100, 50, 255}));
    return stats;
  };
  EXPECT_EQ(stats_with("nearest")["sums_ns"], 0);
  const auto summed = stats_with("auto");
  EXPECT_GT(summed["sums_ns"], 0);
  EXPECT_GT(summed["draw_ns"], 0);
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

TEST_F(FarWall, IsToldOfInALineAndTheTriangleInASum) {
  put_scene(true);
  options_.json = false;
  EXPECT_EQ(run(), kExitFine);
  const std::string told = out_.str();
  EXPECT_EQ(told.rfind("square face 1: ", 0), 0u) << told;
  expect_contains(told, ", rounding 0.612); depths 1:4, affine ");
  EXPECT_EQ(std::count(told.begin(), told.end(), '\n'), 2);
  expect_contains(told, "\n1 face of one colour: any map will do\n");
}

TEST_F(Render, TellsPeopleTheSame) {
  options_.explain = options_.stats = true;
  EXPECT_EQ(run(), kExitFine);
  EXPECT_EQ(out_.str().rfind("1 face of one colour: any map will do\n", 0), 0u) << out_.str();
  expect_contains(out_.str(), "faces_drawn: 1\n");
  expect_contains(out_.str(), "faces_culled:\n  with their object: 0\n");
  expect_contains(out_.str(), "drawn_by:\n  exact affine, nearest, kernel ");
  expect_contains(out_.str(), ": 1 faces, 900 pixels\n");
  expect_contains(out_.str(), "light_ns: 0\n");
  expect_contains(out_.str(), "sums_ns: 0\n");
  expect_contains(out_.str(), "pixels_written: 900\n");
}

}  // namespace
}  // namespace selvage::cli::test
