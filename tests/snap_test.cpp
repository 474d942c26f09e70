#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "selvage.h"

namespace {

inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Snapped {
  selvage_status status;
  selvage_vertex vertex;
};

[[nodiscard]] Snapped snap(double x, double y, double u = 0, double v = 0, double w = 1,
                           double w_near = 1) {
  Snapped result{SELVAGE_OK, {7, 7, 7, 7, 7}};
  result.status = selvage_snap(x, y, u, v, w, w_near, &result.vertex);
  return result;
}

TEST(Snap, RoundsToTheGridHalvesUpward) {
  EXPECT_EQ(snap(1.5, -2.25).vertex.x, 384);
  EXPECT_EQ(snap(1.5, -2.25).vertex.y, -576);
  EXPECT_EQ(snap(0.5 / 256, -0.5 / 256).vertex.x, 1);
  EXPECT_EQ(snap(0.5 / 256, -0.5 / 256).vertex.y, 0);
  EXPECT_EQ(snap(std::nextafter(0.5, 0) / 256, 0).vertex.x, 0);
  EXPECT_EQ(snap(0, 0, 3.25, -0.5 / 65536).vertex.u, 212992);
  EXPECT_EQ(snap(0, 0, 3.25, -0.5 / 65536).vertex.v, 0);
}

TEST(Snap, TurnsDepthIntoQ) {
  EXPECT_EQ(snap(0, 0).vertex.q, SELVAGE_Q_MAX);
  EXPECT_EQ(snap(0, 0, 0, 0, 4, 1).vertex.q, SELVAGE_Q_MAX / 4);
  EXPECT_EQ(snap(0, 0, 0, 0, 0x1p24, 1).vertex.q, 1);
  EXPECT_EQ(snap(0, 0, 0, 0, 0x1p25, 1).vertex.q, 1);
  EXPECT_EQ(snap(0, 0, 0, 0, std::nextafter(0x1p25, 0x1p26), 1).status, SELVAGE_ERROR_SNAP_W);
  EXPECT_EQ(snap(0, 0, 0, 0, 1 - 0x1p-24, 1).status, SELVAGE_ERROR_SNAP_W);  // q = 2^24 + 1
  EXPECT_EQ(snap(0, 0, 0, 0, 1 - 0x1p-26, 1).vertex.q, SELVAGE_Q_MAX);
}

TEST(Snap, AcceptsTheEndsOfTheRange) {
  EXPECT_EQ(snap(-32768, -32768, -32768, -32768).vertex.x, SELVAGE_X_MIN);
  EXPECT_EQ(snap(-32768, -32768, -32768, -32768).vertex.u, INT32_MIN);
  EXPECT_EQ(snap(32768 - 1.0 / 256, 0, 32768 - 1.0 / 65536).vertex.x, SELVAGE_X_END - 1);
  EXPECT_EQ(snap(32768 - 1.0 / 256, 0, 32768 - 1.0 / 65536).vertex.u, INT32_MAX);
  EXPECT_EQ(snap(0, 32768 - 1.0 / 256, 0, 32768 - 1.0 / 65536).vertex.y, SELVAGE_X_END - 1);
  EXPECT_EQ(snap(0, 32768 - 1.0 / 256, 0, 32768 - 1.0 / 65536).vertex.v, INT32_MAX);
}

TEST(Snap, RefusesWhatHasNoVertex) {
  EXPECT_EQ(selvage_snap(0, 0, 0, 0, 1, 1, nullptr), SELVAGE_ERROR_SNAP_NULL);
  for (const double odd : {kNan, kInfinity, -kInfinity}) {
    EXPECT_EQ(snap(odd, 0).status, SELVAGE_ERROR_SNAP_NOT_FINITE);
    EXPECT_EQ(snap(0, odd).status, SELVAGE_ERROR_SNAP_NOT_FINITE);
    EXPECT_EQ(snap(0, 0, odd).status, SELVAGE_ERROR_SNAP_NOT_FINITE);
    EXPECT_EQ(snap(0, 0, 0, odd).status, SELVAGE_ERROR_SNAP_NOT_FINITE);
    EXPECT_EQ(snap(0, 0, 0, 0, odd).status, SELVAGE_ERROR_SNAP_NOT_FINITE);
    EXPECT_EQ(snap(0, 0, 0, 0, 1, odd).status, SELVAGE_ERROR_SNAP_NOT_FINITE);
  }
  for (const double far : {32768.0, 32768 - 0.4 / 256, -32768 - 0.6 / 256, 1e300, -1e300}) {
    EXPECT_EQ(snap(far, 0).status, SELVAGE_ERROR_SNAP_POSITION) << far;
    EXPECT_EQ(snap(0, far).status, SELVAGE_ERROR_SNAP_POSITION) << far;
  }
  for (const double far : {32768.0, -32769.0, 1e308}) {
    EXPECT_EQ(snap(0, 0, far).status, SELVAGE_ERROR_SNAP_TEXTURE) << far;
    EXPECT_EQ(snap(0, 0, 0, far).status, SELVAGE_ERROR_SNAP_TEXTURE) << far;
  }
  for (const double w : {0.0, -1.0, 0.5, 1e-320, 1e300}) {
    EXPECT_EQ(snap(0, 0, 0, 0, w, 1).status, SELVAGE_ERROR_SNAP_W) << w;
  }
  EXPECT_EQ(snap(0, 0, 0, 0, 1, 0).status, SELVAGE_ERROR_SNAP_W);
  EXPECT_EQ(snap(0, 0, 0, 0, -1, -1).status, SELVAGE_ERROR_SNAP_W);
}

TEST(Snap, LeavesTheVertexAloneOnAnError) {
  const Snapped refused = snap(kNan, 0);
  EXPECT_EQ(refused.vertex.x, 7);
  const Snapped late = snap(1, 1, 1, 1, -1, 1);
  EXPECT_EQ(late.vertex.x, 7);
}

}  // namespace
