// Laws of the mapping: VERT, MAP, GAMUT, IDENTITY.
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "spec/geometry.h"
#include "spec/law_list.h"
#include "spec/law_tools.h"

namespace selvage::spec {
namespace {

[[nodiscard]] uint32_t texel_value(const Case& c, const Sample& point) {
  const Texel texel =
      nearest_texel(point, c.texture_width_texel, c.texture_height_texel, c.address);
  return coordinate_texel(c.format, texel.s, texel.t);
}

// (u, v) of a point on the segment a b, from its two ends alone.
[[nodiscard]] Sample sample_on_edge(Point p, const selvage_vertex& a, const selvage_vertex& b) {
  Rational t = a.y != b.y ? Rational(p.y - a.y, int64_t{b.y} - a.y)
                          : Rational(p.x - a.x, int64_t{b.x} - a.x);
  t.canonicalize();
  const Rational q = a.q + t * (b.q - a.q);
  const auto mix = [&](int32_t from, int32_t to) {
    const Rational from_q = Rational(from) * a.q, to_q = Rational(to) * b.q;
    return Rational((from_q + t * (to_q - from_q)) / q / SELVAGE_SUBTEXELS);
  };
  return {mix(a.u, b.u), mix(a.v, b.v)};
}

// Judges the drawn pixels of a triangle whose centres lie on one of its edges or vertices.
[[nodiscard]] Judgement judge_outline(const Subject& subject, const Case& triangle) {
  const Picture picture = draw(subject, triangle);
  const auto& v = triangle.vertices;
  return compare("VERT", "a pixel on an edge or vertex shows what the edge's two ends say",
                 triangle, picture, [&](int32_t x, int32_t y) {
                   if (!picture.at(x, y)) return unjudged();
                   const Point p = pixel_centre(x, y);
                   for (size_t k = 0; k < 3; ++k) {
                     const selvage_vertex &a = v[k], &b = v[(k + 1) % 3];
                     if (position(a) == position(b) || !on_segment(p, position(a), position(b)))
                       continue;
                     return must_be(texel_value(triangle, sample_on_edge(p, a, b)));
                   }
                   return unjudged();
                 });
}

// The triangle turned by `quarters` quarter turns about its first vertex.
[[nodiscard]] std::optional<std::vector<selvage_vertex>> turned(
    const std::array<selvage_vertex, 3>& triangle, int quarters) {
  std::vector<selvage_vertex> result(triangle.begin(), triangle.end());
  for (selvage_vertex& v : result) {
    int64_t dx = int64_t{v.x} - triangle[0].x, dy = int64_t{v.y} - triangle[0].y;
    for (int i = 0; i < quarters; ++i) dx = std::exchange(dy, dx) * -1;
    const int64_t x = triangle[0].x + dx, y = triangle[0].y + dy;
    if (std::min(x, y) < SELVAGE_X_MIN || std::max(x, y) >= SELVAGE_X_END) return std::nullopt;
    v.x = static_cast<int32_t>(x);
    v.y = static_cast<int32_t>(y);
  }
  return result;
}

// The triangle on the other side of the edge from vertex 0 to vertex 1: what it shows on that edge
// must not depend on which of the two owns a pixel, nor on the third corner.
[[nodiscard]] std::optional<std::array<selvage_vertex, 3>> twin_across_edge(
    const std::array<selvage_vertex, 3>& triangle) {
  const auto& [a, b, c] = triangle;
  const int64_t x = int64_t{a.x} + b.x - c.x, y = int64_t{a.y} + b.y - c.y;
  if (std::min(x, y) < SELVAGE_X_MIN || std::max(x, y) >= SELVAGE_X_END) return std::nullopt;
  return std::array{
      a, b, selvage_vertex{static_cast<int32_t>(x), static_cast<int32_t>(y), c.v, c.u, c.q}};
}

}  // namespace

// A corner with its neighbours, moved so that the corner lies on a sample point of the target, and
// its twin, in four quarter turns, so that every side of a corner and of an edge is drawn in one.
Judgement check_vert(const Subject& subject, const Case& c) {
  const size_t count = c.vertices.size();
  if (count < 3) return {};
  Choices choices(c.choice);
  Judgement judgement;
  const auto k = static_cast<size_t>(choices.pick(0, static_cast<int32_t>(count)));
  const Point sample_point = choose_pixel(c, choices).centre();
  const selvage_vertex& corner = c.vertices[k];
  const std::array corners = {corner, c.vertices[(k + 1) % count],
                              c.vertices[(k + count - 1) % count]};
  const auto placed = moved(corners, sample_point.x - corner.x, sample_point.y - corner.y);
  if (!placed) return judgement;
  const std::array<selvage_vertex, 3> triangle = {(*placed)[0], (*placed)[1], (*placed)[2]};
  for (const auto& side : {std::optional(triangle), twin_across_edge(triangle)}) {
    for (int quarters = 0; side && quarters < 4; ++quarters) {
      const auto outline = turned(*side, quarters);
      if (!outline) continue;
      if (add(&judgement, judge_outline(subject, with_vertices(c, *outline)))) return judgement;
    }
  }
  return judgement;
}

Judgement check_map(const Subject& subject, const Case& c) {
  if (!is_valid(c)) return {};
  const Picture model = expected(c);
  const Picture drawn = draw(subject, c);
  return compare("MAP", "a drawn pixel shows the texel that holds its exact (u, v)", c, drawn,
                 [&](int32_t x, int32_t y) {
                   if (!model.at(x, y) || !drawn.at(x, y)) return unjudged();
                   return must_be(model.at(x, y));
                 });
}

namespace {

// The texels along one axis that coordinates from `least` to `greatest` (16.16) can reach.
struct Gamut {
  int32_t first, last, size;
  selvage_address address;

  [[nodiscard]] bool holds(int32_t texel) const {
    if (texel < 0 || texel >= size) return false;
    if (address == SELVAGE_ADDRESS_CLAMP) {
      return std::clamp(first, 0, size - 1) <= texel && texel <= std::clamp(last, 0, size - 1);
    }
    const int32_t from_first =
        address_texel(texel - address_texel(first, size, address), size, SELVAGE_ADDRESS_WRAP);
    return from_first <= last - first;
  }
  [[nodiscard]] std::string text() const {
    return std::to_string(first) + " .. " + std::to_string(last);
  }
};

[[nodiscard]] Gamut gamut_of(const Case& c, int32_t selvage_vertex::*axis, int32_t size) {
  const auto [least, greatest] = std::ranges::minmax(c.vertices, {}, axis);
  return {least.*axis >> 16, greatest.*axis >> 16, size, c.address};
}

}  // namespace

Judgement check_gamut(const Subject& subject, const Case& c) {
  if (!is_valid(c)) return {};
  const Gamut s = gamut_of(c, &selvage_vertex::u, c.texture_width_texel);
  const Gamut t = gamut_of(c, &selvage_vertex::v, c.texture_height_texel);
  const Picture drawn = draw(subject, c);
  Judgement judgement;
  for (int32_t y = 0; y < c.target_height_px; ++y) {
    for (int32_t x = 0; x < c.target_width_px; ++x) {
      const std::optional<uint32_t>& pixel = drawn.at(x, y);
      const std::optional<Texel> texel = pixel ? read_texel(c, *pixel) : std::nullopt;
      if (!texel) continue;
      ++judgement.judged_px;
      if (s.holds(texel->s) && t.holds(texel->t)) continue;
      judgement.violation =
          violation_at("GAMUT", "a texel lies within the range of the polygon's own coordinates", c,
                       x, y, "columns " + s.text() + ", rows " + t.text() + ", addressed", pixel);
      return judgement;
    }
  }
  return judgement;
}

// The rectangle's corner is anywhere on the grid; u - x and v - y are whole texels.
Judgement check_identity(const Subject& subject, const Case& c) {
  Choices choices(c.choice);
  const auto pick_side = [&](int32_t size_px) {
    const int32_t reach = std::min(size_px + 2, 8192) * SELVAGE_SUBPIXELS;
    const int32_t a = choices.pick(-2 * SELVAGE_SUBPIXELS, reach);
    return std::pair(a, a + choices.pick(0, reach));
  };
  const auto [left, right] = pick_side(c.target_width_px);
  const auto [top, bottom] = pick_side(c.target_height_px);
  const int32_t ds = choices.pick(-c.texture_width_texel, c.texture_width_texel + 1) % 1024;
  const int32_t dt = choices.pick(-c.texture_height_texel, c.texture_height_texel + 1) % 1024;
  const auto corner = [&](int32_t x, int32_t y) {
    return selvage_vertex{x, y, x * 256 + ds * SELVAGE_SUBTEXELS, y * 256 + dt * SELVAGE_SUBTEXELS,
                          1 + static_cast<int32_t>(c.choice % SELVAGE_Q_MAX)};
  };
  const Case shown = with_vertices(
      c, {corner(left, top), corner(right, top), corner(right, bottom), corner(left, bottom)});
  const auto covers = [](int32_t begin_fx8, int32_t end_fx8, int32_t index_px) {
    const int32_t centre_fx8 = index_px * SELVAGE_SUBPIXELS + SELVAGE_SUBPIXELS / 2;
    return begin_fx8 <= centre_fx8 && centre_fx8 < end_fx8;
  };
  return compare("IDENTITY", "an axis-aligned one-to-one rectangle is a block copy", shown,
                 draw(subject, shown), [&](int32_t x, int32_t y) {
                   const bool clipped = c.has_clip && (x < c.clip.left || c.clip.right <= x ||
                                                       y < c.clip.top || c.clip.bottom <= y);
                   if (clipped || !covers(left, right, x) || !covers(top, bottom, y))
                     return must_be(std::nullopt);
                   return must_be(coordinate_texel(
                       c.format, address_texel(x + ds, c.texture_width_texel, c.address),
                       address_texel(y + dt, c.texture_height_texel, c.address)));
                 });
}

}  // namespace selvage::spec
