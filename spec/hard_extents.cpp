// Hard by their extents: spans and edges of 30 000 px, the ends of the range, scales of 4 096.
#include <algorithm>

#include "spec/hard_makers.h"
#include "spec/hard_tools.h"
#include "spec/vertex_units.h"

namespace selvage::spec {

// Whole, in a target as wide, or only the end of it.
Case make_long_span(uint64_t seed) {
  Draft draft(seed);
  const int32_t length_px = draft.random.in(30000, 32001);
  const Frame frame =
      draft.small ? draft.random.pick({Frame{256, 2}, Frame{170, 3}, Frame{512, 1}, Frame{100, 5}})
                  : Frame{length_px, 2};
  const TextureSize large = draft.random.pick<TextureSize>({{4096, 16}, {16384, 4}, {32768, 2}});
  Case c = start(draft, frame, draft.small ? TextureSize{4096, 1} : large);
  const int64_t length = draft.place_fx8(length_px, length_px + 1);
  const int64_t right = draft.place_fx8(frame.width_px / 2, frame.width_px);
  const int64_t slant = draft.place_fx8(-6, 6);
  const Point from{draft.small ? right - length : std::max<int64_t>(0, -slant), 0};
  set_outline(&c, parallelogram(from, {length, 0}, {slant, frame.height_px * kPixel_fx8}));
  map_axes(draft, &c);
  return c;
}

Case make_long_edge(uint64_t seed) {
  Case c = make_long_span(seed);
  swap_axes(&c);
  return c;
}

namespace {

// The ends of the range on the draft's grid.
struct Ends {
  int64_t first = SELVAGE_X_MIN, last;
  explicit Ends(const Draft& draft) : last(SELVAGE_X_END - draft.grid_fx8()) {}
};

// An edge from end to end through the target, from corner to corner or less steep, and on to an end
// of the other axis.
[[nodiscard]] Outline end_to_end(Draft& draft, Frame frame) {
  const Ends ends(draft);
  const int64_t other_end = draft.random.pick({ends.first, ends.last});
  if (draft.random.percent(30)) {
    const Point third =
        other_end == ends.first ? Point{ends.last, ends.first} : Point{ends.first, ends.last};
    return {{ends.first, ends.first}, {ends.last, ends.last}, third};
  }
  const int64_t y = draft.place_fx8(-12000, 12000);
  const int64_t middle = draft.place_fx8(frame.height_px / 4, frame.height_px * 3 / 4);
  const Point first{ends.first, y}, last{ends.last, 2 * middle - y};
  if (draft.random.percent(50))
    return {first, last, {ends.last, other_end}, {ends.first, other_end}};
  return {first, last, {draft.random.pick({ends.first, ends.last}), other_end}};
}

}  // namespace

Case make_range_ends(uint64_t seed) {
  Draft draft(seed);
  const bool all_of_it = !draft.small && draft.random.percent(40);
  const Frame frame = all_of_it ? Frame{32768, 2} : screen(draft);
  Case c = start(draft, frame, all_of_it ? TextureSize{32768, 2} : screen_texture(draft));
  if (all_of_it) {
    const Ends ends(draft);
    set_outline(&c, parallelogram({ends.first, 0}, {ends.last - ends.first, 0}, {0, 512}));
    map_axes(draft, &c);
  } else {
    set_outline(&c, end_to_end(draft, frame));
    map_about_the_middle(draft, &c);
  }
  if (draft.random.percent(40)) swap_axes(&c);
  return c;
}

namespace {

// A triangle with an edge through the target, whose corners are some 3 000 to 20 000 px away.
[[nodiscard]] Outline far_triangle(Draft& draft, Frame frame) {
  const int64_t sign = draft.random.pick({1, -1});
  const int64_t far_x = sign * draft.place_fx8(3000, 10000);
  const int64_t far_y = draft.place_fx8(-10000, 10000);
  const Point middle{draft.place_fx8(0, frame.width_px), draft.place_fx8(0, frame.height_px)};
  const Point way{far_x, far_y};
  const int64_t factor = draft.random.in(1, 3);
  const int64_t side = draft.random.pick({-1, 1});
  return {middle + way, middle - factor * way, middle + side * Point{-way.y, way.x}};
}

}  // namespace

Case make_far_off_screen(uint64_t seed) {
  Draft draft(seed);
  const Frame frame = screen(draft);
  Case c = start(draft, frame, screen_texture(draft));
  do {
    set_outline(&c, far_triangle(draft, frame));
  } while (!covers_a_pixel(c));
  map_about_the_middle(draft, &c);
  return c;
}

// Three texels a side; the target shows the surroundings of a place where four of them meet.
Case make_magnified_4096(uint64_t seed) {
  Draft draft(seed);
  const Frame frame = draft.small
                          ? draft.random.pick({Frame{512, 1}, Frame{24, 24}, Frame{256, 2}})
                          : draft.random.pick({Frame{8192, 4}, Frame{4096, 8}, Frame{160, 120}});
  Case c = start(draft, frame, {8, 8});
  const int32_t any_px = draft.random.in(4090, 4200);
  const int64_t texel = kPixel_fx8 * draft.random.pick({4096, 4095, 4097, any_px});
  const int64_t lean = draft.place_fx8(-300, 300);
  const Point along{texel, lean}, down{-lean, texel};
  const int64_t meet_x = draft.place_fx8(frame.width_px / 4, frame.width_px * 3 / 4);
  const int64_t meet_y = draft.place_fx8(0, frame.height_px);
  const Point from = Point{meet_x, meet_y} - along - down;
  set_outline(&c, parallelogram(from, 3 * along, 3 * down));
  const bool backward = draft.random.percent(50);
  const int32_t u = draft.random.in(0, 5), v = draft.random.in(0, 5);
  for (size_t k = 0; k < 4; ++k) {
    const bool right = (k == 1 || k == 2) != backward;
    c.vertices[k].u = (right ? u + 3 : u) * SELVAGE_SUBTEXELS;
    c.vertices[k].v = (k >= 2 ? v + 3 : v) * SELVAGE_SUBTEXELS;
  }
  return c;
}

// 4 096 texels across 3 px, one way or the other.
Case make_minified_4096(uint64_t seed) {
  Draft draft(seed);
  const Frame frame = draft.small ? Frame{16, 48} : Frame{64, 128};
  Case c = start(draft, frame, draft.small ? TextureSize{4096, 1} : TextureSize{4096, 16});
  const int64_t height = draft.place_fx8(frame.height_px / 2, frame.height_px - 4);
  const int64_t top = draft.place_fx8(0, 3);
  const int64_t left = draft.place_fx8(1, frame.width_px / 3);
  const int64_t lean = draft.place_fx8(frame.width_px / 4, frame.width_px / 2);
  const Point across{3 * kPixel_fx8, draft.random.in(0, 2) * int64_t{draft.grid_fx8()}};
  set_outline(&c, parallelogram({left, top}, across, {lean, height}));
  const int32_t last = 4096 * SELVAGE_SUBTEXELS - 1;
  const int32_t rows = c.texture_height_texel * SELVAGE_SUBTEXELS;
  const bool backward = draft.random.percent(50);
  for (size_t k = 0; k < 4; ++k) {
    const bool right = (k == 1 || k == 2) != backward;
    c.vertices[k].u = right ? last : 0;
    c.vertices[k].v = k >= 2 ? rows - 1 : 0;
  }
  if (draft.random.percent(40)) swap_axes(&c);
  return c;
}

}  // namespace selvage::spec
