#include "many/work_left.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "tests/many/prepared_list.h"

namespace selvage::many {
namespace {

constexpr int32_t kMiddle_px = 152;  // a band begins there
static_assert(kMiddle_px % kLeastBandRows == 0);

// A square to the left of a line above the middle, and one below that reaches so far to the right.
struct TwoSquares {
  const List list{1, 1};
  std::array<selvage_vertex, 8> vertices;
  std::array<selvage_polygon, 2> polygons;
  Target target;
  PreparedList prepared;

  explicit TwoSquares(int32_t right_px)
      : vertices(corners(right_px * 256)),
        polygons{
            {{vertices.data(), 4, &list.textures[0]}, {vertices.data() + 4, 4, &list.textures[0]}}},
        prepared(polygons, target.image()) {}

  [[nodiscard]] double left_px(size_t first, BandRange bands, BandRange of_first) const {
    const BandWork work = work_left(prepared.request, prepared.bands(), {first, bands}, of_first);
    return BandShares(work, bands).all_px();
  }

 private:
  [[nodiscard]] static std::array<selvage_vertex, 8> corners(int32_t right) {
    constexpr int32_t kMiddle = kMiddle_px * 256, kBottom = kHeight_px * 256;
    return {{{0, 0, 0, 0, 1},
             {25600, 0, 0, 0, 1},
             {25600, kMiddle, 0, 0, 1},
             {0, kMiddle, 0, 0, 1},
             {0, kMiddle, 0, 0, 1},
             {right, kMiddle, 0, 0, 1},
             {right, kBottom, 0, 0, 1},
             {0, kBottom, 0, 0, 1}}};
  }
};

TEST(WorkLeft, IsWhatIsVisible) {
  const auto of = [](int32_t right_px) {
    const TwoSquares squares(right_px);
    const BandRange all = squares.prepared.all_bands();
    return squares.left_px(0, all, all);
  };
  EXPECT_EQ(of(kWidth_px), of(32767));
  EXPECT_GT(of(kWidth_px), of(10));
}

TEST(WorkLeft, IsInThePartsBands) {
  const TwoSquares squares(100);
  const size_t middle = kMiddle_px / kLeastBandRows;
  const BandRange all = squares.prepared.all_bands(), above{0, middle}, below{middle, all.end};
  const double both_px = squares.left_px(0, all, all), upper_px = squares.left_px(0, above, above),
               lower_px = squares.left_px(1, all, all);
  EXPECT_EQ(both_px, upper_px + lower_px);
  EXPECT_EQ(squares.left_px(0, below, below), lower_px);
  EXPECT_EQ(squares.left_px(1, above, above), 0);
  const double half_px = squares.left_px(0, all, {middle / 2 + 1, all.end});
  EXPECT_DOUBLE_EQ(half_px, lower_px + upper_px * static_cast<double>(middle - middle / 2 - 1) /
                                           static_cast<double>(middle));
}

// 3000 polygons are judged by a few hundred.
TEST(WorkLeft, IsAboutThatOfAllPolygons) {
  const List list(3000, /*seed=*/1);
  Target target;
  const PreparedList prepared(list.polygons, target.image());
  const Bands& bands = prepared.bands();
  const BandRange part{10, 30};
  double all_px = 0;
  for (size_t i = 1000; i < 3000; ++i) {
    all_px += cost_of_band_px(prepared.request, bands, i) *
              static_cast<double>(bands_of(prepared.request, bands, i).within(part).count());
  }
  const BandWork work = work_left(prepared.request, bands, {1000, part}, part);
  EXPECT_NEAR(BandShares(work, part).all_px(), all_px, 0.15 * all_px);
}

}  // namespace
}  // namespace selvage::many
