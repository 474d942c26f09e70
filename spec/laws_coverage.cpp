// Laws of coverage: COV, PART, PINWHEEL.
#include <algorithm>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "spec/geometry.h"
#include "spec/law_list.h"
#include "spec/law_tools.h"
#include "spec/sample_place.h"

namespace selvage::spec {
namespace {

[[nodiscard]] selvage_vertex vertex_at(Point p, const selvage_vertex& like) {
  return {static_cast<int32_t>(p.x), static_cast<int32_t>(p.y), like.u, like.v, like.q};
}

// How many tiles draw a pixel: those that run clockwise, and the others.
struct Times {
  int clockwise = 0, counter_clockwise = 0;

  // As often as the outline winds around it: where tiles fold back they cancel each other out.
  [[nodiscard]] int sum() const { return clockwise - counter_clockwise; }
};

// The tiles (centre, v_k, v_k+1) of an outline, drawn one at a time.
struct Fan {
  std::vector<Times> times;  // of each pixel of the target
  bool runs_one_way = true;  // no tile is counter-clockwise
};

[[nodiscard]] bool is_counter_clockwise(const std::vector<selvage_vertex>& corners) {
  return doubled_area(position(corners[0]), position(corners[1]), position(corners[2])) < 0;
}

[[nodiscard]] Fan draw_fan(const Subject& subject, const Case& c, const selvage_vertex& centre) {
  Fan fan{std::vector<Times>(static_cast<size_t>(c.target_width_px) *
                             static_cast<size_t>(c.target_height_px))};
  for (size_t k = 0; k < c.vertices.size(); ++k) {
    const selvage_vertex& a = c.vertices[k];
    const selvage_vertex& b = c.vertices[(k + 1) % c.vertices.size()];
    Case tile_case = with_vertices(c, {centre, a, b});
    const bool is_reverse = is_counter_clockwise(tile_case.vertices);
    fan.runs_one_way = fan.runs_one_way && !is_reverse;
    make_visible(profile_of(c), subject.claims, &tile_case.vertices);
    const Picture tile = draw(subject, tile_case);
    for (size_t i = 0; i < fan.times.size(); ++i) {
      int& times = is_reverse ? fan.times[i].counter_clockwise : fan.times[i].clockwise;
      times += tile.pixels[i] ? 1 : 0;
    }
  }
  return fan;
}

[[nodiscard]] std::string times_text(int count) {
  return count == 0 ? "never" : count == 1 ? "once" : std::to_string(count) + " times";
}

[[nodiscard]] std::string wanted_text(const Fan& fan, int wanted) {
  if (fan.runs_one_way && wanted >= 0) return "the tiles draw it " + times_text(wanted);
  if (wanted == 0) return "clockwise tiles draw it as often as counter-clockwise ones";
  const std::string more = times_text(wanted < 0 ? -wanted : wanted) + " more often than ";
  return wanted > 0 ? "clockwise tiles draw it " + more + "counter-clockwise ones"
                    : "counter-clockwise tiles draw it " + more + "clockwise ones";
}

[[nodiscard]] std::string drawn_text(const Fan& fan, const Times& times) {
  if (fan.runs_one_way) return "they draw it " + times_text(times.clockwise);
  return "clockwise ones " + times_text(times.clockwise) + ", counter-clockwise ones " +
         times_text(times.counter_clockwise);
}

[[nodiscard]] Judgement judge_counts(std::string_view law, const Case& shown, const Fan& fan,
                                     Point centre) {
  Judgement judgement;
  size_t index = 0;
  for (int32_t y = 0; y < shown.target_height_px; ++y) {
    for (int32_t x = 0; x < shown.target_width_px; ++x, ++index) {
      ++judgement.judged_px;
      const int wanted = winding_number(sample_point(shown, {x, y}), shown.vertices);
      if (fan.times[index].sum() == wanted) continue;
      judgement.violation =
          violation_at(law,
                       "the tiles of a fan from " + describe_px(centre) +
                           " cover a pixel as often as the outline winds around it",
                       shown, x, y, wanted_text(fan, wanted), std::nullopt);
      judgement.violation->drawn = drawn_text(fan, fan.times[index]);
      return judgement;
    }
  }
  return judgement;
}

// The clip would hide tiles.
[[nodiscard]] Case unclipped(const Case& c) {
  Case whole = c;
  whole.has_clip = false;
  return whole;
}

// A centre for a fan: a corner of the outline, a point between corners, or one near the target.
[[nodiscard]] selvage_vertex choose_centre(const Case& c, Choices& choices) {
  const auto count = static_cast<int32_t>(c.vertices.size());
  const selvage_vertex& a = c.vertices[static_cast<size_t>(choices.pick(0, count))];
  const selvage_vertex& b = c.vertices[static_cast<size_t>(choices.pick(0, count))];
  switch (choices.pick(0, 4)) {
    case 0:
      return a;
    case 1:
      return vertex_at(sample_point(c, choose_pixel(c, choices)), a);
    case 2:
      return vertex_at({sample_point(c, choose_pixel(c, choices)).x + choices.pick(-128, 128),
                        sample_point(c, choose_pixel(c, choices)).y + choices.pick(-128, 128)},
                       a);
    default:
      return vertex_at({std::midpoint(a.x, b.x), std::midpoint(a.y, b.y)}, a);
  }
}

// Points all around a centre, clockwise, no two neighbours half a turn or more apart.
[[nodiscard]] std::vector<selvage_vertex> ring_around(Point centre, const Case& c,
                                                      Choices& choices) {
  const selvage_vertex& like = c.vertices.front();
  std::vector<selvage_vertex> ring;
  for (const selvage_vertex& v : c.vertices) {
    if (position(v) != centre) ring.push_back(v);
  }
  const int32_t unit = profile_of(c).whole_px ? SELVAGE_SUBPIXELS : 1;
  const int32_t reach = unit == 1 ? 4096 : 64;
  const int32_t a = unit * choices.pick(1, reach);
  const int32_t b = choices.pick(0, 2) == 0 ? 0 : unit * choices.pick(0, reach);
  for (const Point arm : {Point{a, b}, Point{-b, a}, Point{-a, -b}, Point{b, -a}}) {
    ring.push_back(vertex_at({centre.x + arm.x, centre.y + arm.y}, like));
  }
  const auto lower_half = [&](const selvage_vertex& v) {
    return v.y > centre.y || (v.y == centre.y && v.x > centre.x);
  };
  std::ranges::sort(ring, [&](const selvage_vertex& p, const selvage_vertex& q) {
    if (lower_half(p) != lower_half(q)) return lower_half(p);
    return doubled_area(centre, position(p), position(q)) > 0;
  });
  return ring;
}

}  // namespace

Judgement check_cov(const Subject& subject, const Case& c) {
  if (!is_valid(c)) return {};
  const Picture model = expected(with_nearest(c));  // the filter covers no other pixels
  const Picture drawn = draw(subject, c);
  Judgement judgement;
  for (int32_t y = 0; y < c.target_height_px; ++y) {
    for (int32_t x = 0; x < c.target_width_px; ++x) {
      ++judgement.judged_px;
      if (model.at(x, y).has_value() == drawn.at(x, y).has_value()) continue;
      judgement.violation =
          violation_at("COV", "exactly the pixels whose sample points lie in the polygon are drawn",
                       c, x, y, model.at(x, y) ? "a texel" : "nothing", drawn.at(x, y));
      return judgement;
    }
  }
  return judgement;
}

Judgement check_part(const Subject& subject, const Case& c) {
  if (c.vertices.size() < 3) return {};
  Choices choices(c.choice);
  Case region = unclipped(acceptable(c));
  if (choices.pick(0, 2) == 0) {
    std::vector<selvage_vertex> hull = convex_hull(region.vertices);
    if (hull.size() >= 3) region.vertices = std::move(hull);
  }
  const selvage_vertex centre = choose_centre(region, choices);
  return judge_counts("PART", region, draw_fan(subject, region, centre), position(centre));
}

Judgement check_pinwheel(const Subject& subject, const Case& c) {
  if (c.vertices.empty()) return {};
  Choices choices(c.choice);
  const Pixel pixel = choose_pixel(c, choices);
  const auto [x_px, y_px] = pixel;
  const Point centre = sample_point(c, pixel);
  const Case region = with_vertices(unclipped(c), ring_around(centre, acceptable(c), choices));
  const Fan fan = draw_fan(subject, region, vertex_at(centre, region.vertices.front()));
  Judgement judgement = {.judged_px = 1};
  const size_t index = static_cast<size_t>(y_px) * static_cast<size_t>(c.target_width_px) +
                       static_cast<size_t>(x_px);
  const int owned = fan.times[index].sum();
  if (owned == 1) return judgement;
  judgement.violation =
      violation_at("PINWHEEL", "of triangles around a sample point exactly one owns it", region,
                   x_px, y_px, "1 triangle", std::nullopt);
  judgement.violation->drawn = std::to_string(owned) + " triangles";
  return judgement;
}

}  // namespace selvage::spec
