// Laws of coverage: COV, PART, PINWHEEL.
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "spec/fan.h"
#include "spec/geometry.h"
#include "spec/law_list.h"
#include "spec/law_tools.h"
#include "spec/sample_place.h"

namespace selvage::spec {
namespace {

[[nodiscard]] Fan fan_by(const Subject& subject, const Case& c, const selvage_vertex& centre) {
  return draw_fan(c, centre, subject.claims, [&](const Case& tile) { return draw(subject, tile); });
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

// Points all around a centre, clockwise, no two neighbours half a turn or more apart.
[[nodiscard]] std::vector<selvage_vertex> ring_around(Point centre, const Case& c, int32_t unit,
                                                      Choices& choices) {
  const selvage_vertex& like = c.vertices.front();
  std::vector<selvage_vertex> ring;
  for (const selvage_vertex& v : c.vertices) {
    if (position(v) != centre) ring.push_back(v);
  }
  const int32_t reach = unit == SELVAGE_SUBPIXELS ? 64 : 4096 / unit;
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
  Case region = unclipped(acceptable(subject.claims, c));
  if (choices.pick(0, 2) == 0) {
    std::vector<selvage_vertex> hull = convex_hull(region.vertices);
    if (hull.size() >= 3) region.vertices = std::move(hull);
  }
  const selvage_vertex centre = part_centre(region);
  return judge_counts("PART", region, fan_by(subject, region, centre), position(centre));
}

Judgement check_pinwheel(const Subject& subject, const Case& c) {
  if (c.vertices.empty()) return {};
  Choices choices(c.choice);
  const Pixel pixel = choose_pixel(c, choices);
  const auto [x_px, y_px] = pixel;
  const Point centre = sample_point(c, pixel);
  const int32_t unit_fx8 = position_step_fx8(profile_of(c), subject.claims);
  const Case region =
      with_vertices(subject.claims, unclipped(c),
                    ring_around(centre, acceptable(subject.claims, c), unit_fx8, choices));
  const Fan fan = fan_by(subject, region, pinwheel_centre(region, x_px, y_px));
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
