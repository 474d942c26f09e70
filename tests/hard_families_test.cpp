// Each hard family is what its name says: a measured property that all of its cases have and that
// the cases of no other family all have.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>
#include <string_view>

#include "hard_measures.h"
#include "spec/hard_cases.h"

namespace selvage::spec {
namespace {

[[nodiscard]] bool is_sliver(const Case& c) {
  if (c.vertices.size() != 3 || doubled_area_fx8(c) == 0) return false;
  // Its height over its longest side is below a pixel.
  const int64_t length = std::max(xs(c).extent(), ys(c).extent());
  return doubled_area_fx8(c) <= length * kPixel;
}

[[nodiscard]] bool is_needle_row(const Case& c) {
  return ys(c).centres() == 1 && xs(c).least <= kPixel / 2 &&
         xs(c).greatest > c.target_width_px * kPixel - kPixel / 2 &&
         c.target_width_px >= 64 * c.target_height_px && 3 * covered_px(c) >= c.target_width_px;
}

[[nodiscard]] bool is_needle_column(const Case& c) {
  return xs(c).centres() == 1 && ys(c).least <= kPixel / 2 &&
         ys(c).greatest > c.target_height_px * kPixel - kPixel / 2 &&
         c.target_height_px >= 64 * c.target_width_px && 3 * covered_px(c) >= c.target_height_px;
}

[[nodiscard]] bool has_long_span(const Case& c) {
  const double width_px = row_width_px(c, c.target_height_px / 2);
  return 30000 <= width_px && width_px < 32768 && ys(c).extent() <= 8 * kPixel;
}

[[nodiscard]] bool has_long_edges(const Case& c) {
  return count_edges(c, [](const Edge& e) {
           return 30000 * kPixel <= e.dy() && e.dy() < 32768 * kPixel && e.dx() <= 8 * kPixel;
         }) == 2;
}

[[nodiscard]] bool is_diagonal(const Edge& e) { return e.dx() != 0 && e.dx() == e.dy(); }
[[nodiscard]] bool is_third(const Edge& e) {
  return e.dx() != 0 && (e.dx() == 3 * e.dy() || 3 * e.dx() == e.dy());
}

[[nodiscard]] bool has_edges_through_samples(const Case& c) {
  return centres_on_outline(c) >= 3 && count_edges(c, [&](const Edge& e) {
                                         return e.dx() != 0 && e.dy() != 0 && !is_diagonal(e) &&
                                                !is_third(e) && centres_on(c, e) > 0;
                                       }) >= 1;
}

[[nodiscard]] bool has_slopes_of_45(const Case& c) {
  return count_edges(c, is_diagonal) >= 2 && centres_on_outline(c) >= 3 &&
         share(c, [](const Sample& p) { return is_whole(p.u) && is_whole(p.v); }) >= 0.4;
}

[[nodiscard]] bool has_slopes_of_a_third(const Case& c) {
  return count_edges(c, is_third) >= 2 && centres_on_outline(c) >= 3 &&
         share(c, [](const Sample& p) { return is_whole(p.u); }) > 0.2;
}

// An edge that spans, with some centre of the target, the least area there is.
[[nodiscard]] bool grazes_a_centre(const Case& c) {
  return count_edges(c, [&](const Edge& e) {
           bool grazes = false;
           for_each_pixel(c, [&](int32_t x, int32_t y) {
             const Point p = pixel_centre(x, y);
             grazes = grazes || (std::abs(doubled_area(e.from, e.to, p)) == 1 &&
                                 (e.from.y < p.y) != (e.to.y <= p.y));
           });
           return grazes;
         }) >= 1;
}

[[nodiscard]] bool reaches_the_ends(const Case& c) {
  const auto from_end_to_end = [](const Range& r) {
    return r.least == SELVAGE_X_MIN && r.greatest >= SELVAGE_X_END - kPixel;
  };
  return (from_end_to_end(xs(c)) || from_end_to_end(ys(c))) && covered_px(c) >= 32;
}

[[nodiscard]] bool is_far_off(const Case& c) {
  return c.vertices.size() == 3 && covered_px(c) >= 1 &&
         std::ranges::all_of(c.vertices, [](const selvage_vertex& v) {
           const int64_t farther = std::max(std::abs(v.x), std::abs(v.y));
           return 2500 * kPixel <= farther && farther <= 25000 * kPixel;
         });
}

[[nodiscard]] bool is_magnified(const Case& c) {
  const Range u = range(c, &selvage_vertex::u), v = range(c, &selvage_vertex::v);
  const auto is_slow = [](const Range& texels, const Range& place) {
    return texels.extent() == 3 * SELVAGE_SUBTEXELS && place.extent() >= 3 * 4090 * kPixel &&
           place.extent() <= 3 * 4500 * kPixel;
  };
  return is_slow(u, xs(c)) && is_slow(v, ys(c)) && texels_shown(c).size() >= 2 &&
         covered_px(c) >= 512;
}

[[nodiscard]] bool is_minified(const Case& c) {
  const auto all_within_3_px = [&](int32_t selvage_vertex::*along,
                                   int32_t selvage_vertex::*coordinate) {
    const Range texels = range(c, coordinate);
    return std::abs(c.vertices[1].*along - c.vertices[0].*along) == 3 * kPixel &&
           std::abs(c.vertices[1].*coordinate - c.vertices[0].*coordinate) == texels.extent() &&
           texels.extent() >= 4095 * SELVAGE_SUBTEXELS;
  };
  return covered_px(c) >= 30 && (all_within_3_px(&selvage_vertex::x, &selvage_vertex::u) ||
                                 all_within_3_px(&selvage_vertex::y, &selvage_vertex::v));
}

// One texel to a pixel, along x for u and along y for v.
[[nodiscard]] bool is_one_to_one(const Case& c) {
  const auto follows = [](int32_t coordinate, int32_t first_coordinate, int32_t at, int32_t first) {
    return std::abs(coordinate - first_coordinate) == 256 * std::abs(at - first);
  };
  const selvage_vertex& first = c.vertices.front();
  return std::ranges::all_of(c.vertices, [&](const selvage_vertex& v) {
    return follows(v.u, first.u, v.x, first.x) && follows(v.v, first.v, v.y, first.y);
  });
}

[[nodiscard]] bool all_on_boundaries(const Case& c) {
  return covered_px(c) >= 16 &&
         share(c, [](const Sample& p) { return is_whole(p.u) && is_whole(p.v); }) == 1;
}

// Along the first row, which lies beside a border of both.
[[nodiscard]] bool has_least_slopes(const Case& c) {
  const auto first = sample(c.vertices, 0, 0), second = sample(c.vertices, 1, 0);
  if (!first || !second) return false;
  const auto is_least = [](const Rational& from, const Rational& to) {
    const Rational half(1, 2), unit_of_lanes(1, int64_t{1} << 32);
    const Rational off = from - floor(from + half);
    return from != to && abs(to - from) < unit_of_lanes && abs(off) * SELVAGE_SUBTEXELS < 1;
  };
  return is_least(first->u, second->u) && is_least(first->v, second->v);
}

// One corner at least is off the plane of the other three, by 3/65536 texel at most, and all
// samples are next to whole numbers.
[[nodiscard]] bool is_near_a_plane(const Case& c) {
  if (c.vertices.size() != 4) return false;
  const Rational most_fx16(3);
  const auto is_off = [&](size_t k) {
    const auto at = [&](size_t i) { return c.vertices[(k + i) % 4]; };
    const selvage_vertex a = at(1), b = at(2), d = at(3), p = at(0);
    const auto from_a = [&](const selvage_vertex& to, int32_t selvage_vertex::*of) {
      return int64_t{to.*of} - a.*of;
    };
    const int64_t x1 = from_a(b, &selvage_vertex::x), y1 = from_a(b, &selvage_vertex::y);
    const int64_t x2 = from_a(d, &selvage_vertex::x), y2 = from_a(d, &selvage_vertex::y);
    const int64_t x = from_a(p, &selvage_vertex::x), y = from_a(p, &selvage_vertex::y);
    const int64_t area = x1 * y2 - x2 * y1;
    if (area == 0) return false;
    const Rational along_b = Rational(x * y2 - x2 * y) / Rational(area);
    const Rational along_d = Rational(x1 * y - x * y1) / Rational(area);
    const auto off = [&](int32_t selvage_vertex::*of) -> Rational {
      const Rational change_b(from_a(b, of)), change_d(from_a(d, of));
      return abs(Rational(from_a(p, of)) - along_b * change_b - along_d * change_d);
    };
    const Rational off_u = off(&selvage_vertex::u), off_v = off(&selvage_vertex::v);
    return off_u != Rational(0) && off_v != Rational(0) && off_u <= most_fx16 && off_v <= most_fx16;
  };
  const auto is_next_to_whole = [](const Rational& u) {
    return abs(u - floor(u + Rational(1, 2))) * SELVAGE_SUBTEXELS <= Rational(8);
  };
  const auto [least, most] = std::ranges::minmax(c.vertices, {}, &selvage_vertex::u);
  return int64_t{most.u} - least.u >= 4 * SELVAGE_SUBTEXELS &&
         (is_off(0) || is_off(1) || is_off(2) || is_off(3)) && covered_px(c) >= 16 &&
         share(c, [&](const Sample& p) {
           return is_next_to_whole(p.u) && is_next_to_whole(p.v);
         }) == 1;
}

[[nodiscard]] bool has_repeated_vertices(const Case& c) {
  return c.vertices.size() >= 6 &&
         2 * count_edges(c, [](const Edge& e) { return e.from == e.to; }) >=
             static_cast<int64_t>(c.vertices.size());
}

// Without its runs it is a quadrilateral with the same picture.
[[nodiscard]] bool has_collinear_runs(const Case& c) {
  Case corners = c;
  corners.vertices.clear();
  const size_t count = c.vertices.size();
  for (size_t k = 0; k < count; ++k) {
    const Point before = position(c.vertices[(k + count - 1) % count]);
    const Point after = position(c.vertices[(k + 1) % count]);
    if (doubled_area(before, position(c.vertices[k]), after) != 0)
      corners.vertices.push_back(c.vertices[k]);
  }
  return corners.vertices.size() == 4 && count >= 8 && covered_px(c) >= 64 &&
         expected(c).pixels == expected(corners).pixels;
}

[[nodiscard]] size_t places_at_height(const Case& c, int64_t y) {
  std::set<int32_t> places;
  for (const selvage_vertex& v : c.vertices) {
    if (v.y == y) places.insert(v.x);
  }
  return places.size();
}

[[nodiscard]] bool is_flat_topped(const Case& c) {
  return places_at_height(c, ys(c).least) >= 2 && places_at_height(c, ys(c).greatest) == 1;
}
[[nodiscard]] bool is_flat_bottomed(const Case& c) {
  return places_at_height(c, ys(c).least) == 1 && places_at_height(c, ys(c).greatest) >= 2;
}

[[nodiscard]] bool is_unrelated_ngon(const Case& c) {
  return c.vertices.size() >= 5 && c.vertices.size() <= 12 && is_strictly_convex(c) &&
         off_affine_texel(c) > 1;
}
[[nodiscard]] bool is_64_gon(const Case& c) {
  return c.vertices.size() == 64 && is_strictly_convex(c) && off_affine_texel(c) < 0.1;
}

using Property = bool (*)(const Case&);

const std::map<std::string_view, Property> kProperties = {
    {"slivers", is_sliver},
    {"needle-rows", is_needle_row},
    {"needle-columns", is_needle_column},
    {"long-spans", has_long_span},
    {"long-edges", has_long_edges},
    {"edges-through-samples", has_edges_through_samples},
    {"slopes-45", has_slopes_of_45},
    {"slopes-thirds", has_slopes_of_a_third},
    {"near-ties", grazes_a_centre},
    {"range-ends", reaches_the_ends},
    {"far-off-screen", is_far_off},
    {"magnified-4096", is_magnified},
    {"minified-4096", is_minified},
    {"texel-boundaries", [](const Case& c) { return all_on_boundaries(c) && !is_one_to_one(c); }},
    {"least-slopes", has_least_slopes},
    {"near-planes", is_near_a_plane},
    {"repeated-vertices", has_repeated_vertices},
    {"collinear-runs", has_collinear_runs},
    {"flat-topped", is_flat_topped},
    {"flat-bottomed", is_flat_bottomed},
    {"unrelated-ngons", is_unrelated_ngon},
    {"64-gons", is_64_gon},
    {"q-ratio-2", [](const Case& c) { return in_perspective(c, 2); }},
    {"q-ratio-100", [](const Case& c) { return in_perspective(c, 100); }},
    {"q-ratio-million", [](const Case& c) { return in_perspective(c, 1000000); }},
    {"q-equal-one",
     [](const Case& c) {
       return has_q_ratio(c, 1) && c.vertices[0].q == 1 && is_one_to_one(c) && all_on_boundaries(c);
     }},
};

TEST(HardProperties, HoldForEachCaseOfTheFamily) {
  for (const HardFamily& family : hard_families()) {
    ASSERT_TRUE(kProperties.contains(family.name)) << family.name;
    for (uint64_t seed = 0; seed < 16; ++seed) {
      const Case c = family.make(seed);
      EXPECT_TRUE(kProperties.at(family.name)(c)) << family.name << " " << seed << "\n" << print(c);
    }
  }
}

TEST(HardProperties, HoldForNoOtherFamily) {
  for (const auto& [name, holds] : kProperties) {
    for (const HardFamily& other : hard_families()) {
      if (other.name == name) continue;
      bool holds_for_all = true;
      for (const uint64_t seed : {0U, 1U, 4U, 5U, 8U, 9U, 12U, 13U}) {
        holds_for_all = holds_for_all && holds(other.make(seed));
      }
      EXPECT_FALSE(holds_for_all) << name << " does not tell " << other.name << " apart";
    }
  }
}

// What only the family as a whole shows.
[[nodiscard]] int64_t count_cases(std::string_view name, uint64_t seeds, const Property& is) {
  int64_t count = 0;
  for (uint64_t seed = 0; seed < seeds; ++seed)
    count += is(find_hard_family(name)->make(seed)) ? 1 : 0;
  return count;
}

TEST(HardProperties, FamiliesReachTheirExtremes) {
  // 1/65536 px^2 is a doubled area of 2; nothing is less than that and covers a pixel inside.
  EXPECT_GE(count_cases("slivers", 40, [](const Case& c) { return doubled_area_fx8(c) == 2; }), 4);
  EXPECT_GE(count_cases("long-spans", 40, [](const Case& c) { return c.target_width_px >= 30000; }),
            16);
  EXPECT_GE(
      count_cases("long-spans", 40, [](const Case& c) { return xs(c).least < -28000 * kPixel; }),
      16);
  EXPECT_GE(count_cases("needle-rows", 40, [](const Case& c) { return ys(c).extent() <= 2; }), 1);
  EXPECT_GE(count_cases("range-ends", 40, [](const Case& c) { return c.target_width_px == 32768; }),
            2);
  for (const std::string_view name : {"flat-topped", "flat-bottomed"}) {
    EXPECT_GE(count_cases(name, 40,
                          [](const Case& c) {
                            const bool top = is_flat_topped(c);
                            return ((top ? ys(c).least : ys(c).greatest) & 255) == 128;
                          }),
              4)
        << name;
  }
  // A coordinate that misses a whole number by the least part of a large denominator, or is one.
  EXPECT_GE(count_cases("near-ties", 24,
                        [](const Case& c) {
                          return share(c, [](const Sample& p) {
                                   const mpz_class part = p.u.get_num() % p.u.get_den();
                                   return p.u.get_den() > 100000 &&
                                          (part == 1 || part == p.u.get_den() - 1);
                                 }) > 0;
                        }),
            4);
}

TEST(HardProperties, FamiliesCoverPixels) {
  for (const HardFamily& family : hard_families()) {
    int64_t covered = 0;
    for (uint64_t seed = 0; seed < 200; ++seed) {
      if (seed >= 8 && seed % 4 >= 2) continue;  // large targets take their time
      const int64_t pixels = covered_px(family.make(seed));
      EXPECT_GE(pixels, 1) << family.name << " " << seed;
      covered += seed < 8 ? pixels : 0;
    }
    EXPECT_GE(covered, family.name == "slivers" ? 50 : 1000) << family.name;
  }
}

}  // namespace
}  // namespace selvage::spec
