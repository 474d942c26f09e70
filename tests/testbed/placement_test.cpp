#include "testbed/placement.h"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

namespace selvage::testbed {
namespace {

class PlacementTest : public testing::Test {
 protected:
  PlacementTest() : pixels_(8 * 6), texels_(4 * 4, 7) {
    target_ = {pixels_.data(), 8, 5, 8 * 4, SELVAGE_RGBA8888};
    texture_ = {texels_.data(), 4, 4, 4 * 4, SELVAGE_RGBA8888, SELVAGE_LAYOUT_ROWS, nullptr};
  }

  [[nodiscard]] Placement placed(bool at_end) const {
    return {arenas_, {&target_, nullptr, vertices_, 3, &texture_, &options_}, at_end};
  }

  Arenas arenas_;
  std::vector<uint32_t> pixels_, texels_;
  selvage_image target_;
  selvage_texture texture_;
  selvage_vertex vertices_[3] = {{0, 0, 0, 0, 1}, {256, 0, 0, 0, 1}, {0, 256, 0, 0, 1}};
  selvage_options options_{};
};

TEST_F(PlacementTest, EndsOrBeginsAtAGuard) {
  const Call last = placed(true).copy_in();
  EXPECT_EQ(reinterpret_cast<uintptr_t>(last.target->pixels) + 5 * 32, arenas_.target.range().end);
  EXPECT_EQ(reinterpret_cast<uintptr_t>(last.texture->texels) + 64, arenas_.texture.range().end);
  EXPECT_EQ(reinterpret_cast<uintptr_t>(last.vertices + 3), arenas_.vertices.range().end);
  const Call first = placed(false).copy_in();
  EXPECT_EQ(reinterpret_cast<uintptr_t>(first.target->pixels), arenas_.target.range().begin);
  EXPECT_EQ(reinterpret_cast<uintptr_t>(first.texture->texels), arenas_.texture.range().begin);
}

TEST_F(PlacementTest, CopiesInAndTheTargetOut) {
  pixels_[0] = 11;
  const Placement placement = placed(true);
  const Call call = placement.copy_in();
  auto* seen = static_cast<uint32_t*>(call.target->pixels);
  EXPECT_EQ(seen[0], 11u);
  EXPECT_EQ(*static_cast<const uint32_t*>(call.texture->texels), 7u);
  EXPECT_EQ(call.vertices[1].x, 256);
  EXPECT_EQ(call.clip, nullptr);
  EXPECT_NE(call.options, nullptr);
  seen[39] = 12;
  placement.copy_out();
  EXPECT_EQ(pixels_[39], 12u);
}

TEST_F(PlacementTest, OfABottomRowFirstStaysSo) {
  target_.pixels = pixels_.data() + 4 * 8;
  target_.pitch = -32;
  const Call call = placed(true).copy_in();
  EXPECT_EQ(reinterpret_cast<uintptr_t>(call.target->pixels) + 32, arenas_.target.range().end);
  EXPECT_EQ(placed(true).place_of(arenas_.target.range().end),
            "just after the end of the target, where pixel (0, -1) would be");
}

TEST_F(PlacementTest, OfMemoryThatIsSharedStaysShared) {
  texture_.texels = pixels_.data() + 8;
  const Call call = placed(true).copy_in();
  EXPECT_EQ(static_cast<const uint32_t*>(call.texture->texels),
            static_cast<const uint32_t*>(call.target->pixels) + 8);
}

TEST_F(PlacementTest, OfBadArgumentsTouchesNothing) {
  target_.width = INT32_MAX;
  texture_.height = -1;
  const Call call = placed(true).copy_in();
  EXPECT_EQ(call.target->width, INT32_MAX);
  EXPECT_EQ(reinterpret_cast<uintptr_t>(call.target->pixels), arenas_.target.range().end);
  EXPECT_EQ(placed(true).place_of(arenas_.target.range().end),
            "through the target, which is to be refused");
  target_.width = 2;
  target_.pitch = 33;  // splits a pixel
  EXPECT_EQ(reinterpret_cast<uintptr_t>(placed(true).copy_in().target->pixels),
            arenas_.target.range().end);
  target_.pitch = 32;
  target_.format = 77;  // who knows how many bytes there are
  EXPECT_EQ(reinterpret_cast<uintptr_t>(placed(true).copy_in().target->pixels),
            arenas_.target.range().end);
  target_.pixels = nullptr;
  EXPECT_EQ(placed(true).copy_in().target->pixels, nullptr);
}

TEST_F(PlacementTest, KeepsWhatIsMisaligned) {
  target_.pixels = reinterpret_cast<char*>(pixels_.data()) + 1;
  const Call call = placed(true).copy_in();
  EXPECT_EQ(reinterpret_cast<uintptr_t>(call.target->pixels) % 4, 1u);
}

TEST_F(PlacementTest, NamesPlaces) {
  const Placement placement = placed(true);
  const Range target = arenas_.target.range(), texture = arenas_.texture.range();
  EXPECT_EQ(placement.place_of(target.end + 8),
            "8 bytes after the end of the target, where pixel (2, 5) would be");
  EXPECT_EQ(placement.place_of(target.end - 5 * 32 - 1),
            "1 byte before the start of the target, where pixel (7, -1) would be");
  EXPECT_EQ(placement.place_of(texture.end - 4), "in the texture, at texel (3, 3)");
  EXPECT_EQ(placement.place_of(arenas_.vertices.range().end), "just after the end of the vertices");
  EXPECT_EQ(placement.place_of(16), "");
}

}  // namespace
}  // namespace selvage::testbed
