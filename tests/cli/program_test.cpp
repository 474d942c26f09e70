// The program itself, run as a user runs it: SELVAGE_PROGRAM is its path.
#include <sys/wait.h>

#include <cstdlib>
#include <random>

#include "cli/picture_file.h"
#include "cli/png.h"
#include "sample_pictures.h"
#include "support.h"

namespace selvage::cli::test {
namespace {

using Names = std::vector<std::string>;

class Program : public InDirectory {
 protected:
  // Through the shell; leaves what was printed in the files "out" and "err".
  static int run(const std::string& arguments, const std::string& out = "out",
                 const std::string& before = "") {
    const std::string command =
        before + "'" SELVAGE_PROGRAM "' " + arguments + " > " + out + " 2> err";
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
};

TEST_F(Program, HelpsAndTellsItsVersion) {
  EXPECT_EQ(run("--version"), 0);
  expect_contains(get("out"), "selvage ");
  EXPECT_EQ(run("draw --help"), 0);
  expect_contains(get("out"), "--texture");
  EXPECT_EQ(get("err"), "");
}

TEST_F(Program, ExitsWithTwoOnWrongUse) {
  for (const char* arguments :
       {"", "paint", "draw", "draw --polygon", "verify --law NOPE", "verify --cases 0",
        "verify --case 123", "laws --colour",
        "draw --texture none.png --polygon '0,0,0,0 1,0,0,0 0,1,0,0' --size 4x4 -o out.png"}) {
    EXPECT_EQ(run(arguments), 2) << arguments;
    EXPECT_EQ(get("out"), "") << arguments;
    EXPECT_EQ(get("err").rfind("selvage: ", 0), 0u) << arguments;
  }
  EXPECT_EQ(files(), (Names{"err", "out"}));
}

TEST_F(Program, DrawsAJpegOverAPng) {
  put("texture.jpg", encode_jpeg(smooth_raster(32, 32), JpegKind::kProgressive));
  put("background.png", encode_png(filled(64, 48, {0, 0, 0})));
  EXPECT_EQ(run("draw --texture texture.jpg --background background.png -o drawn.png --json "
                "--polygon '8,4,0,0 56,8,32,0,2 50,40,32,32 10,44,0,32'"),
            0);
  expect_contains(get("out"), "\"covered_px\": ");
  const Raster drawn = read_picture("drawn.png");
  EXPECT_EQ(drawn.width_px, 64);
  EXPECT_EQ(drawn.at(0, 0), (Colour{0, 0, 0}));
  EXPECT_NE(drawn.at(30, 24), (Colour{0, 0, 0}));
}

TEST_F(Program, WritesAPictureToItsOutputAndOverNothing) {
  put("texture.png", encode_png(filled(2, 2, {})));
  const std::string draw =
      "draw --texture texture.png --size 8x8 --polygon '0,0,0,0 8,0,2,0 0,8,0,2' -o ";
  EXPECT_EQ(run(draw + "drawn.png"), 0);
  EXPECT_EQ(run(draw + "-"), 0);
  EXPECT_EQ(get("out"), get("drawn.png"));
  put("out.png", std::string("kept"));
  for (const char* name : {"/dev/stdout", "out.png"}) {
    EXPECT_EQ(run(draw + name, "/dev/null >> out.png"), 2);
    expect_contains(get("err"), std::string("cannot write '") + name);
    EXPECT_EQ(get("out.png"), "kept");
  }
}

TEST_F(Program, Verifies) {
  EXPECT_EQ(run("verify --cases 40 --seed 1"), 0) << get("out") << get("err");
  expect_contains(get("out"), "laws hold.");
  EXPECT_EQ(get("err"), "");
}

TEST_F(Program, SaysThatItsOutputIsFull) {
  EXPECT_EQ(run("laws", "/dev/full"), 2);
  expect_contains(get("err"), "selvage: cannot write to the standard output");
}

// The limit is in blocks of 512 or 1024 bytes; the picture is noise of 4 MiB.
TEST_F(Program, SaysThatItsFilesMayNotGrowSoFar) {
  put("texture.png", encode_png(filled(1, 1, {})));
  std::mt19937 random(1);
  Raster noise = filled(1024, 1024, {});
  for (uint8_t& byte : noise.rgba) byte = static_cast<uint8_t>(random());
  put("noise.png", encode_png(noise));
  const std::string draw =
      "draw --texture texture.png --background noise.png -o drawn.png --polygon '0,0,0,0 1,0,0,0 "
      "0,1,0,0'";
  EXPECT_EQ(run(draw, "out", "ulimit -f 2048; "), 2);
  // A build that measures coverage cannot write that either, and says so behind it.
  EXPECT_EQ(get("err").rfind("selvage: cannot write 'drawn.png': File too large\n", 0), 0u);
  EXPECT_EQ(files(), (Names{"err", "noise.png", "out", "texture.png"}));
  EXPECT_EQ(run(draw), 0);  // what would be right
}

}  // namespace
}  // namespace selvage::cli::test
