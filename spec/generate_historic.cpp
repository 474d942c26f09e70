#include "spec/generate_historic.h"

#include <algorithm>
#include <optional>

#include "spec/generate.h"
#include "spec/generate_blocks.h"
#include "spec/historic_line.h"
#include "spec/model.h"
#include "spec/profiles.h"
#include "spec/random.h"
#include "spec/vertex_units.h"

namespace selvage::spec {
namespace {

// From 195 on a 16.16 step cannot keep all columns apart.
constexpr int32_t kLongestTarget_px = 1024;

// One axis of the outline onto the whole target. Order is kept, so a valid outline stays valid.
void stretch_axis(VertexField axis, int32_t size_px, Case* c) {
  const auto [least, greatest] = std::ranges::minmax(c->vertices, {}, axis);
  const int64_t first = least.*axis, extent = int64_t{greatest.*axis} - first;
  if (extent == 0) return;
  for (selvage_vertex& v : c->vertices) {
    const int64_t at_px = (int64_t{v.*axis} - first) * size_px / extent;
    v.*axis = static_cast<int32_t>(at_px) * kPixel_fx8;
  }
}

void make_long(Random& random, Case* c) {
  const int32_t length_px = random.in(129, kLongestTarget_px + 1);
  const int32_t breadth_px = random.in(1, 3);
  const bool is_wide = random.percent(60);
  c->target_width_px = is_wide ? length_px : breadth_px;
  c->target_height_px = is_wide ? breadth_px : length_px;
  if (c->vertices.empty()) return;
  stretch_axis(&selvage_vertex::x, c->target_width_px, c);
  stretch_axis(&selvage_vertex::y, c->target_height_px, c);
}

// 1/65536 texel, before it is floored or rounded, at a pixel of the line: in dkit, whose span walks
// between whole texels, of the edge before it is rounded.
[[nodiscard]] int64_t value_fx16(const HistoricLine& line, int32_t x_px, bool of_v) {
  const auto& [profile, left, right] = line;
  if (profile == SELVAGE_PROFILE_DKIT) {
    const HistoricEnd& end = x_px % 2 == 0 ? left : right;
    const Rational units = (of_v ? end.v : end.u) * kTexel_fx16;
    return floor(units);
  }
  const int64_t from = of_v ? left.v_fx16 : left.u_fx16, to = of_v ? right.v_fx16 : right.u_fx16;
  const int64_t step = truncated_quotient(to - from, right.column_px - left.column_px);
  const int64_t prestep = profile == SELVAGE_PROFILE_ABRASH57 ? floor_half(step) : 0;
  return from + prestep + step * (x_px - left.column_px);
}

struct LinePixel {
  HistoricLine line;
  int32_t x_px;
};

// A pixel that is covered and in the target, if a few tries find one.
[[nodiscard]] std::optional<LinePixel> find_pixel(Random& random, const Case& c) {
  if (c.vertices.empty()) return std::nullopt;
  for (int tries = 0; tries < 8; ++tries) {
    const int32_t y_px = random.in(0, c.target_height_px);
    const auto line = historic_line(c.profile, c.vertices, y_px);
    if (!line) continue;
    const int32_t first_px = std::max(line->left.column_px, 0);
    const int32_t end_px = std::min(line->end_px(), c.target_width_px);
    if (first_px < end_px) return LinePixel{*line, random.in(first_px, end_px)};
  }
  return std::nullopt;
}

void graze_a_step(Random& random, Case* c) {
  const std::optional<LinePixel> pixel = find_pixel(random, *c);
  if (!pixel) return;
  const int64_t rounding_fx16 = profile_of(*c).rounding_fx16;
  for (const auto axis : {&selvage_vertex::u, &selvage_vertex::v}) {
    const bool of_v = axis == &selvage_vertex::v;
    const int64_t at_fx16 = value_fx16(pixel->line, pixel->x_px, of_v) + rounding_fx16;
    const int64_t shift = random.pick({-1, -1, 0, 0, 1}) - (at_fx16 & (kTexel_fx16 - 1));
    const auto shifted = [&](const selvage_vertex& v) { return v.*axis + shift; };
    const bool fits = std::ranges::all_of(c->vertices, [&](const selvage_vertex& v) {
      return shifted(v) == static_cast<int32_t>(shifted(v));
    });
    if (!fits) continue;
    for (selvage_vertex& v : c->vertices) v.*axis = static_cast<int32_t>(shifted(v));
  }
}

}  // namespace

Case generate(uint64_t seed, selvage_profile id) {
  Case c = in_profile(generate(seed), id);
  if (id == SELVAGE_PROFILE_EXACT) return c;
  Random random(~seed);
  const bool is_long = random.percent(6), is_block = random.percent(is_long ? 50 : 12);
  if (is_long) make_long(random, &c);
  if (is_block) make_block(random, &c);
  if (random.percent(is_block ? 10 : 40) && is_valid(c)) graze_a_step(random, &c);
  return c;
}

}  // namespace selvage::spec
