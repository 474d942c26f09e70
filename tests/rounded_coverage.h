// A right mapper whose coverage is that of another outline, for the tests of coverage that is
// rounded.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <functional>
#include <vector>

#include "spec/canvas.h"
#include "spec/law_tools.h"
#include "spec/subject.h"

namespace selvage::spec {

// What a call is about that may change an outline.
struct OutlineCall {
  const selvage_rect* clip;
  const std::vector<selvage_vertex>& vertices;
  const selvage_texture& texture;
  const selvage_options& options;
};
using OutlineOf = std::function<Vertices(const OutlineCall&)>;
using MoveOf = std::function<Point(const OutlineCall&)>;  // in 1/256 px

[[nodiscard]] inline Vertices moved_by(Vertices vertices, Point by) {
  const auto in_range = [](int64_t fx8) {
    return static_cast<int32_t>(std::clamp<int64_t>(fx8, SELVAGE_X_MIN, SELVAGE_X_END - 1));
  };
  for (selvage_vertex& v : vertices) {
    v.x = in_range(v.x + by.x);
    v.y = in_range(v.y + by.y);
  }
  return vertices;
}

// Which pixels of a target an outline covers.
[[nodiscard]] inline std::vector<uint8_t> mask_of(const selvage_image& target,
                                                  const selvage_rect* clip,
                                                  const Vertices& vertices) {
  const auto width = static_cast<size_t>(target.width);
  std::vector<uint8_t> pixels(width * static_cast<size_t>(target.height), 0);
  const selvage_image image{pixels.data(), target.width, target.height, target.width,
                            SELVAGE_INDEX8};
  const uint8_t one = 1;
  const selvage_texture texture{&one, 1, 1, 1, SELVAGE_INDEX8, SELVAGE_LAYOUT_ROWS, nullptr};
  EXPECT_EQ(selvage_draw(&image, clip, vertices.data(), vertices.size(), &texture, nullptr),
            SELVAGE_OK);
  return pixels;
}

// The mapper that this program is linked with, its coverage that of outline_of(...): its texels are
// exact, and the first of the texture beside the right outline.
[[nodiscard]] inline Subject covering(const OutlineOf& outline_of) {
  Subject subject = built_in();
  subject.draw = [=](const selvage_image* target, const selvage_rect* clip,
                     const selvage_vertex* vertices, size_t count, const selvage_texture* texture,
                     const selvage_options* options) {
    const Vertices right(vertices, vertices + count);
    const Vertices wrong = outline_of({clip, right, *texture, *options});
    std::vector<std::vector<char>> before;
    const auto bytes = static_cast<size_t>(bytes_per_pixel(target->format));
    const auto row_of = [&](int32_t y) {
      return static_cast<char*>(target->pixels) + y * target->pitch;
    };
    for (int32_t y = 0; y < target->height; ++y) {
      before.emplace_back(row_of(y), row_of(y) + bytes * static_cast<size_t>(target->width));
    }
    const selvage_status status = selvage_draw(target, clip, vertices, count, texture, options);
    if (status != SELVAGE_OK) return status;
    const auto due = mask_of(*target, clip, right), drawn = mask_of(*target, clip, wrong);
    for (size_t i = 0; i < due.size(); ++i) {
      const size_t y = i / static_cast<size_t>(target->width);
      const size_t at = i % static_cast<size_t>(target->width) * bytes;
      if (due[i] == drawn[i]) continue;
      const char* from = due[i] ? before[y].data() + at : static_cast<const char*>(texture->texels);
      std::memcpy(row_of(static_cast<int32_t>(y)) + at, from, bytes);
    }
    return status;
  };
  subject.draw_many = {};
  subject.choose = {};
  subject.claims.named_errors = false;  // all arguments are looked at
  subject.claims.concave = false;       // moved within the range that coordinates have
  return subject;
}

[[nodiscard]] inline Subject claiming_px(Subject subject, int32_t coverage_accuracy_fx16) {
  subject.claims.coverage_accuracy_fx16 = coverage_accuracy_fx16;
  return subject;
}

[[nodiscard]] inline Subject covering_moved(const MoveOf& move_of) {
  return covering(
      [=](const OutlineCall& drawing) { return moved_by(drawing.vertices, move_of(drawing)); });
}

// To the nearest multiples of so much.
[[nodiscard]] inline Subject snapping(int32_t step_fx8) {
  return covering([=](const OutlineCall& drawing) {
    Vertices snapped = drawing.vertices;
    const auto snap = [=](int32_t at_fx8) {
      const int32_t up_fx8 = (at_fx8 + step_fx8 / 2) & ~(step_fx8 - 1);
      return up_fx8 < SELVAGE_X_END ? up_fx8 : up_fx8 - step_fx8;
    };
    for (selvage_vertex& v : snapped) v.x = snap(v.x), v.y = snap(v.y);
    return snapped;
  });
}

inline constexpr int32_t kFx16OfFx8 = SELVAGE_SUBTEXELS / SELVAGE_SUBPIXELS;

[[nodiscard]] inline Subject moving(int32_t dx_fx8, int32_t dy_fx8) {
  return covering_moved([=](const OutlineCall&) { return Point{dx_fx8, dy_fx8}; });
}

// By something else under another clip, from another layout, by another kernel, as rounding is
// that depends on where it begins.
[[nodiscard]] inline Subject moving_at_random(int32_t most_fx8) {
  return covering_moved([=](const OutlineCall& drawing) {
    uint32_t hash = 1;
    const auto add = [&](auto... values) {
      ((hash = (hash ^ static_cast<uint32_t>(values)) * 0x9E3779B1U, hash ^= hash >> 15), ...);
    };
    const auto [clip, vertices, texture, options] = drawing;
    if (clip != nullptr) add(clip->left, clip->top, clip->right, clip->bottom);
    add(texture.layout, options.kernel);
    Choices choices(hash);
    const auto some = [&] { return int64_t{choices.pick(-most_fx8, most_fx8 + 1)}; };
    return Point{some(), some()};
  });
}

}  // namespace selvage::spec
