#include <gtest/gtest.h>

#include <array>
#include <cstring>

#include "selvage.h"
#include "spec/vertex_units.h"

namespace selvage {
namespace {

using spec::kTexel_fx16;

[[nodiscard]] std::array<selvage_vertex, 4> corners() {
  return {selvage_vertex{27 * 256, 13 * 256, 1, 2, 3},
          {20 * 256, 30 * 256, 4, 5, 6},
          {6 * 256, 20 * 256, 7, 8, 9},
          {15 * 256, 10 * 256, 10, 11, 12}};
}

void expect_corner(const selvage_vertex& fitted, const selvage_vertex& from, int32_t u_texel,
                   int32_t v_texel) {
  EXPECT_EQ(fitted.x, from.x);
  EXPECT_EQ(fitted.y, from.y);
  EXPECT_EQ(fitted.q, from.q);
  EXPECT_EQ(fitted.u, u_texel * kTexel_fx16);
  EXPECT_EQ(fitted.v, v_texel * kTexel_fx16);
}

TEST(Fit, PutsTheWholeTextureOnFourCorners) {
  const auto from = corners();
  std::array<selvage_vertex, 4> fitted{};
  ASSERT_EQ(selvage_fit(from.data(), 4, 99, 60, 20, fitted.data()), SELVAGE_OK);
  expect_corner(fitted[0], from[0], 0, 0);
  expect_corner(fitted[1], from[1], 0, 20);
  expect_corner(fitted[2], from[2], 60, 20);
  expect_corner(fitted[3], from[3], 60, 0);
}

TEST(Fit, DoublesTheCornerThatIsAskedFor) {
  const auto from = corners();
  constexpr size_t kSource[3][4] = {{0, 0, 1, 2}, {0, 1, 1, 2}, {0, 1, 2, 2}};
  constexpr int32_t kU[4] = {0, 0, 60, 60}, kV[4] = {0, 20, 20, 0};
  for (size_t doubled = 0; doubled < 3; ++doubled) {
    std::array<selvage_vertex, 4> fitted{};
    ASSERT_EQ(selvage_fit(from.data(), 3, doubled, 60, 20, fitted.data()), SELVAGE_OK);
    for (size_t i = 0; i < 4; ++i) {
      expect_corner(fitted[i], from[kSource[doubled][i]], kU[i], kV[i]);
    }
  }
}

TEST(Fit, WorksInPlaceAndUpToTheLargestTexture) {
  auto from = corners();
  ASSERT_EQ(selvage_fit(from.data(), 3, 0, 32767, 1, from.data()), SELVAGE_OK);
  expect_corner(from[1], corners()[0], 0, 1);
  expect_corner(from[3], corners()[2], 32767, 0);
}

TEST(Fit, NamesWhatIsWrongAndWritesNothing) {
  const auto from = corners();
  auto fitted = corners();
  const auto fit = [&](size_t count, size_t doubled, int32_t width, int32_t height) {
    return selvage_fit(from.data(), count, doubled, width, height, fitted.data());
  };
  EXPECT_EQ(selvage_fit(nullptr, 4, 0, 1, 1, fitted.data()), SELVAGE_ERROR_FIT_NULL);
  EXPECT_EQ(selvage_fit(from.data(), 4, 0, 1, 1, nullptr), SELVAGE_ERROR_FIT_NULL);
  for (const size_t count : {size_t{0}, size_t{2}, size_t{5}, SIZE_MAX}) {
    EXPECT_EQ(fit(count, 0, 1, 1), SELVAGE_ERROR_FIT_COUNT);
  }
  EXPECT_EQ(fit(3, 3, 1, 1), SELVAGE_ERROR_FIT_DOUBLED);
  for (const int32_t size : {0, -1, 32768, INT32_MIN, INT32_MAX}) {
    EXPECT_EQ(fit(4, 0, size, 1), SELVAGE_ERROR_FIT_SIZE);
    EXPECT_EQ(fit(4, 0, 1, size), SELVAGE_ERROR_FIT_SIZE);
  }
  EXPECT_EQ(std::memcmp(fitted.data(), from.data(), sizeof fitted), 0);
}

}  // namespace
}  // namespace selvage
