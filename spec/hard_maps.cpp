// Hard for the mapping: ties on texel boundaries, and q.
#include <algorithm>
#include <array>

#include "spec/hard_makers.h"
#include "spec/hard_tools.h"

namespace selvage::spec {

Case make_texel_boundaries(uint64_t seed) {
  Draft draft(seed);
  const Frame frame = screen(draft);
  Case c = start(draft, frame, screen_texture(draft));
  set_outline(&c, one_of_few_corners(draft, frame));
  const Slope u =
      draft.random.pick<Slope>({{2, 0, 1}, {1, 1, 1}, {-1, 1, 1}, {-2, 0, 1}, {0, 1, 1}});
  const Slope v = draft.random.pick<Slope>({{0, 1, 1}, {1, -1, 1}, {1, 0, 1}, {0, -1, 1}});
  map_on_boundaries(&c, u, v);
  return c;
}

// Along the top edge all is a whole texel, and the row of centres next to it takes little of what
// the bottom's corners are off: u and v change by less than 2^-32 texel a pixel there.
Case make_least_slopes(uint64_t seed) {
  Draft draft(seed);
  Random& random = draft.random;
  const Frame frame{random.in(66, 128), draft.small ? random.in(2, 9) : random.in(9, 60)};
  Case c = start(draft, frame, {16, 16});
  const int64_t right = int64_t{frame.width_px} * kPixel_fx8;
  const int64_t top = draft.whole_px ? 0 : kPixel_fx8 / 2 - 1;
  const int64_t bottom = draft.whole_px ? draft.place_fx8(1200, 4000) : draft.place_fx8(12, 60);
  set_outline(&c, {{0, top}, {right, top}, {right, bottom}, {0, bottom}});
  const auto tilt = [&](int32_t selvage_vertex::*coordinate) {
    const int32_t whole = random.in(1, 16) * kTexel_fx16;
    const int32_t left = random.in(-1, 1);
    const std::array<int32_t, 4> off = {0, 0, left + 1, left};
    const bool falls = random.percent(50);
    for (size_t k = 0; k < off.size(); ++k) {
      c.vertices[k].*coordinate = whole + (falls ? -off[k] : off[k]);
    }
  };
  tilt(&selvage_vertex::u);
  tilt(&selvage_vertex::v);
  return c;
}

Case make_near_planes(uint64_t seed) {
  Draft draft(seed);
  Random& random = draft.random;
  const Frame frame = screen(draft);
  Case c = start(draft, frame, screen_texture(draft));
  set_outline(&c, quadrilateral(random, frame, draft.grid_fx8()));
  const Slope u = random.pick<Slope>({{2, 0, 1}, {1, 1, 1}, {-1, 1, 1}, {-2, 0, 1}, {0, 1, 1}});
  const Slope v = random.pick<Slope>({{0, 1, 1}, {1, -1, 1}, {1, 0, 1}, {0, -1, 1}});
  map_on_boundaries(&c, u, v);
  const size_t off = random.below(c.vertices.size());
  for (int32_t selvage_vertex::*const coordinate : {&selvage_vertex::u, &selvage_vertex::v}) {
    const int32_t all = random.in(-1, 2);
    for (selvage_vertex& vertex : c.vertices) vertex.*coordinate += all;
    c.vertices[off].*coordinate += random.pick({-3, -2, -1, 1, 2, 3});
  }
  return c;
}

// One texel to a pixel, and all q = 1.
Case make_q_equal_one(uint64_t seed) {
  Draft draft(seed);
  const Frame frame = screen(draft);
  Case c = start(draft, frame, screen_texture(draft));
  set_outline(&c, one_of_few_corners(draft, frame));
  const int32_t u_sign = draft.random.pick({1, 1, -1});
  const int32_t v_sign = draft.random.pick({1, 1, -1});
  map_on_boundaries(&c, {u_sign, 0, 1}, {0, v_sign, 1});
  return c;
}

namespace {

constexpr int32_t kMillion = 1000000;

[[nodiscard]] int32_t random_least_q(Random& random, int32_t ratio) {
  return random.in(1, int64_t{SELVAGE_Q_MAX} / ratio + 1);
}

// A triangle seen whole, its corners near, far and between.
[[nodiscard]] Case triangle_in_depth(Draft& draft, int32_t ratio) {
  const Frame frame = screen(draft);
  Case c = start(draft, frame, screen_texture(draft));
  Outline outline = quadrilateral(draft.random, frame, draft.grid_fx8());
  outline.erase(outline.begin() + draft.random.in(0, 4));
  set_outline(&c, outline);
  map_across(draft, &c);
  const int32_t least = random_least_q(draft.random, ratio);
  const int32_t mean = ratio < 10 ? ratio : ratio / 10;
  const int32_t between = draft.random.in(least, int64_t{least} * mean + 1);
  const size_t first = draft.random.below(3);
  c.vertices[first].q = least;
  c.vertices[(first + 1) % 3].q = between;
  c.vertices[(first + 2) % 3].q = least * ratio;
  return c;
}

// A triangle with its near corner far off to the left. Where q is a million times as great at one
// end, all but the last pixels show that end's texels: so the far side is in the target, and the
// texture long.
[[nodiscard]] Case long_triangle_in_depth(Draft& draft, int32_t ratio) {
  const Frame frame = screen(draft);
  Case c = start(draft, frame, draft.small ? TextureSize{2048, 2} : TextureSize{4096, 16});
  const int64_t near_x = draft.place_fx8(-20000, -8000);
  const int64_t near_y = draft.place_fx8(0, frame.height_px);
  const Point above{draft.place_fx8(frame.width_px * 3 / 4, frame.width_px),
                    draft.place_fx8(-4, 4)};
  const Point below{draft.place_fx8(frame.width_px * 3 / 4, frame.width_px),
                    draft.place_fx8(frame.height_px - 4, frame.height_px + 4)};
  set_outline(&c, {{near_x, near_y}, above, below});
  map_axes(draft, &c);
  const int32_t least = random_least_q(draft.random, ratio);
  c.vertices[0].q = least * ratio;
  c.vertices[1].q = least;
  c.vertices[2].q = least * draft.random.in(1, 4);
  return c;
}

// What a floor that runs to a horizon spans: q grows by `ratio` from its top, `depth` under the
// horizon, to its bottom, and so does its width.
struct Floor {
  int64_t middle, top, half_width, depth;
};

[[nodiscard]] Floor random_floor(Draft& draft, Frame frame, int32_t ratio) {
  const int64_t middle = draft.place_fx8(frame.width_px / 4, frame.width_px * 3 / 4);
  const int64_t top = draft.place_fx8(0, frame.height_px / 4);
  if (ratio == kMillion) return {middle, top, draft.random.in(1, 4), 1};
  if (ratio > 2) return {middle, top, draft.place_fx8(1, 2), draft.place_fx8(1, 1)};
  const int64_t half_width = draft.place_fx8(frame.width_px / 6, frame.width_px / 4);
  return {middle, top, half_width, draft.place_fx8(frame.height_px / 2, frame.height_px * 3 / 4)};
}

// A flat rectangle in space, so its map is projective; or, turned, a wall.
[[nodiscard]] Case floor_in_depth(Draft& draft, int32_t ratio) {
  const Frame frame = screen(draft);
  const TextureSize long_texture = draft.small ? TextureSize{2, 2048} : TextureSize{16, 4096};
  Case c = start(draft, frame, ratio == kMillion ? long_texture : screen_texture(draft));
  const Floor floor = random_floor(draft, frame, ratio);
  const int64_t bottom = floor.top + (ratio - 1) * floor.depth;
  const int64_t wide = ratio * floor.half_width;
  set_outline(&c, {{floor.middle - floor.half_width, floor.top},
                   {floor.middle + floor.half_width, floor.top},
                   {floor.middle + wide, bottom},
                   {floor.middle - wide, bottom}});
  const int32_t least = random_least_q(draft.random, ratio);
  const int32_t u_last = c.texture_width_texel * SELVAGE_SUBTEXELS - draft.random.in(1, 30000);
  const int32_t v_last = c.texture_height_texel * SELVAGE_SUBTEXELS - draft.random.in(1, 30000);
  for (size_t k = 0; k < 4; ++k) {
    c.vertices[k].u = k == 1 || k == 2 ? u_last : 0;
    c.vertices[k].v = k < 2 ? v_last : 0;
    c.vertices[k].q = k < 2 ? least : least * ratio;
  }
  if (draft.random.percent(50)) swap_axes(&c);
  return c;
}

[[nodiscard]] Case make_q_ratio(uint64_t seed, int32_t ratio) {
  Draft draft(seed);
  const bool million = ratio == kMillion;
  const bool is_floor = draft.random.percent(50);
  // A floor of that depth starts 1/256 px under its horizon: off the whole pixels.
  if (is_floor && !(million && draft.whole_px)) return floor_in_depth(draft, ratio);
  return million ? long_triangle_in_depth(draft, ratio) : triangle_in_depth(draft, ratio);
}

}  // namespace

Case make_q_ratio_2(uint64_t seed) { return make_q_ratio(seed, 2); }
Case make_q_ratio_100(uint64_t seed) { return make_q_ratio(seed, 100); }
Case make_q_ratio_million(uint64_t seed) { return make_q_ratio(seed, kMillion); }

}  // namespace selvage::spec
