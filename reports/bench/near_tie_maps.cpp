#include "reports/bench/near_tie_maps.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "spec/random.h"
#include "spec/vertex_units.h"

namespace selvage::reports {

namespace {

using spec::kTexel_fx16;
using spec::Random;

constexpr int32_t kMiddle_texel = kMapTexture_texel / 2;

// Corners of a shape, counted from the top left of its box.
struct Place {
  int32_t x_fx8, y_fx8;
};
struct Box {
  int32_t left_px, top_px, width_px, height_px;
};

[[nodiscard]] Box any_box(Random& random) {
  Box box{};
  const int32_t most_px = random.pick({64, 64, 64, 128, kMapHeight_px, kMapWidth_px - 2});
  box.width_px = random.in(2, most_px + 1);
  box.height_px = random.in(4, random.pick({65, kMapHeight_px}));
  box.left_px = random.in(0, kMapWidth_px - box.width_px);
  box.top_px = random.in(0, kMapHeight_px - box.height_px + 1);
  if (random.percent(15)) {
    box.height_px = random.in(300, 30000);
    box.top_px = std::min(random.in(20 - box.height_px, 200), 32000 - box.height_px);
  }
  return box;
}

[[nodiscard]] std::vector<Place> any_corners(Random& random, const Box& box) {
  const int32_t width = box.width_px * SELVAGE_SUBPIXELS,
                height = box.height_px * SELVAGE_SUBPIXELS;
  const bool off_grid = random.percent(25);
  const auto near = [&](int32_t place) {
    return place + (off_grid ? random.in(-SELVAGE_SUBPIXELS / 2, SELVAGE_SUBPIXELS / 2 + 1) : 0);
  };
  const int32_t slant = random.percent(50) ? 0 : random.in(-20, 21) * SELVAGE_SUBPIXELS;
  switch (random.in(0, 4)) {
    case 0:
      return {{0, 0}, {width, near(0)}, {near(0), height}};
    case 1:
      return {{0, 0}, {width, 0}, {width + slant, height}, {slant, height}};
    case 2:
      return {{0, 0}, {near(width), near(0)}, {near(width + slant), near(height)}, {slant, height}};
    default:
      return {{width / 2, 0},
              {near(width), height / 3},
              {near(width / 2), height},
              {0, near(height / 2)}};
  }
}

// Along x and y, in steps of 1/steps texel a pixel.
struct Slope {
  int32_t right, down;
};
struct Lattice {
  int32_t steps;
  Slope u, v;
};

[[nodiscard]] Lattice any_lattice(Random& random) {
  Lattice lattice{random.pick({1, 1, 1, 2, 3, 4, 6, 8, 16, 16, 64}), {}, {}};
  const auto slope = [&] {
    return random.percent(33) ? 0 : random.in(-2 * lattice.steps, 2 * lattice.steps + 1);
  };
  for (Slope* const of : {&lattice.u, &lattice.v}) *of = {slope(), slope()};
  return lattice;
}

// Pixel centres are at whole steps from a whole texel, but for rounding; empty where the texel is
// beyond those of 16 bits.
[[nodiscard]] std::optional<int32_t> texel_at(const Place& corner, const Slope& slope,
                                              int32_t steps) {
  constexpr int64_t kHalfPixel = SELVAGE_SUBPIXELS / 2;
  const int64_t units =
      slope.right * (corner.x_fx8 - kHalfPixel) + slope.down * (corner.y_fx8 - kHalfPixel);
  const double moved_fx16 = static_cast<double>(units) * (kTexel_fx16 / SELVAGE_SUBPIXELS) / steps;
  const int64_t texel_fx16 = kMiddle_texel * kTexel_fx16 + std::llround(moved_fx16);
  constexpr int64_t kMost_fx16 = INT32_MAX - (kMiddle_texel + 2) * kTexel_fx16;
  if (texel_fx16 < -kMost_fx16 || texel_fx16 > kMost_fx16) return std::nullopt;
  return static_cast<int32_t>(texel_fx16);
}

// Lowers u and v by units that take samples from a boundary to just below it, and maybe the map off
// its plane.
void nudge(Random& random, Polygon* polygon) {
  const int32_t kind = random.in(0, 4);
  for (size_t i = 0; i < polygon->size(); ++i) {
    selvage_vertex& vertex = (*polygon)[i];
    if (kind == 1) {
      vertex.u -= random.in(0, 2);
      vertex.v -= random.in(0, 2);
    } else if (kind == 2 ? i == 2 : kind == 3) {
      --vertex.u;
      --vertex.v;
    }
  }
}

void deepen(Random& random, Polygon* polygon) {
  const int32_t kind = random.in(0, 4);
  for (size_t i = 0; i < polygon->size(); ++i) {
    const auto corner = static_cast<int32_t>(i);
    const bool right = corner == 1 || corner == 2;
    const int32_t less[] = {corner == 2 ? 1 : 0, right ? SELVAGE_Q_MAX / 16 : 0,
                            corner * (SELVAGE_Q_MAX / 64) + random.in(0, 4),
                            corner >= 2 ? SELVAGE_Q_MAX / 2 : 0};
    (*polygon)[i].q = SELVAGE_Q_MAX - less[kind];
  }
}

// From the texture's middle, maybe to its first or last texels. Returns whether any were moved.
bool move_to_edge(Random& random, NearTieMap* map) {
  const auto move = [&] {
    return random.pick({0, 0, -kMiddle_texel, kMiddle_texel}) * kTexel_fx16;
  };
  const int32_t u_fx16 = move(), v_fx16 = move();
  const auto shift = [&](Polygon* polygon) {
    for (selvage_vertex& vertex : *polygon) {
      vertex.u += u_fx16;
      vertex.v += v_fx16;
    }
  };
  shift(&map->hard);
  for (Polygon& moved : map->ordinary) shift(&moved);
  return u_fx16 != 0 || v_fx16 != 0;
}

// One for all vertices, as selvage_snap() has it: it cancels, but lengthens what it is a factor of.
void set_great_q(NearTieMap* map) {
  const auto set = [](Polygon* polygon) {
    for (selvage_vertex& vertex : *polygon) vertex.q = SELVAGE_Q_MAX;
  };
  set(&map->hard);
  for (Polygon& moved : map->ordinary) set(&moved);
}

[[nodiscard]] std::optional<NearTieMap> any_map(Random& random) {
  const Box box = any_box(random);
  const std::vector<Place> corners = any_corners(random, box);
  const Lattice lattice = any_lattice(random);
  NearTieMap map;
  for (const Place& corner : corners) {
    const auto u = texel_at(corner, lattice.u, lattice.steps),
               v = texel_at(corner, lattice.v, lattice.steps);
    if (!u || !v) return std::nullopt;
    map.hard.push_back({box.left_px * SELVAGE_SUBPIXELS + corner.x_fx8,
                        box.top_px * SELVAGE_SUBPIXELS + corner.y_fx8, *u, *v, 1});
  }
  nudge(random, &map.hard);
  const bool deep = random.percent(33);
  if (deep) deepen(random, &map.hard);
  for (Polygon& moved : map.ordinary) {
    moved = map.hard;
    const int32_t step_fx16 = kTexel_fx16 / lattice.steps;
    const int32_t u_fx16 = step_fx16 * random.in(20, 45) / 64;
    const int32_t v_fx16 = step_fx16 * random.in(20, 45) / 64;
    for (selvage_vertex& vertex : moved) {
      vertex.u += u_fx16;
      vertex.v += v_fx16;
    }
  }
  const bool at_edge = move_to_edge(random, &map);
  if (random.percent(33)) map.address = SELVAGE_ADDRESS_WRAP;
  const bool great_q = random.percent(50) && !deep;
  if (great_q) set_great_q(&map);
  map.description =
      std::string(corners.size() == 3 ? "triangle" : "quad") + " " + std::to_string(box.width_px) +
      " x " + std::to_string(box.height_px) + " px" +
      (deep      ? ", perspective"
       : great_q ? ", of great q"
                 : "") +
      ", by " + (lattice.steps == 1 ? "a texel" : "1/" + std::to_string(lattice.steps) + " texel") +
      (at_edge ? ", edge" : "") + (map.address == SELVAGE_ADDRESS_WRAP ? ", wrapped" : "");
  return map;
}

}  // namespace

NearTieMap near_tie_map(uint64_t seed) {
  Random random(seed);
  for (;;) {
    if (std::optional<NearTieMap> map = any_map(random)) return *std::move(map);
  }
}

}  // namespace selvage::reports
