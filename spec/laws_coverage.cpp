// Laws of coverage: COV, PART, PINWHEEL.
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "spec/fan.h"
#include "spec/geometry.h"
#include "spec/law_list.h"
#include "spec/law_tools.h"
#include "spec/outline_distance.h"
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

// Within an accuracy of the coverage the outline is in doubt, and tiles that it may turn over, but
// not where others meet.
[[nodiscard]] Judgement judge_counts(std::string_view law, const Subject& subject,
                                     const Case& shown, const Fan& fan, Point centre) {
  Judgement judgement;
  size_t index = 0;
  for (int32_t y = 0; y < shown.target_height_px; ++y) {
    for (int32_t x = 0; x < shown.target_width_px; ++x, ++index) {
      ++judgement.judged_px;
      const int wanted = winding_number(sample_point(shown, {x, y}), shown.vertices);
      if (fan.times[index].sum() == wanted) continue;
      if (fan.in_doubt[index] ||
          is_in_doubt(subject.claims.coverage_accuracy_fx16, shown, {x, y})) {
        continue;
      }
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

// How many units a point may be away from a centre in any direction, within the guard band.
[[nodiscard]] int32_t room_around(Point centre, const Capabilities& claims, const Case& c,
                                  int32_t unit) {
  const int64_t band_fx8 = int64_t{claims.guard_band_px} * SELVAGE_SUBPIXELS;
  const int64_t right_fx8 = int64_t{c.target_width_px} * SELVAGE_SUBPIXELS - centre.x;
  const int64_t below_fx8 = int64_t{c.target_height_px} * SELVAGE_SUBPIXELS - centre.y;
  const int64_t room_fx8 = std::min({centre.x, centre.y, right_fx8, below_fx8}) + band_fx8;
  const int32_t most = unit == SELVAGE_SUBPIXELS ? 63 : 4096 / unit - 1;
  return static_cast<int32_t>(std::min<int64_t>(room_fx8 / unit, most));
}

// Points all around a centre, clockwise, no two neighbours half a turn or more apart, and those
// that are added at most so many units away.
[[nodiscard]] std::vector<selvage_vertex> ring_around(Point centre, const Case& c, int32_t unit,
                                                      int32_t most, Choices& choices) {
  const selvage_vertex& like = c.vertices.front();
  std::vector<selvage_vertex> ring;
  for (const selvage_vertex& v : c.vertices) {
    if (position(v) != centre) ring.push_back(v);
  }
  const int32_t a = unit * choices.pick(1, most + 1);
  const int32_t b = choices.pick(0, 2) == 0 ? 0 : unit * choices.pick(0, most + 1);
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

// How much of what is claimed a wrong pixel takes.
[[nodiscard]] Margin outline_margin(const Subject& subject, const Case& c, Pixel at) {
  Rational claimed_px(subject.claims.coverage_accuracy_fx16, SELVAGE_SUBTEXELS);
  return {outline_distance_px(sample_point(c, at), c.vertices).get_d(), claimed_px.get_d()};
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
      if (is_in_doubt(subject.claims.coverage_accuracy_fx16, c, {x, y})) {
        add(&judgement.margin, outline_margin(subject, c, {x, y}));
        continue;
      }
      judgement.violation =
          violation_at("COV", "exactly the pixels whose sample points lie in the polygon are drawn",
                       c, x, y, model.at(x, y) ? "a texel" : "nothing", drawn.at(x, y));
      tell_outline_offset(&*judgement.violation, drawn.at(x, y).has_value());
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
  return judge_counts("PART", subject, region, fan_by(subject, region, centre), position(centre));
}

Judgement check_pinwheel(const Subject& subject, const Case& c) {
  if (c.vertices.empty()) return {};
  Choices choices(c.choice);
  const Pixel pixel = choose_pixel(c, choices);
  const auto [x_px, y_px] = pixel;
  const Point centre = sample_point(c, pixel);
  const int32_t unit_fx8 = position_step_fx8(profile_of(c), subject.claims);
  const int32_t room = room_around(centre, subject.claims, c, unit_fx8);
  if (room < 1) return {};
  const Case region =
      with_vertices(subject.claims, unclipped(c),
                    ring_around(centre, acceptable(subject.claims, c), unit_fx8, room, choices));
  const Fan fan = fan_by(subject, region, pinwheel_centre(region, x_px, y_px));
  Judgement judgement = {.judged_px = 1};
  const size_t index = static_cast<size_t>(y_px) * static_cast<size_t>(c.target_width_px) +
                       static_cast<size_t>(x_px);
  const int owned = fan.times[index].sum();
  if (owned == 1) return judgement;
  if (fan.in_doubt[index] || is_in_doubt(subject.claims.coverage_accuracy_fx16, region, pixel)) {
    return {};
  }
  judgement.violation =
      violation_at("PINWHEEL", "of triangles around a sample point exactly one owns it", region,
                   x_px, y_px, "1 triangle", std::nullopt);
  judgement.violation->drawn = std::to_string(owned) + " triangles";
  return judgement;
}

}  // namespace selvage::spec
