#include "spec/generate_coordinates.h"

#include <algorithm>
#include <functional>

#include "spec/vertex_units.h"

namespace selvage::spec {
namespace {

constexpr int64_t kOneToOne = SELVAGE_SUBTEXELS / SELVAGE_SUBPIXELS;  // u units for a unit of x

// One coordinate. `along` is the axis of the target it naturally follows, `across` is the other
// one: x and y for u, y and x for v.
struct Place {
  int64_t along_fx8, across_fx8;
};

// A coordinate in 1/65536 texel for each place. It is asked once a vertex, in order; what goes
// beyond int32_t is clamped.
using Rule = std::function<int64_t(const Place&)>;
using MakeRule = Rule (*)(Random&, int32_t size_texel);

// An offset that puts samples on texel boundaries, beside them, in the middle of texels or
// anywhere.
[[nodiscard]] int64_t offset_fx16(Random& random, int32_t size_texel) {
  const int64_t texel = random.in(-1, int64_t{size_texel} + 1);
  const int32_t anywhere = random.in(0, kTexel_fx16);
  return texel * kTexel_fx16 +
         random.pick({0, 0, 32768, 32768, 1, -1, 32767, 32769, 128, anywhere, anywhere});
}

[[nodiscard]] Rule anything(Random& random, int32_t) {
  return [&random](const Place&) {
    return random.in(kLeastCoordinate_fx16, kGreatestCoordinate_fx16 + 1);
  };
}

[[nodiscard]] Rule within_texture(Random& random, int32_t size_texel) {
  return [&random, size_texel](const Place&) {
    const int64_t texel = random.in(0, size_texel);
    return texel * kTexel_fx16 + random.in(0, kTexel_fx16 + 1);
  };
}

[[nodiscard]] Rule on_boundaries(Random& random, int32_t size_texel) {
  return [&random, size_texel](const Place&) {
    return int64_t{kTexel_fx16} * random.in(-2, int64_t{size_texel} + 3);
  };
}

[[nodiscard]] Rule beside_boundaries(Random& random, int32_t size_texel) {
  return [&random, size_texel](const Place&) {
    const int64_t boundary = int64_t{kTexel_fx16} * random.in(-1, int64_t{size_texel} + 2);
    return boundary + random.in(-1, 2);
  };
}

[[nodiscard]] Rule on_halves(Random& random, int32_t size_texel) {
  return [&random, size_texel](const Place&) {
    return int64_t{kTexel_fx16} / 2 * random.in(-2, int64_t{size_texel} * 2 + 3);
  };
}

// One texel to a pixel, along the axis, against it, or along the other one.
[[nodiscard]] Rule one_to_one(Random& random, int32_t size_texel) {
  const int64_t offset = random.percent(40) ? 0 : offset_fx16(random, size_texel);
  const int64_t scale = random.percent(75) ? kOneToOne : -kOneToOne;
  if (random.percent(15)) {
    return [=](const Place& place) { return place.across_fx8 * scale + offset; };
  }
  return [=](const Place& place) { return place.along_fx8 * scale + offset; };
}

// Affine over the whole polygon, exactly; scales from a 256th of a texel a pixel upward.
[[nodiscard]] Rule affine(Random& random, int32_t size_texel) {
  const int32_t reach = random.pick({3, 64, 512, 512, 512, 4096, 65536});
  const int64_t along = random.in(-reach, int64_t{reach} + 1);
  const int64_t across = random.in(-reach, int64_t{reach} + 1);
  const int64_t offset = offset_fx16(random, size_texel);
  return [=](const Place& place) {
    return place.along_fx8 * along + place.across_fx8 * across + offset;
  };
}

// A scale that is a ratio of small numbers: ties come round every few pixels.
[[nodiscard]] Rule small_ratio(Random& random, int32_t size_texel) {
  const int64_t over = random.in(1, 8);
  const int64_t under = random.in(2, 8);
  const int64_t offset = offset_fx16(random, size_texel);
  return [=](const Place& place) { return place.along_fx8 * kOneToOne * over / under + offset; };
}

[[nodiscard]] Rule ends_of_range(Random& random, int32_t) {
  return [&random](const Place&) {
    return random.pick({kLeastCoordinate_fx16, kGreatestCoordinate_fx16, kLeastCoordinate_fx16 + 1,
                        kGreatestCoordinate_fx16 - 1, int64_t{0}});
  };
}

[[nodiscard]] Rule constant(Random& random, int32_t size_texel) {
  const int64_t near = offset_fx16(random, size_texel);
  const int64_t chosen =
      random.pick({near, near, near, int64_t{0}, kLeastCoordinate_fx16, kGreatestCoordinate_fx16});
  return [=](const Place&) { return chosen; };
}

// Hundreds to thousands of texels a pixel.
[[nodiscard]] Rule minified(Random& random, int32_t size_texel) {
  const int32_t scale = random.in(-2000, 2001);
  const int64_t offset = offset_fx16(random, size_texel);
  return [=](const Place& place) { return place.along_fx8 * kOneToOne * scale + offset; };
}

// The whole polygon within a texel, or across the one boundary beside it.
[[nodiscard]] Rule magnified(Random& random, int32_t size_texel) {
  const int64_t base = int64_t{kTexel_fx16} * random.in(0, int64_t{size_texel} + 1);
  const int32_t reach = random.pick({1, 2, 256, 65535});
  const int32_t first = random.percent(30) ? -reach : 0;
  return [&random, base, first, reach](const Place&) {
    return base + random.in(first, int64_t{reach} + 1);
  };
}

constexpr Weighted<MakeRule> kRules[] = {
    {7, anything},      {15, within_texture}, {10, on_boundaries}, {6, beside_boundaries},
    {6, on_halves},     {16, one_to_one},     {12, affine},        {7, small_ratio},
    {5, ends_of_range}, {5, constant},        {5, minified},       {6, magnified}};

// q -------------------------------------------------------------------------------------------

using SetQ = void (*)(Random&, std::span<selvage_vertex>);

void all_equal(Random& random, std::span<selvage_vertex> vertices) {
  const int32_t any = random.in(1, kQMax + 1);
  const int32_t q = random.pick({1, 1, kQMax, any});
  for (selvage_vertex& vertex : vertices) vertex.q = q;
}

// Between a greatest q and that over a ratio.
void in_a_ratio(Random& random, std::span<selvage_vertex> vertices) {
  const int32_t any = random.in(2, kQMax + 1);
  const int32_t greatest = random.pick({kQMax, any, 1 << 16, 1000, 2});
  const int32_t least = std::max(1, greatest / random.pick({2, 2, 100, 1000000}));
  for (selvage_vertex& vertex : vertices) vertex.q = random.in(least, int64_t{greatest} + 1);
}

void at_the_ends(Random& random, std::span<selvage_vertex> vertices) {
  for (selvage_vertex& vertex : vertices) {
    vertex.q = random.pick({1, 1, kQMax, kQMax, 2, kQMax - 1});
  }
}

// All but equal.
void nearly_equal(Random& random, std::span<selvage_vertex> vertices) {
  const int32_t q = random.in(1, kQMax);
  const int32_t base = random.pick({1, kQMax - 1, q});
  for (selvage_vertex& vertex : vertices) vertex.q = base + random.in(0, 2);
}

// A plane over the target, as of a flat polygon in space.
void on_a_plane(Random& random, std::span<selvage_vertex> vertices) {
  const int64_t slope_x = random.in(-500, 501);
  const int64_t slope_y = random.in(-500, 501);
  const int64_t base = random.in(1, kQMax / 4);
  for (selvage_vertex& vertex : vertices) {
    const int64_t q = base + slope_x * vertex.x + slope_y * vertex.y;
    vertex.q = static_cast<int32_t>(std::clamp<int64_t>(q, 1, kQMax));
  }
}

constexpr Weighted<SetQ> kSetQ[] = {
    {60, all_equal}, {18, in_a_ratio}, {8, at_the_ends}, {4, nearly_equal}, {10, on_a_plane}};

}  // namespace

void set_uv(Random& random, std::span<selvage_vertex> vertices, int32_t texture_width_texel,
            int32_t texture_height_texel) {
  const MakeRule make_u = choose<MakeRule>(random, kRules);
  const MakeRule make_v = random.percent(60) ? make_u : choose<MakeRule>(random, kRules);
  const Rule u = make_u(random, texture_width_texel);
  const Rule v = make_v(random, texture_height_texel);
  for (selvage_vertex& vertex : vertices) {
    vertex.u = clamped_coordinate(u({vertex.x, vertex.y}));
    vertex.v = clamped_coordinate(v({vertex.y, vertex.x}));
  }
}

void set_q(Random& random, std::span<selvage_vertex> vertices) {
  choose<SetQ>(random, kSetQ)(random, vertices);
}

}  // namespace selvage::spec
