// That each peer's library loads, says what it promises and draws what it is asked to.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>
#include <set>
#include <string>

#include "spec/picture.h"
#include "testbed/host.h"
#include "tests/matrix/patience.h"

namespace selvage::testbed {
namespace {

[[nodiscard]] std::set<std::filesystem::path> libraries() {
  std::set<std::filesystem::path> found;
  if (!std::filesystem::exists(SELVAGE_PEER_SUBJECTS)) return found;
  for (const auto& entry : std::filesystem::directory_iterator(SELVAGE_PEER_SUBJECTS)) {
    if (entry.path().extension() == ".so") found.insert(entry.path());
  }
  return found;
}

// A triangle over much of a 32 x 24 target, whole pixels, two texels to a pixel, off all
// boundaries.
[[nodiscard]] spec::Case plain_case(const spec::Subject& subject) {
  spec::Case c;
  c.target_width_px = 32;
  c.target_height_px = 24;
  c.texture_width_texel = c.texture_height_texel = 64;
  const auto vertex = [](int32_t x_px, int32_t y_px) {
    constexpr int32_t eighth = SELVAGE_SUBTEXELS / 8;
    return selvage_vertex{x_px * SELVAGE_SUBPIXELS, y_px * SELVAGE_SUBPIXELS,
                          x_px * 2 * SELVAGE_SUBTEXELS + eighth,
                          y_px * 2 * SELVAGE_SUBTEXELS + eighth, 1};
  };
  c.vertices = {vertex(1, 1), vertex(30, 3), vertex(4, 22)};
  return spec::within(subject.claims, c);
}

// Whether the texels are neighbours: SDL leaves the last row and column of what is mapped out.
[[nodiscard]] bool are_near(uint32_t a, uint32_t b) {
  const spec::Texel one = spec::texel_of(a), two = spec::texel_of(b);
  return std::abs(one.s - two.s) <= 1 && std::abs(one.t - two.t) <= 1;
}

TEST(PeerSubjects, LoadAndDrawATriangleWhereItIs) {
  const auto found = libraries();
  if (found.empty()) GTEST_SKIP() << "no peer was found when this was configured";
  for (const auto& library : found) {
    SCOPED_TRACE(library);
    const auto host = std::make_shared<Host>(library, kPatience);
    const spec::Subject subject = Host::subject(host);
    const spec::Case c = plain_case(subject);
    const spec::Picture drawn = spec::draw(subject, c), model = spec::expected(c);
    EXPECT_EQ(drawn.status, SELVAGE_OK);
    EXPECT_EQ(drawn.memory_fault, "");
    int covered = 0, same = 0, near = 0, extra = 0;
    for (size_t i = 0; i < model.pixels.size(); ++i) {
      covered += model.pixels[i] ? 1 : 0;
      same += model.pixels[i] && drawn.pixels[i] == model.pixels[i] ? 1 : 0;
      near += model.pixels[i] && drawn.pixels[i] && are_near(*model.pixels[i], *drawn.pixels[i])
                  ? 1
                  : 0;
      extra += drawn.pixels[i] && !model.pixels[i] ? 1 : 0;
    }
    std::cout << subject.name << ": " << same << " of " << covered << " px exact, " << near
              << " within a texel, " << extra << " extra\n";
    // Edges of 30 and 25 pixels, each of which a peer may have by a rule of its own.
    EXPECT_GT(covered, 250);
    EXPECT_GT(near * 10, covered * 9);
    EXPECT_LE(extra, 60);
  }
}

TEST(PeerSubjects, LeaveAloneWhatTheClipLeavesOut) {
  for (const auto& library : libraries()) {
    SCOPED_TRACE(library);
    const spec::Subject subject = Host::subject(std::make_shared<Host>(library, kPatience));
    if (!subject.claims.clip) continue;
    spec::Case c = plain_case(subject);
    c.has_clip = true;
    c.clip = {5, 4, 9, 100};
    const spec::Picture drawn = spec::draw(subject, c);
    int inside = 0, outside = 0;
    for (int32_t y = 0; y < drawn.height_px; ++y) {
      for (int32_t x = 0; x < drawn.width_px; ++x) {
        const bool clipped = x < c.clip.left || x >= c.clip.right || y < c.clip.top;
        (clipped ? outside : inside) += drawn.at(x, y) ? 1 : 0;
      }
    }
    EXPECT_GT(inside, 30);
    EXPECT_EQ(outside, 0);
  }
}

}  // namespace
}  // namespace selvage::testbed
