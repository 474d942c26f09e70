#include "spec/generate.h"

#include <algorithm>
#include <array>

#include "spec/generate_coordinates.h"
#include "spec/generate_near_ties.h"
#include "spec/generate_shapes.h"
#include "spec/random.h"
#include "spec/vertex_units.h"

namespace selvage::spec {
namespace {

struct Size {
  int32_t width, height;
};

// Rarely: counters and steps that are right for small targets and wrong for these.
[[nodiscard]] Size random_long_target(Random& random) {
  const int32_t length_px = random.pick({129, 257, 1025, 4000});
  return random.pick({Size{length_px, 1}, Size{1, length_px}, Size{length_px, 2}});
}

// Small, for the exact model works through every pixel in rationals.
[[nodiscard]] Size random_target(Random& random) {
  const int kind = random.in(0, 100);
  if (kind < 10) return {random.in(1, 5), random.in(1, 5)};
  if (kind < 15) return {1, random.in(1, 65)};
  if (kind < 20) return {random.in(1, 65), 1};
  if (kind < 24) return {random.in(1, 49), random.in(1, 49)};
  if (kind < 25 && random.percent(40)) return random_long_target(random);
  return {random.in(1, 25), random.in(1, 25)};
}

// Sides that narrow formats, and numbers of 8 to 15 bits, have no room for; few texels all the
// same.
[[nodiscard]] Size random_large_texture(Random& random) {
  const Size size = random.pick({Size{300, 70}, Size{1025, 16}, Size{4097, 4}, Size{20000, 1}});
  return random.percent(50) ? size : Size{size.height, size.width};
}

[[nodiscard]] Size random_texture(Random& random) {
  const int kind = random.in(0, 200);
  if (kind < 1)
    return random.pick({Size{65536, 1}, Size{1, 65536}, Size{32768, 2}, Size{3, 21845}});
  if (kind < 16) return {1, 1};
  if (kind < 24) return {1, random.in(1, 257)};
  if (kind < 32) return {random.in(1, 257), 1};
  if (kind < 42) return random.pick({Size{256, 256}, Size{256, 3}, Size{255, 257}, Size{5, 256}});
  if (kind < 120) return {1 << random.in(0, 7), 1 << random.in(0, 7)};
  return {random.in(1, 65), random.in(1, 65)};
}

struct ClipRange {
  int32_t first_px, end_px;
};

[[nodiscard]] ClipRange partial(Random& random, int32_t size_px) {
  const int32_t a = random.in(0, int64_t{size_px} + 1);
  const int32_t b = random.in(0, int64_t{size_px} + 1);
  return {std::min(a, b), std::max(a, b)};
}

[[nodiscard]] ClipRange one_pixel(Random& random, int32_t size_px) {
  const int32_t at = random.in(0, size_px);
  return {at, at + 1};
}

[[nodiscard]] ClipRange empty(Random& random, int32_t size_px) {
  const int32_t at = random.in(-1, int64_t{size_px} + 2);
  return {at, at};
}

[[nodiscard]] ClipRange inverted(Random& random, int32_t size_px) {
  const int32_t end = random.in(-1, size_px);
  return {random.in(int64_t{end} + 1, int64_t{size_px} + 2), end};
}

// Over one end of the target, over both, or past it.
[[nodiscard]] ClipRange beyond_the_target(Random& random, int32_t size_px) {
  const int32_t inside = random.in(0, int64_t{size_px} + 1);
  const int32_t little = random.in(1, 9);
  return random.pick({ClipRange{-little, inside}, ClipRange{inside, size_px + little},
                      ClipRange{-little, size_px + little}, ClipRange{size_px, size_px + little},
                      ClipRange{-little, 0}, ClipRange{kClipLeast_px, kClipGreatest_px},
                      ClipRange{kClipLeast_px, inside}, ClipRange{inside, kClipGreatest_px}});
}

[[nodiscard]] ClipRange whole(Random&, int32_t size_px) { return {0, size_px}; }

using MakeClipRange = ClipRange (*)(Random&, int32_t size_px);
constexpr Weighted<MakeClipRange> kClipRanges[] = {
    {50, partial}, {16, one_pixel},         {3, empty},
    {3, inverted}, {18, beyond_the_target}, {22, whole}};

void set_clip(Random& random, Case* c) {
  c->has_clip = random.percent(40);
  if (!c->has_clip) return;
  const MakeClipRange make_columns = choose<MakeClipRange>(random, kClipRanges);
  const MakeClipRange make_rows =
      random.percent(40) ? make_columns : choose<MakeClipRange>(random, kClipRanges);
  const ClipRange columns = make_columns(random, c->target_width_px);
  const ClipRange rows = make_rows(random, c->target_height_px);
  c->clip = {columns.first_px, rows.first_px, columns.end_px, rows.end_px};
}

void set_images(Random& random, Case* c) {
  const Size target = random_target(random);
  c->target_width_px = target.width;
  c->target_height_px = target.height;
  const Size texture = random_texture(random);
  c->texture_width_texel = texture.width;
  c->texture_height_texel = texture.height;
  c->format = SELVAGE_RGBA8888;
  if (random.percent(30)) c->format = random.pick({SELVAGE_INDEX8, SELVAGE_RGB565});
  c->address = random.percent(50) ? SELVAGE_ADDRESS_WRAP : SELVAGE_ADDRESS_CLAMP;
  if (random.percent(40)) c->padding_px = random.in(1, 16);
  c->flip_target = random.percent(20);
  c->flip_texture = random.percent(20);
}

// Coordinates on the grid that filters weigh by, or just below it: where they tie at vertices,
// edges and, with even steps, at centres.
void tie_on_grid(Random& random, Case* c) {
  constexpr int32_t kGrid_fx16 = SELVAGE_SUBTEXELS / 256;
  const int32_t miss = random.pick({0, 0, kGrid_fx16 / 2, kGrid_fx16 - 1});
  for (selvage_vertex& v : c->vertices) {
    v.u = (v.u & ~(kGrid_fx16 - 1)) + miss;
    v.v = (v.v & ~(kGrid_fx16 - 1)) + miss;
  }
}

void set_filter(Random& random, Case* c) {
  if (!can_be_filtered(*c) || random.percent(50)) return;
  c->filter = random.pick({SELVAGE_FILTER_FOUR, SELVAGE_FILTER_BILINEAR, SELVAGE_FILTER_AREA});
  if (random.percent(25)) tie_on_grid(random, c);
}

// The same part of a larger texture.
void enlarge_texture(Random& random, Case* c) {
  const Size size = random_large_texture(random);
  for (selvage_vertex& v : c->vertices) {
    v.u = clamped_coordinate(int64_t{v.u} * size.width / c->texture_width_texel);
    v.v = clamped_coordinate(int64_t{v.v} * size.height / c->texture_height_texel);
  }
  c->texture_width_texel = size.width;
  c->texture_height_texel = size.height;
  const auto narrow = random.pick({SELVAGE_INDEX8, SELVAGE_RGB565, SELVAGE_RGBA8888});
  if (c->filter == SELVAGE_FILTER_NEAREST) c->format = narrow;
}

// The polygon grows with it; a clip rectangle stays. The model takes long for large boxes.
void enlarge_target(Random& random, Case* c) {
  const int32_t short_px = c->filter == SELVAGE_FILTER_AREA ? 4 : 40;
  const Size size = random.pick({Size{140, short_px}, Size{short_px, 140}, Size{75, 2 * short_px}});
  for (selvage_vertex& v : c->vertices) {
    v.x = clamped_position(int64_t{v.x} * size.width / c->target_width_px);
    v.y = clamped_position(int64_t{v.y} * size.height / c->target_height_px);
  }
  c->target_width_px = size.width;
  c->target_height_px = size.height;
}

}  // namespace

Case generate(uint64_t seed) {
  Random random(seed);
  Case c;
  set_images(random, &c);
  set_clip(random, &c);
  const Frame frame{c.target_width_px, c.target_height_px};
  for (const Point& point : random_outline(random, frame)) {
    c.vertices.push_back({static_cast<int32_t>(point.x), static_cast<int32_t>(point.y), 0, 0, 1});
  }
  set_uv(random, c.vertices, c.texture_width_texel, c.texture_height_texel);
  set_q(random, c.vertices);
  if (c.vertices.size() == 3 && random.percent(30)) graze_a_texel(random, frame, c.vertices);
  c.choice = static_cast<uint32_t>(random.bits() >> 32);
  set_filter(random, &c);
  if (random.percent(50)) c.layout = random.pick({Layout::kPadded, Layout::kTiled, Layout::kTiled});
  if (random.percent(6)) enlarge_texture(random, &c);
  if (random.percent(c.filter == SELVAGE_FILTER_AREA ? 5 : 1)) enlarge_target(random, &c);
  return c;
}

}  // namespace selvage::spec
