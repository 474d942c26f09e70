// The generator reaches what it is meant to reach, in sane shares of its cases.
#include "spec/generate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "spec/exact.h"
#include "spec/geometry.h"

namespace selvage::spec {
namespace {

constexpr int32_t kTexel = SELVAGE_SUBTEXELS;

using Predicate = std::function<bool(const Case&)>;

struct Share {
  const char* what;
  double least_percent, most_percent;
  Predicate holds;
};

void expect_shares(std::span<const Share> shares) {
  std::vector<Case> cases;
  for (uint64_t seed = 0; seed < 6000; ++seed) cases.push_back(generate(seed));
  for (const Share& share : shares) {
    const auto count = std::count_if(cases.begin(), cases.end(), share.holds);
    const double percent = 100.0 * static_cast<double>(count) / static_cast<double>(cases.size());
    EXPECT_GE(percent, share.least_percent) << share.what;
    EXPECT_LE(percent, share.most_percent) << share.what;
  }
}

[[nodiscard]] bool any_vertex(const Case& c, const std::function<bool(const selvage_vertex&)>& is) {
  return std::any_of(c.vertices.begin(), c.vertices.end(), is);
}

[[nodiscard]] bool all_vertices(const Case& c,
                                const std::function<bool(const selvage_vertex&)>& are) {
  return !c.vertices.empty() && std::all_of(c.vertices.begin(), c.vertices.end(), are);
}

// A vertex, the next one and the one after it.
[[nodiscard]] bool any_corner(const Case& c, const std::function<bool(Point, Point, Point)>& is) {
  const size_t n = c.vertices.size();
  for (size_t i = 0; n >= 3 && i < n; ++i) {
    if (is(position(c.vertices[i]), position(c.vertices[(i + 1) % n]),
           position(c.vertices[(i + 2) % n]))) {
      return true;
    }
  }
  return false;
}

[[nodiscard]] bool is_drawable(const Case& c) { return validity(c.vertices) == SELVAGE_OK; }

[[nodiscard]] int64_t doubled_area_of(const Case& c) {
  int64_t sum = 0;
  for (size_t i = 2; i < c.vertices.size(); ++i) {
    sum +=
        doubled_area(position(c.vertices[0]), position(c.vertices[i - 1]), position(c.vertices[i]));
  }
  return sum;
}

// Every turn is to one side and the outline goes round once.
[[nodiscard]] bool turns_one_way(const Case& c) {
  int64_t least = 0, greatest = 0;
  (void)any_corner(c, [&](Point p, Point q, Point r) {
    least = std::min(least, doubled_area(p, q, r));
    greatest = std::max(greatest, doubled_area(p, q, r));
    return false;
  });
  return is_drawable(c) && (least < 0) != (greatest < 0);
}

[[nodiscard]] bool has_tie(const Case& c) {
  for (int32_t y = 0; y < c.target_height_px; ++y) {
    for (int32_t x = 0; x < c.target_width_px; ++x) {
      if (on_outline(pixel_centre(x, y), c.vertices)) return true;
    }
  }
  return false;
}

[[nodiscard]] bool is_affine(const Case& c) {
  return all_vertices(c, [&](const selvage_vertex& v) { return v.q == c.vertices[0].q; });
}

[[nodiscard]] int32_t q_ratio(const Case& c) {
  if (c.vertices.empty()) return 1;
  int32_t least = SELVAGE_Q_MAX, greatest = 1;
  for (const selvage_vertex& v : c.vertices) {
    least = std::min(least, v.q);
    greatest = std::max(greatest, v.q);
  }
  return greatest / least;
}

[[nodiscard]] int64_t clip_width(const Case& c) { return int64_t{c.clip.right} - c.clip.left; }
[[nodiscard]] int64_t clip_height(const Case& c) { return int64_t{c.clip.bottom} - c.clip.top; }

[[nodiscard]] bool is_off_target(const Case& c) {
  const auto beyond = [&](auto&& is) { return all_vertices(c, is); };
  return beyond([&](const selvage_vertex& v) { return v.x >= c.target_width_px * 256; }) ||
         beyond([&](const selvage_vertex& v) { return v.y >= c.target_height_px * 256; }) ||
         beyond([](const selvage_vertex& v) { return v.x <= 0; }) ||
         beyond([](const selvage_vertex& v) { return v.y <= 0; });
}

// A span of u over the vertices, texels.
[[nodiscard]] double u_extent_texel(const Case& c) {
  if (c.vertices.empty()) return -1;
  const auto [least, greatest] = std::minmax_element(
      c.vertices.begin(), c.vertices.end(), [](const auto& a, const auto& b) { return a.u < b.u; });
  return (static_cast<double>((*greatest).u) - (*least).u) / kTexel;
}

[[nodiscard]] bool is_far(const selvage_vertex& v) {
  return std::abs(v.x) > 4096 * 256 || std::abs(v.y) > 4096 * 256;
}

const Share kOutlines[] = {
    {"drawable", 88, 97, is_drawable},
    {"too few vertices", 0.4, 3, [](const Case& c) { return c.vertices.size() < 3; }},
    {"no vertex", 0.1, 1, [](const Case& c) { return c.vertices.empty(); }},
    {"not monotone", 3, 9,
     [](const Case& c) { return validity(c.vertices) == SELVAGE_ERROR_NOT_MONOTONE; }},
    {"triangles", 25, 50, [](const Case& c) { return c.vertices.size() == 3; }},
    {"4 .. 12 vertices", 35, 70,
     [](const Case& c) { return c.vertices.size() >= 4 && c.vertices.size() <= 12; }},
    {"13 .. 64 vertices", 2, 15,
     [](const Case& c) { return c.vertices.size() >= 13 && c.vertices.size() <= 64; }},
    {"more than 64 vertices", 0.1, 2, [](const Case& c) { return c.vertices.size() > 64; }},
    {"convex with more than 4", 5, 40,
     [](const Case& c) { return c.vertices.size() > 4 && turns_one_way(c); }},
    {"drawable, not convex", 10, 60,
     [](const Case& c) { return is_drawable(c) && !turns_one_way(c) && doubled_area_of(c) != 0; }},
    {"no area", 2, 20,
     [](const Case& c) { return c.vertices.size() >= 3 && doubled_area_of(c) == 0; }},
    {"the least area", 0.3, 5, [](const Case& c) { return std::abs(doubled_area_of(c)) == 1; }},
    {"clockwise", 30, 60, [](const Case& c) { return doubled_area_of(c) > 0; }},
    {"anticlockwise", 30, 60, [](const Case& c) { return doubled_area_of(c) < 0; }},
    {"a sample on the outline", 20, 90, has_tie},
    {"a vertex on a sample", 10, 90,
     [](const Case& c) {
       return any_vertex(
           c, [](const selvage_vertex& v) { return (v.x & 255) == 128 && (v.y & 255) == 128; });
     }},
    {"a vertex beside a sample row", 5, 90,
     [](const Case& c) {
       return any_vertex(
           c, [](const selvage_vertex& v) { return (v.y & 255) == 127 || (v.y & 255) == 129; });
     }},
    {"all on the half-pixel grid", 10, 60,
     [](const Case& c) {
       return all_vertices(c, [](const selvage_vertex& v) { return ((v.x | v.y) & 127) == 0; });
     }},
    {"repeated vertices", 5, 40,
     [](const Case& c) { return any_corner(c, [](Point p, Point q, Point) { return p == q; }); }},
    {"collinear runs", 5, 50,
     [](const Case& c) {
       return any_corner(c, [](Point p, Point q, Point r) {
         return p != q && q != r && p.x != q.x && p.y != q.y && doubled_area(p, q, r) == 0;
       });
     }},
    {"horizontal edges", 20, 70,
     [](const Case& c) {
       return any_corner(c, [](Point p, Point q, Point) { return p.y == q.y && p.x != q.x; });
     }},
    {"ledges: out and down again", 3, 40,
     [](const Case& c) {
       const size_t n = is_drawable(c) ? c.vertices.size() : 0;
       for (size_t i = 0; i < n; ++i) {
         const int64_t y[] = {c.vertices[i].y, c.vertices[(i + 1) % n].y, c.vertices[(i + 2) % n].y,
                              c.vertices[(i + 3) % n].y};
         if (y[0] < y[1] && y[1] == y[2] && y[2] < y[3]) return true;
       }
       return false;
     }},
    {"low edges over a row of centres", 1, 20,
     [](const Case& c) {
       return is_drawable(c) && any_corner(c, [](Point p, Point q, Point) {
                const int64_t top = std::min(p.y, q.y), bottom = std::max(p.y, q.y);
                const int64_t to_centre = (128 - top) & 255;
                return bottom - top <= 16 && top + to_centre < bottom && p.x != q.x;
              });
     }},
    {"far-off vertices", 4, 15, [](const Case& c) { return any_vertex(c, is_far); }},
    {"vertices at the ends", 1, 10,
     [](const Case& c) {
       return any_vertex(c, [](const selvage_vertex& v) {
         return v.x == SELVAGE_X_MIN || v.x == SELVAGE_X_END - 1;
       });
     }},
    {"far-off and drawn upon", 1, 15,
     [](const Case& c) {
       return any_vertex(c, is_far) && is_drawable(c) &&
              sample(c.vertices, c.target_width_px / 2, c.target_height_px / 2).has_value();
     }},
    {"wholly off the target", 2, 20, is_off_target},
    {"less than a pixel high", 2, 25, [](const Case& c) {
       const auto [top, bottom] =
           std::minmax_element(c.vertices.begin(), c.vertices.end(),
                               [](const auto& a, const auto& b) { return a.y < b.y; });
       return c.vertices.size() >= 3 && bottom->y - top->y < 256 && bottom->y != top->y;
     }}};

const Share kMaps[] = {
    {"affine", 50, 70, is_affine},
    {"q all 1", 15, 50,
     [](const Case& c) {
       return all_vertices(c, [](const selvage_vertex& v) { return v.q == 1; });
     }},
    {"q all greatest", 5, 30,
     [](const Case& c) {
       return all_vertices(c, [](const selvage_vertex& v) { return v.q == SELVAGE_Q_MAX; });
     }},
    {"ratio of q up to 2", 5, 40,
     [](const Case& c) { return !is_affine(c) && q_ratio(c) <= 2 && !c.vertices.empty(); }},
    {"ratio of q 3 .. 1000", 3, 40,
     [](const Case& c) { return q_ratio(c) >= 3 && q_ratio(c) <= 1000; }},
    {"ratio of q above 10^5", 3, 30, [](const Case& c) { return q_ratio(c) > 100000; }},
    {"u all on texel boundaries", 8, 60,
     [](const Case& c) {
       return all_vertices(c, [](const selvage_vertex& v) { return v.u % kTexel == 0; });
     }},
    {"u all on halves, not all whole", 1, 30,
     [](const Case& c) {
       return all_vertices(c, [](const selvage_vertex& v) { return v.u % (kTexel / 2) == 0; }) &&
              any_vertex(c, [](const selvage_vertex& v) { return v.u % kTexel != 0; });
     }},
    {"u one to one", 5, 40,
     [](const Case& c) {
       return c.vertices.size() >= 3 && all_vertices(c, [&](const selvage_vertex& v) {
                return int64_t{v.u} - c.vertices[0].u == 256 * (int64_t{v.x} - c.vertices[0].x);
              });
     }},
    {"u and v one to one", 2, 30,
     [](const Case& c) {
       return u_extent_texel(c) > 0 && all_vertices(c, [&](const selvage_vertex& v) {
                const selvage_vertex& w = c.vertices[0];
                return int64_t{v.u} - w.u == 256 * (int64_t{v.x} - w.x) &&
                       int64_t{v.v} - w.v == 256 * (int64_t{v.y} - w.y);
              });
     }},
    {"u at an end of its range", 3, 30,
     [](const Case& c) {
       return any_vertex(c, [](const selvage_vertex& v) {
         return v.u == std::numeric_limits<int32_t>::min() ||
                v.u == std::numeric_limits<int32_t>::max();
       });
     }},
    {"u constant", 3, 20, [](const Case& c) { return u_extent_texel(c) == 0; }},
    {"u within a texel, not constant", 2, 20,
     [](const Case& c) { return u_extent_texel(c) > 0 && u_extent_texel(c) < 1; }},
    {"u over more than 10 000 texels", 5, 40,
     [](const Case& c) { return u_extent_texel(c) > 10000; }},
    {"negative u", 10, 60,
     [](const Case& c) { return any_vertex(c, [](const selvage_vertex& v) { return v.u < 0; }); }}};

const Share kImages[] = {
    {"RGBA8888", 60, 80, [](const Case& c) { return c.format == SELVAGE_RGBA8888; }},
    {"RGB565", 8, 25, [](const Case& c) { return c.format == SELVAGE_RGB565; }},
    {"INDEX8", 8, 25, [](const Case& c) { return c.format == SELVAGE_INDEX8; }},
    {"wrap", 40, 60, [](const Case& c) { return c.address == SELVAGE_ADDRESS_WRAP; }},
    {"padding", 25, 60, [](const Case& c) { return c.padding_px > 0; }},
    {"prepared in rows", 10, 25, [](const Case& c) { return c.layout == Layout::kPadded; }},
    {"prepared in tiles", 25, 45, [](const Case& c) { return c.layout == Layout::kTiled; }},
    {"target upside down", 10, 40, [](const Case& c) { return c.flip_target; }},
    {"texture upside down", 10, 40, [](const Case& c) { return c.flip_texture; }},
    {"target one pixel wide", 3, 20, [](const Case& c) { return c.target_width_px == 1; }},
    {"target one pixel high", 3, 20, [](const Case& c) { return c.target_height_px == 1; }},
    {"target of at most 24 a side", 80, 99,
     [](const Case& c) { return c.target_width_px <= 24 && c.target_height_px <= 24; }},
    {"target of more than 128 a side", 0.1, 2,
     [](const Case& c) { return c.target_width_px > 128 || c.target_height_px > 128; }},
    {"target of more than 32 a side", 0.5, 10,
     [](const Case& c) { return c.target_width_px > 32 || c.target_height_px > 32; }},
    {"target too large for the exact model", 0, 0,
     [](const Case& c) { return c.target_width_px * c.target_height_px > 8000; }},
    {"texture of one texel", 3, 20,
     [](const Case& c) { return c.texture_width_texel * c.texture_height_texel == 1; }},
    {"texture of powers of two", 30, 80,
     [](const Case& c) {
       return (c.texture_width_texel & (c.texture_width_texel - 1)) == 0 &&
              (c.texture_height_texel & (c.texture_height_texel - 1)) == 0;
     }},
    {"texture of odd sizes", 5, 60,
     [](const Case& c) {
       return c.texture_width_texel % 2 == 1 && c.texture_height_texel % 2 == 1;
     }},
    {"the largest textures", 0.1, 3, [](const Case& c) {
       return c.texture_width_texel >= 32768 || c.texture_height_texel >= 21845;
     }}};

const Share kClips[] = {
    {"clip", 35, 45, [](const Case& c) { return c.has_clip; }},
    {"clip of one pixel", 0.3, 5,
     [](const Case& c) { return c.has_clip && clip_width(c) == 1 && clip_height(c) == 1; }},
    {"empty clip", 0.5, 10,
     [](const Case& c) { return c.has_clip && (clip_width(c) == 0 || clip_height(c) == 0); }},
    {"inverted clip", 0.5, 10,
     [](const Case& c) { return c.has_clip && (clip_width(c) < 0 || clip_height(c) < 0); }},
    {"clip beyond the target", 3, 20,
     [](const Case& c) {
       return c.has_clip &&
              (c.clip.left < 0 || c.clip.top < 0 || c.clip.right > c.target_width_px ||
               c.clip.bottom > c.target_height_px);
     }},
    {"clip at the ends of its range", 1, 15,
     [](const Case& c) { return c.has_clip && (c.clip.left == -32768 || c.clip.bottom == 32767); }},
    {"a clip's sides without a clip", 0, 0,
     [](const Case& c) { return !c.has_clip && (c.clip.left != 0 || c.clip.right != 0); }}};

TEST(GenerateShares, OfOutlines) { expect_shares(kOutlines); }
TEST(GenerateShares, OfMaps) { expect_shares(kMaps); }
TEST(GenerateShares, OfImages) { expect_shares(kImages); }
TEST(GenerateShares, OfClips) { expect_shares(kClips); }

}  // namespace
}  // namespace selvage::spec
