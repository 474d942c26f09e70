#include "spec/generate_blocks.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "spec/vertex_units.h"

namespace selvage::spec {
namespace {

constexpr int32_t kLongestBlock_px = 1024, kGreatest_texel = 1024;

// One axis: a position and the texture coordinate that follows it.
struct Axis {
  VertexField position, texel;
};
constexpr Axis kAxes[] = {{&selvage_vertex::x, &selvage_vertex::u},
                          {&selvage_vertex::y, &selvage_vertex::v}};

struct BlockSide {
  int32_t begin_px, end_px;
};

// The whole target, or begun or ended within it: what steps lose shows at the far end.
[[nodiscard]] BlockSide random_side(Random& random, int32_t size_px) {
  if (random.percent(35)) return {0, size_px};
  const int32_t length_px = random.in(1, random.percent(60) ? size_px + 2 : kLongestBlock_px);
  const int32_t inside_px = random.in(0, int64_t{size_px} + 1);
  return random.percent(40) ? BlockSide{inside_px, inside_px + length_px}
                            : BlockSide{inside_px - length_px, inside_px};
}

// From the side's first pixel to a texel, mostly one of the texture.
[[nodiscard]] int32_t random_shift(Random& random, const BlockSide& side, int32_t size_texel) {
  return random.in(-2, std::min(size_texel, kGreatest_texel) + 1) - side.begin_px;
}

// Clockwise from the top left. With as many texel centres as pixels, where texels lie about whole
// u, the far side is at the last one; seldom it is so in another profile, or not so in that one.
[[nodiscard]] Vertices block(Random& random, const Case& c) {
  const BlockSide columns = random_side(random, c.target_width_px);
  const BlockSide rows = random_side(random, c.target_height_px);
  const int32_t ds = random_shift(random, columns, c.texture_width_texel);
  const int32_t dt = random_shift(random, rows, c.texture_height_texel);
  const bool last_centre = (c.profile == SELVAGE_PROFILE_ABRASH57) != random.percent(15);
  const int32_t far_texel = last_centre ? 1 : 0;
  const auto corner = [&](bool right, bool bottom) {
    const int32_t x_px = right ? columns.end_px : columns.begin_px;
    const int32_t y_px = bottom ? rows.end_px : rows.begin_px;
    return selvage_vertex{x_px * kPixel_fx8, y_px * kPixel_fx8,
                          (x_px + ds - (right ? far_texel : 0)) * kTexel_fx16,
                          (y_px + dt - (bottom ? far_texel : 0)) * kTexel_fx16, 1};
  };
  return {corner(false, false), corner(true, false), corner(true, true), corner(false, true)};
}

// What makes a block something else -----------------------------------------------------------

void change_a_texel(Random& random, const Axis& axis, Vertices& outline) {
  const int32_t distance_fx16 =
      random.pick({1, kTexel_fx16 / 2, kTexel_fx16, 3 * kTexel_fx16, 9 * kTexel_fx16});
  const int32_t sign = random.pick({1, -1});
  outline[random.below(outline.size())].*axis.texel += sign * distance_fx16;
}

void lie_between_texels(Random& random, const Axis& axis, Vertices& outline) {
  const int32_t distance_fx16 = random.pick({1, -1, kTexel_fx16 / 2, kTexel_fx16 / 2 + 1});
  for (selvage_vertex& v : outline) v.*axis.texel += distance_fx16;
}

// A corner goes elsewhere and takes its texel along.
void move_a_corner(Random& random, const Axis& axis, Vertices& outline) {
  const int32_t distance_px = random.pick({1, 2, 3, 5, 9, -1, -2, -3, -5, -9});
  selvage_vertex& corner = outline[random.below(outline.size())];
  corner.*axis.position += distance_px * kPixel_fx8;
  corner.*axis.texel += distance_px * kTexel_fx16;
}

// Steps along a span, or down an edge, are a unit more or less than a texel, or than nothing.
void tilt(Random& random, const Axis& axis, Vertices& outline) {
  const auto [least, greatest] = std::ranges::minmax(outline, {}, axis.position);
  const int32_t far_fx8 = greatest.*axis.position;
  const int32_t length_px = (far_fx8 - least.*axis.position) / kPixel_fx8;
  const int32_t unit = random.pick({1, -1});
  const auto texel = random.percent(60) ? axis.texel : random.pick(kAxes).texel;
  for (selvage_vertex& v : outline) {
    if (v.*axis.position == far_fx8) v.*texel += unit * length_px;
  }
}

// Of one corner.
void exchange_u_and_v(Random& random, const Axis&, Vertices& outline) {
  selvage_vertex& corner = outline[random.below(outline.size())];
  std::swap(corner.u, corner.v);
}

void reverse(Random&, const Axis&, Vertices& outline) { std::ranges::reverse(outline); }

// A fifth corner on the left side, off it or with a texel of its own.
void bend_the_left_side(Random& random, const Axis& axis, Vertices& outline) {
  selvage_vertex middle = outline.back();
  const int32_t height_px = (middle.y - outline.front().y) / kPixel_fx8;
  const int32_t up_px = random.in(0, height_px + 1);
  middle.y -= up_px * kPixel_fx8;
  middle.*axis.texel -= random.in(0, 8) * kTexel_fx16;
  if (random.percent(50)) middle.x -= random.in(1, 8) * kPixel_fx8;
  outline.push_back(middle);
}

using Spoil = void (*)(Random&, const Axis&, Vertices&);
constexpr Weighted<Spoil> kSpoils[] = {{4, change_a_texel},    {2, lie_between_texels},
                                       {4, move_a_corner},     {6, tilt},
                                       {1, exchange_u_and_v},  {1, reverse},
                                       {2, bend_the_left_side}};

}  // namespace

void make_block(Random& random, Case* c) {
  c->vertices = block(random, *c);
  if (random.percent(60)) {
    const Axis axis = random.pick(kAxes);
    choose<Spoil>(random, kSpoils)(random, axis, c->vertices);
  }
  const auto first = static_cast<std::ptrdiff_t>(random.below(c->vertices.size()));
  std::ranges::rotate(c->vertices, c->vertices.begin() + first);
}

}  // namespace selvage::spec
