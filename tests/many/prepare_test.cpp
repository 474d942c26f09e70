#include "many/prepare.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "tests/many/support.h"

namespace selvage::many {
namespace {

// The bands that the first half of the work is in: of a square to the left of the target's middle
// line and above, and of one below that reaches so far to the right.
[[nodiscard]] BandRange upper_half(int32_t right_px) {
  const int32_t middle = kHeight_px / 2 * 256, bottom = kHeight_px * 256, right = right_px * 256;
  const std::array<selvage_vertex, 8> vertices{{{0, 0, 0, 0, 1},
                                                {25600, 0, 0, 0, 1},
                                                {25600, middle, 0, 0, 1},
                                                {0, middle, 0, 0, 1},
                                                {0, middle, 0, 0, 1},
                                                {right, middle, 0, 0, 1},
                                                {right, bottom, 0, 0, 1},
                                                {0, bottom, 0, 0, 1}}};
  const List list(1, 1);
  const std::array<selvage_polygon, 2> polygons{
      {{vertices.data(), 4, &list.textures[0]}, {vertices.data() + 4, 4, &list.textures[0]}}};
  Target target;
  std::array<Prepared, 2> prepared;
  const selvage_rect visible{0, 0, kWidth_px, kHeight_px};
  const Request request{target.image(), visible, selvage_options{}, polygons, prepared, {0, 0}};
  std::vector<BandIndex::Group> groups(BandIndex::groups(2));
  BandPlan plan{BandIndex(Bands({0, kHeight_px}), groups)};
  EXPECT_EQ(prepare(request, Runs(2, 2), &plan).status, SELVAGE_OK);
  return BandShares(plan.work[0].value(), {0, plan.index.bands().count()}).parts(0, 1, 2);
}

// What lies off screen is no work.
TEST(Prepare, CountsTheWorkThatIsVisible) {
  EXPECT_EQ(upper_half(kWidth_px).end, upper_half(32767).end);
  EXPECT_GT(upper_half(kWidth_px).end, upper_half(10).end);
}

}  // namespace
}  // namespace selvage::many
