#include "spec/hard_tools.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "spec/vertex_units.h"

namespace selvage::spec {

int32_t Draft::place_fx8(int32_t first_px, int32_t last_px) {
  const int32_t grid = grid_fx8();
  const int64_t places = int64_t{last_px - first_px} * kPixel_fx8 / grid + 1;
  return first_px * kPixel_fx8 + random.in(0, places) * grid;
}

Case start(Draft& draft, Frame target, TextureSize texture) {
  Case c;
  c.target_width_px = target.width_px;
  c.target_height_px = target.height_px;
  c.texture_width_texel = texture.width_texel;
  c.texture_height_texel = texture.height_texel;
  c.choice = static_cast<uint32_t>(draft.random.bits() >> 32);
  return c;
}

Frame screen(Draft& draft) {
  return draft.small ? draft.random.pick({Frame{24, 24}, Frame{32, 20}, Frame{20, 32}})
                     : draft.random.pick({Frame{128, 96}, Frame{96, 96}, Frame{96, 128}});
}

TextureSize screen_texture(const Draft& draft) {
  return draft.small ? TextureSize{32, 32} : TextureSize{256, 256};
}

void set_outline(Case* c, const Outline& outline) {
  c->vertices.clear();
  for (const Point& point : outline) {
    c->vertices.push_back({static_cast<int32_t>(point.x), static_cast<int32_t>(point.y), 0, 0, 1});
  }
}

Outline quadrilateral(Random& random, Frame frame, int32_t grid_fx8) {
  // Corners within a quarter of either side of the frame's own cannot lie on one line.
  const auto near_fx8 = [&](int32_t size_px, bool at_end) {
    const int32_t places = size_px * kPixel_fx8 / 4 / grid_fx8;
    const int32_t off = random.in(0, int64_t{places} + 1);
    return int64_t{at_end ? size_px * kPixel_fx8 / grid_fx8 - off : off} * grid_fx8;
  };
  const auto corner = [&](bool right, bool bottom) {
    const int64_t x = near_fx8(frame.width_px, right);
    const int64_t y = near_fx8(frame.height_px, bottom);
    return Point{x, y};
  };
  return {corner(false, false), corner(true, false), corner(true, true), corner(false, true)};
}

Outline one_of_few_corners(Draft& draft, Frame frame) {
  Outline outline = quadrilateral(draft.random, frame, draft.grid_fx8());
  if (draft.random.percent(50)) outline.erase(outline.begin() + draft.random.in(0, 4));
  return outline;
}

Outline parallelogram(Point from, Point a, Point b) {
  return {from, from + a, from + a + b, from + b};
}

namespace {

// The texels that an int32_t can reach.
constexpr int32_t kMostTexels = 32768;

[[nodiscard]] std::pair<int32_t, int32_t> range_of(const Case& c, VertexField axis) {
  const auto [least, greatest] = std::ranges::minmax(c.vertices, {}, axis);
  return {least.*axis, greatest.*axis};
}

// One coordinate over at least 7/8 of the texture's side: x_percent of that along the outline's
// width, the rest along its height, each forward or backward.
void spread(Random& random, Case* c, VertexField coordinate, int32_t size_texel, int x_percent) {
  const int64_t whole = int64_t{std::min(size_texel, kMostTexels)} * SELVAGE_SUBTEXELS;
  const int64_t unused = random.in(1, std::min<int64_t>(whole / 8, SELVAGE_SUBTEXELS * 64) + 1);
  const int64_t first = random.in(0, unused);
  const int64_t reach_x = (whole - unused) * x_percent / 100;
  const int64_t reach_y = whole - unused - reach_x;
  const bool backward_x = random.percent(50);
  const bool backward_y = random.percent(50);
  const auto [left, right] = range_of(*c, &selvage_vertex::x);
  const auto [top, bottom] = range_of(*c, &selvage_vertex::y);
  for (selvage_vertex& vertex : c->vertices) {
    const int64_t x = backward_x ? right - vertex.x : vertex.x - left;
    const int64_t y = backward_y ? bottom - vertex.y : vertex.y - top;
    const int64_t along_x = left < right ? reach_x * x / (right - left) : 0;
    const int64_t along_y = top < bottom ? reach_y * y / (bottom - top) : 0;
    vertex.*coordinate = static_cast<int32_t>(first + along_x + along_y);
  }
}

// Whole numbers at centres; gives the texels from 0 that it needs.
[[nodiscard]] int32_t set_slope(Case* c, VertexField coordinate, Slope slope) {
  for (selvage_vertex& vertex : c->vertices) {
    const int32_t x = vertex.x - kHalfPixel_fx8, y = vertex.y - kHalfPixel_fx8;
    vertex.*coordinate = (slope.along_x * x + slope.along_y * y) / slope.under *
                         (SELVAGE_SUBTEXELS / SELVAGE_SUBPIXELS);
  }
  const auto [least, greatest] = range_of(*c, coordinate);
  const int32_t first_texel = least >> 16, last_texel = greatest >> 16;
  for (selvage_vertex& vertex : c->vertices) {
    vertex.*coordinate -= first_texel * SELVAGE_SUBTEXELS;
  }
  return last_texel - first_texel + 1;
}

[[nodiscard]] int32_t power_of_two_from(int32_t size) {
  return static_cast<int32_t>(std::bit_ceil(static_cast<uint32_t>(size)));
}

}  // namespace

void map_across(Draft& draft, Case* c) {
  const bool turned = draft.random.percent(25);
  const int own_percent = draft.random.percent(30) ? 100 : draft.random.in(55, 96);
  const int u_percent = turned ? 100 - own_percent : own_percent;
  spread(draft.random, c, &selvage_vertex::u, c->texture_width_texel, u_percent);
  spread(draft.random, c, &selvage_vertex::v, c->texture_height_texel, 100 - u_percent);
}

void map_axes(Draft& draft, Case* c) {
  spread(draft.random, c, &selvage_vertex::u, c->texture_width_texel, 100);
  spread(draft.random, c, &selvage_vertex::v, c->texture_height_texel, 0);
}

void map_anywhere(Draft& draft, Case* c) {
  const auto within = [&](int32_t size_texel) {
    return draft.random.in(0, int64_t{std::min(size_texel, kMostTexels)} * SELVAGE_SUBTEXELS);
  };
  for (selvage_vertex& vertex : c->vertices) {
    vertex.u = within(c->texture_width_texel);
    vertex.v = within(c->texture_height_texel);
  }
}

void map_about_the_middle(Draft& draft, Case* c) {
  const auto set = [&](VertexField coordinate, int32_t x_scale, int32_t y_scale,
                       int32_t size_texel) {
    const int64_t middle = int64_t{x_scale} * c->target_width_px * kHalfPixel_fx8 +
                           int64_t{y_scale} * c->target_height_px * kHalfPixel_fx8;
    const int64_t offset = int64_t{size_texel} * SELVAGE_SUBTEXELS / 2 - middle;
    for (selvage_vertex& v : c->vertices) {
      const int64_t value = int64_t{x_scale} * v.x + int64_t{y_scale} * v.y + offset;
      v.*coordinate = static_cast<int32_t>(value);
    }
  };
  const int32_t sign = draft.random.pick({1, -1});
  const int32_t along = draft.random.in(80, 161);
  const int32_t across = draft.random.in(-80, 81);
  set(&selvage_vertex::u, sign * along, across, c->texture_width_texel);
  set(&selvage_vertex::v, -across, sign * along, c->texture_height_texel);
}

void map_on_boundaries(Case* c, Slope u, Slope v) {
  c->texture_width_texel = power_of_two_from(set_slope(c, &selvage_vertex::u, u));
  c->texture_height_texel = power_of_two_from(set_slope(c, &selvage_vertex::v, v));
}

void swap_axes(Case* c) {
  std::swap(c->target_width_px, c->target_height_px);
  std::swap(c->texture_width_texel, c->texture_height_texel);
  for (selvage_vertex& vertex : c->vertices) {
    std::swap(vertex.x, vertex.y);
    std::swap(vertex.u, vertex.v);
  }
}

bool covers_a_pixel(const Case& c) {
  for (int32_t y = 0; y < c.target_height_px; ++y) {
    for (int32_t x = 0; x < c.target_width_px; ++x) {
      if (winding_number(pixel_centre(x, y), c.vertices) != 0) return true;
    }
  }
  return false;
}

}  // namespace selvage::spec
