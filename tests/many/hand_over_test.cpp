#include "many/hand_over.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <vector>

#include "many/workers.h"

namespace selvage::many {
namespace {

constexpr size_t kListed = 200, kHandedBands = 40;

// A picture whose pixels are bands: each tells which polygons came there, in order.
struct BandPicture {
  std::array<std::vector<size_t>, kHandedBands> drawn;

  void draw(size_t polygon, BandRange bands) {
    for (size_t band = bands.first; band < bands.end; ++band) drawn[band].push_back(polygon);
  }
  [[nodiscard]] bool is_whole() const {
    for (const std::vector<size_t>& polygons : drawn) {
      if (polygons.size() != kListed) return false;
      for (size_t i = 0; i < kListed; ++i) {
        if (polygons[i] != i) return false;
      }
    }
    return true;
  }
};

// Draws a part, and gives away half of its bands whenever it is asked.
void draw(HandOver& parts, Part part, BandPicture* picture, std::atomic<int>* given) {
  for (size_t polygon = part.first; polygon < kListed; ++polygon) {
    const size_t middle = part.bands.first + (part.bands.count() + 1) / 2;
    if (parts.waiting() != 0 && middle < part.bands.end) {
      part.bands.end = parts.give({polygon, {middle, part.bands.end}});
      *given += part.bands.end == middle;
    }
    picture->draw(polygon, part.bands);
    if (polygon % 8 == 0) wait_a_little();
  }
}

struct Drawing {
  HandOver parts;
  BandPicture picture;
  std::atomic<int> given{0};

  explicit Drawing(std::span<const Part> shares) : parts(shares) {}

  void work(size_t worker) {
    while (const std::optional<Part> part = parts.take(worker)) {
      draw(parts, *part, &picture, &given);
      parts.done();
    }
  }
};

void run(Drawing& drawing, int32_t workers) {
  run_workers(
      workers, [](void* of, size_t worker) { static_cast<Drawing*>(of)->work(worker); }, &drawing);
}

// All of the picture is the first worker's, or each has as much as the others.
TEST(HandOver, DrawsAllInOrderWhoeverDrawsIt) {
  int given = 0;
  for (const size_t workers : {1U, 2U, 3U, 8U, 40U}) {
    for (const bool is_one_share : {false, true}) {
      for (int round = 0; round < 20; ++round) {
        std::vector<Part> shares;
        for (size_t i = 0; i < workers; ++i) {
          shares.push_back({0, {kHandedBands * i / workers, kHandedBands * (i + 1) / workers}});
          if (is_one_share) shares.back().bands = {0, i == 0 ? kHandedBands : 0};
        }
        Drawing drawing(shares);
        run(drawing, static_cast<int32_t>(workers));
        ASSERT_TRUE(drawing.picture.is_whole()) << workers << " workers";
        given += drawing.given;
      }
    }
  }
  if (worker_count(0) > 1) {
    EXPECT_GT(given, 0);
  }
}

// One worker that is called alone draws what the others would have drawn, and waits for none.
TEST(HandOver, NeedsNoMoreThanOneWorker) {
  const std::array<Part, 3> shares{{{0, {0, 10}}, {0, {10, 30}}, {0, {30, kHandedBands}}}};
  for (size_t worker = 0; worker < shares.size(); ++worker) {
    Drawing drawing(shares);
    drawing.work(worker);
    drawing.work(worker);
    EXPECT_TRUE(drawing.picture.is_whole()) << "worker " << worker;
  }
}

TEST(HandOver, BeginsWithAWorkersOwnPart) {
  const std::array<Part, 3> shares{{{0, {0, 10}}, {0, {10, 30}}, {0, {30, kHandedBands}}}};
  HandOver parts(shares);
  EXPECT_EQ(parts.waiting(), 0U);
  EXPECT_EQ(parts.give(shares[0]), shares[0].bands.end);
  EXPECT_EQ(parts.take(1)->bands.first, 10U);
  EXPECT_EQ(parts.take(1)->bands.first, 30U);
  EXPECT_EQ(parts.take(0)->bands.first, 0U);
  for (int i = 0; i < 3; ++i) parts.done();
  EXPECT_FALSE(parts.take(2).has_value());
}

}  // namespace
}  // namespace selvage::many
