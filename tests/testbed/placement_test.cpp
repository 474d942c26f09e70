#include "testbed/placement.h"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "spec/subject.h"

namespace selvage::testbed {
namespace {

class PlacementTest : public testing::Test {
 protected:
  PlacementTest() : pixels_(8 * 6), texels_(4 * 4, 7) {
    target_ = {pixels_.data(), 8, 5, 8 * 4, SELVAGE_RGBA8888};
    texture_ = {texels_.data(), 4, 4, 4 * 4, SELVAGE_RGBA8888, SELVAGE_LAYOUT_ROWS, nullptr};
  }

  [[nodiscard]] Placement placed(bool at_end) const {
    return {arenas_,
            {.target = &target_, .polygons = &polygon_, .count = 1, .options = &options_},
            prepared_,
            at_end};
  }

  Arenas arenas_;
  std::vector<uint32_t> pixels_, texels_;
  selvage_image target_;
  selvage_texture texture_;
  selvage_vertex vertices_[3] = {{0, 0, 0, 0, 1}, {256, 0, 0, 0, 1}, {0, 256, 0, 0, 1}};
  selvage_polygon polygon_{vertices_, 3, &texture_};
  selvage_options options_{};
  std::vector<Placed> prepared_;
};

[[nodiscard]] uintptr_t texels_of(const Call& call, size_t polygon = 0) {
  return reinterpret_cast<uintptr_t>(call.polygons[polygon].texture->texels);
}

TEST_F(PlacementTest, EndsOrBeginsAtAGuard) {
  const Call last = placed(true).copy_in();
  EXPECT_EQ(reinterpret_cast<uintptr_t>(last.target->pixels) + 5 * 32, arenas_.target.range().end);
  EXPECT_EQ(texels_of(last) + 64, arenas_.texture.range().end);
  EXPECT_EQ(reinterpret_cast<uintptr_t>(last.polygons[0].vertices + 3),
            arenas_.vertices.range().end);
  const Call first = placed(false).copy_in();
  EXPECT_EQ(reinterpret_cast<uintptr_t>(first.target->pixels), arenas_.target.range().begin);
  EXPECT_EQ(texels_of(first), arenas_.texture.range().begin);
}

TEST_F(PlacementTest, CopiesInAndTheTargetOut) {
  pixels_[0] = 11;
  const Placement placement = placed(true);
  const Call call = placement.copy_in();
  auto* seen = static_cast<uint32_t*>(call.target->pixels);
  EXPECT_EQ(seen[0], 11u);
  EXPECT_EQ(*static_cast<const uint32_t*>(call.polygons[0].texture->texels), 7u);
  EXPECT_EQ(call.polygons[0].vertices[1].x, 256);
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
            "just after the end of the target, where pixel (0, -1) or (8, 0) would be");
}

TEST_F(PlacementTest, OfMemoryThatIsSharedStaysShared) {
  texture_.texels = pixels_.data() + 8;
  const Call call = placed(true).copy_in();
  EXPECT_EQ(static_cast<const uint32_t*>(call.polygons[0].texture->texels),
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
            "8 bytes after the end of the target, where pixel (2, 5) or (10, 4) would be");
  EXPECT_EQ(placement.place_of(target.end - 5 * 32 - 1),
            "1 byte before the start of the target, where pixel (7, -1) or (-1, 0) would be");
  EXPECT_EQ(placement.place_of(texture.end - 4), "in the texture, at texel (3, 3)");
  EXPECT_EQ(placement.place_of(arenas_.vertices.range().end), "just after the end of the vertices");
  EXPECT_EQ(placement.place_of(16), "");
}

// Without padding one address is the end of a row and the beginning of the next.
TEST_F(PlacementTest, NamesBothPixelsWhereRowsMeet) {
  target_ = {pixels_.data(), 4, 2, 16, SELVAGE_RGBA8888};
  const auto place = [&](ptrdiff_t offset) {
    return placed(true).place_of(arenas_.target.range().end + static_cast<uintptr_t>(offset));
  };
  const std::string after = "just after the end of the target, where pixel ";
  EXPECT_EQ(place(0), after + "(0, 2) or (4, 1) would be");
  EXPECT_EQ(place(-36),
            "4 bytes before the start of the target, where pixel (3, -1) or (-1, 0) would be");
  EXPECT_EQ(place(-16), "in the target, where pixel (0, 1) is");
  EXPECT_EQ(place(16), "16 bytes after the end of the target, where pixel (0, 3) would be");
  target_.pixels = pixels_.data() + 4;
  target_.pitch = -16;
  EXPECT_EQ(place(0), after + "(0, -1) or (4, 0) would be");
  EXPECT_EQ(place(-36),
            "4 bytes before the start of the target, where pixel (3, 2) or (-1, 1) would be");
}

TEST_F(PlacementTest, OfManyHasEachTextureOnceAndTwoAtGuards) {
  std::vector<uint32_t> others(9, 8);
  const selvage_texture other = {others.data(), 3, 3, 12, SELVAGE_RGBA8888, 0, nullptr};
  const selvage_polygon polygons[] = {{vertices_, 3, &texture_},
                                      {vertices_, 2, &other},
                                      {nullptr, 0, nullptr},
                                      {vertices_, 3, &texture_}};
  const Placement placement(
      arenas_,
      {.function = Function::kDrawMany, .target = &target_, .polygons = polygons, .count = 4},
      prepared_, true);
  const Call call = placement.copy_in();
  EXPECT_EQ(reinterpret_cast<uintptr_t>(call.polygons + 4), arenas_.polygons.range().end);
  EXPECT_EQ(texels_of(call) + 64, arenas_.texture.range().end);
  EXPECT_EQ(texels_of(call, 1) + 36, arenas_.other_textures.range().end);
  EXPECT_EQ(call.polygons[3].texture, call.polygons[0].texture);
  EXPECT_EQ(call.polygons[2].texture, nullptr);
  EXPECT_EQ(call.polygons[2].vertices, nullptr);
  EXPECT_EQ(call.polygons[0].vertices[1].x, 256);
  EXPECT_EQ(call.polygons[1].count, 2u);
  EXPECT_EQ(reinterpret_cast<uintptr_t>(call.polygons[0].vertices + 3),
            arenas_.vertices.range().end);
  EXPECT_EQ(placement.place_of(arenas_.other_textures.range().end),
            "just after the end of the texture, at texel (0, 3) or (3, 2)");
  EXPECT_EQ(placement.place_of(arenas_.polygons.range().end),
            "in the list of polygons, or beside it");
}

TEST_F(PlacementTest, OfMoreThanThereIsRoomForIsNotClaimed) {
  const std::vector<selvage_polygon> polygons(10'000, polygon_);
  EXPECT_THROW(
      Placement(arenas_, {.polygons = polygons.data(), .count = polygons.size()}, prepared_, true),
      spec::NotClaimed);
}

TEST_F(PlacementTest, OfWhatWasPreparedStaysWhereItIs) {
  alignas(64) uint32_t block[64] = {};
  const Range from{reinterpret_cast<uintptr_t>(block), reinterpret_cast<uintptr_t>(block + 64)};
  prepared_.push_back({from, arenas_.prepared[1].range().begin});
  texture_.texels = block + 16;
  texture_.prepared = block + 32;
  const Call call = placed(true).copy_in();
  EXPECT_EQ(texels_of(call), arenas_.prepared[1].range().begin + 64);
  EXPECT_EQ(reinterpret_cast<uintptr_t>(call.polygons[0].texture->prepared),
            arenas_.prepared[1].range().begin + 128);
  EXPECT_EQ(placed(true).place_of(arenas_.prepared[1].range().begin + 256),
            "just after the end of the prepared texture, at texel (0, 12)");
}

TEST_F(PlacementTest, OfTilesIsWholeTiles) {
  texture_.layout = SELVAGE_LAYOUT_TILES;
  texture_.pitch = 64;
  alignas(64) uint32_t tiles[32] = {};
  tiles[31] = 5;
  texture_.texels = tiles;
  texture_.height = 5;
  const Call call = placed(true).copy_in();
  EXPECT_EQ(texels_of(call) + 128, arenas_.texture.range().end);
  EXPECT_EQ(reinterpret_cast<const uint32_t*>(texels_of(call))[31], 5u);
  texture_.pitch = -64;  // which tiles cannot have
  EXPECT_EQ(texels_of(placed(true).copy_in()), arenas_.texture.range().end);
}

TEST_F(PlacementTest, BringsAnswersBack) {
  selvage_choice choice{-1, -1, -1};
  const Placement placement(arenas_,
                            {.function = Function::kChoose,
                             .target = &target_,
                             .polygons = &polygon_,
                             .count = 1,
                             .choice = &choice},
                            prepared_, true);
  const Call call = placement.copy_in();
  EXPECT_EQ(reinterpret_cast<uintptr_t>(call.choice + 1), arenas_.results.range().end);
  EXPECT_EQ(call.choice->bound, -1);
  call.choice->bound = 3;
  placement.copy_out();
  EXPECT_EQ(choice.bound, 3);
}

}  // namespace
}  // namespace selvage::testbed
