// OpenCV as an oracle: equality on every pixel that it decides, and few that it does not.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <iostream>
#include <string>

#include "spec/oracle.h"

namespace selvage::spec {
namespace {

inline constexpr double kMostUndecided = 0.01;

struct Spread {
  int32_t q_least, q_end;
  selvage_format format;
  selvage_address address;
};

// A triangle over a target of 40 x 30 px with random coordinates: no special positions, so that
// ties are as rare as chance makes them.
[[nodiscard]] Case random_map(const Spread& spread) {
  Case c;
  c.format = spread.format;
  c.address = spread.address;
  c.target_width_px = 40;
  c.target_height_px = 30;
  c.texture_width_texel = 61;
  c.texture_height_texel = 47;
  for (int i = 0; i < 3; ++i) {
    const auto within = [](int32_t least, int32_t end) {
      return *rc::gen::noShrink(rc::gen::resize(rc::kNominalSize, rc::gen::inRange(least, end)));
    };
    c.vertices.push_back({within(-10 * 256, 50 * 256), within(-10 * 256, 40 * 256),
                          within(-100 * 65536, 160 * 65536), within(-100 * 65536, 160 * 65536),
                          within(spread.q_least, spread.q_end)});
  }
  return c;
}

void agree(const std::string& what, const Spread& spread) {
  uint64_t decided = 0, undecided = 0;
  const bool holds = rc::check(what, [&] {
    const OracleTally tally = ask_opencv(built_in(), random_map(spread));
    decided += tally.decided_px;
    undecided += tally.undecided_px;
    if (tally.violation) RC_FAIL(explain(*tally.violation));
  });
  EXPECT_TRUE(holds);
  const double share = static_cast<double>(undecided) / static_cast<double>(decided + undecided);
  std::cout << what << ": " << decided << " px decided, " << undecided << " undecided ("
            << 100 * share << " %)\n";
  EXPECT_GT(decided, 10000U);
  EXPECT_LT(share, kMostUndecided);
}

TEST(Oracle, TellsWhichOpenCvItIs) {
  const std::string build = opencv_build();
  std::cout << build.substr(0, 1500) << "\n";
  EXPECT_NE(build.find("OpenCV"), std::string::npos);
}

TEST(Oracle, WarpAffineAgrees) {
  agree("warpAffine, RGBA8888, clamp", {1, 2, SELVAGE_RGBA8888, SELVAGE_ADDRESS_CLAMP});
}

TEST(Oracle, WarpAffineAgreesWhereTexturesRepeat) {
  agree("warpAffine, RGB565, wrap", {1, 2, SELVAGE_RGB565, SELVAGE_ADDRESS_WRAP});
}

TEST(Oracle, WarpPerspectiveAgrees) {
  agree("warpPerspective, RGBA8888, clamp", {1, 100, SELVAGE_RGBA8888, SELVAGE_ADDRESS_CLAMP});
}

TEST(Oracle, WarpPerspectiveAgreesOverExtremeDepths) {
  agree("warpPerspective, INDEX8, wrap, q to 2^24",
        {1, SELVAGE_Q_MAX + 1, SELVAGE_INDEX8, SELVAGE_ADDRESS_WRAP});
}

}  // namespace
}  // namespace selvage::spec
