#include "spec/capabilities.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

#include "spec/geometry.h"
#include "spec/model.h"

namespace selvage::spec {
namespace {

[[nodiscard]] Point difference(const selvage_vertex& from, const selvage_vertex& to) {
  return {int64_t{to.x} - from.x, int64_t{to.y} - from.y};
}

// Each row crosses two edges or none, so an outline that only ever turns one way turns once.
// Repeated vertices and collinear runs are convex too, a way back along an edge is not.
[[nodiscard]] bool is_convex(const Case& c) {
  Vertices outline = c.vertices;
  const auto same_place = [](const selvage_vertex& a, const selvage_vertex& b) {
    return position(a) == position(b);
  };
  outline.erase(std::unique(outline.begin(), outline.end(), same_place), outline.end());
  while (outline.size() > 1 && same_place(outline.front(), outline.back())) outline.pop_back();
  if (outline.size() < 3) return true;
  bool left = false, right = false;
  for (size_t i = 0; i < outline.size(); ++i) {
    const selvage_vertex& at = outline[i];
    const Point in = difference(outline[(i + outline.size() - 1) % outline.size()], at);
    const Point out = difference(at, outline[(i + 1) % outline.size()]);
    const int64_t turn = in.x * out.y - in.y * out.x;
    left = left || turn < 0;
    right = right || turn > 0;
    if (turn == 0 && in.x * out.x + in.y * out.y < 0) return false;
  }
  return !(left && right);
}

[[nodiscard]] bool is_power_of_two(int32_t side) { return (side & (side - 1)) == 0; }

// u or v, from the texture's one end to the other.
[[nodiscard]] int32_t inside(int32_t coordinate, int32_t side_texel) {
  const int64_t end = int64_t{side_texel} * SELVAGE_SUBTEXELS;
  return static_cast<int32_t>(std::clamp<int64_t>(coordinate, 0, end));
}

[[nodiscard]] bool lies_inside(const Case& c) {
  return std::ranges::all_of(c.vertices, [&](const selvage_vertex& v) {
    return v.u == inside(v.u, c.texture_width_texel) && v.v == inside(v.v, c.texture_height_texel);
  });
}

// Down to a multiple of a power of two.
[[nodiscard]] int32_t to_step(int32_t value, int32_t step) { return value & ~(step - 1); }

[[nodiscard]] selvage_vertex to_steps(selvage_vertex v, const Capabilities& claims) {
  for (int32_t* at : {&v.x, &v.y}) *at = to_step(*at, claims.position_step_fx8);
  for (int32_t* at : {&v.u, &v.v}) *at = to_step(*at, claims.coordinate_step_fx16);
  return v;
}

[[nodiscard]] bool are_on_steps(const Capabilities& claims, const Vertices& vertices) {
  return std::ranges::all_of(vertices, [&](const selvage_vertex& v) {
    const selvage_vertex on = to_steps(v, claims);
    return position(v) == position(on) && v.u == on.u && v.v == on.v;
  });
}

[[nodiscard]] bool is_right_way(Winding winding, const Vertices& outline) {
  if (winding == Winding::kBoth) return true;
  const int64_t area = doubled_area(outline);
  return area == 0 || (area > 0) == (winding == Winding::kClockwise);
}

[[nodiscard]] bool has_equal_q(const Vertices& outline) {
  return std::ranges::all_of(outline,
                             [&](const selvage_vertex& v) { return v.q == outline.front().q; });
}

// A subject of one winding says nothing of outlines whose parts run both ways.
[[nodiscard]] bool wants_convex(const Capabilities& claims) {
  return !claims.concave || claims.winding != Winding::kBoth;
}

[[nodiscard]] int32_t one_of(ValueSet set, uint32_t choice) {
  auto left = choice % static_cast<uint32_t>(std::popcount(set));
  int32_t value = 0;
  for (; !holds(set, value) || left-- > 0; ++value) {
  }
  return value;
}

// As many corners as are drawn, taken evenly.
[[nodiscard]] Vertices thinned(const Vertices& outline, size_t most) {
  if (outline.size() <= most) return outline;
  Vertices kept;
  for (size_t i = 0; i < most; ++i) kept.push_back(outline[i * outline.size() / most]);
  return kept;
}

[[nodiscard]] bool is_outline_claimed(const Capabilities& claims, const Case& c) {
  return c.vertices.size() <= static_cast<size_t>(claims.most_vertices) &&
         (!wants_convex(claims) || is_convex(c)) && is_right_way(claims.winding, c.vertices);
}

void take_outline(const Capabilities& claims, Case* c) {
  const auto most = static_cast<size_t>(claims.most_vertices);
  if (c->vertices.size() > most || (wants_convex(claims) && !is_convex(*c))) {
    Vertices hull = convex_hull(c->vertices);
    while (hull.size() < 3) hull.push_back(hull.back());  // a line, there and back
    c->vertices = thinned(hull, most);
  }
  if (!claims.perspective) {
    for (selvage_vertex& v : c->vertices) v.q = c->vertices.front().q;
  }
  if (!is_right_way(claims.winding, c->vertices)) std::ranges::reverse(c->vertices);
}

}  // namespace

std::optional<std::string> beyond(const Capabilities& claims, const Case& c) {
  const auto longest = [](int32_t a, int32_t b) { return std::max(a, b); };
  const std::array<std::pair<bool, const char*>, 13> reasons = {{
      {!holds(claims.formats, c.format), "a format that it does not draw"},
      {!holds(claims.filters, c.filter), "a filter that it does not have"},
      {!holds(claims.addresses, c.address), "an address mode that it does not have"},
      {c.has_clip && !claims.clip, "a clip rectangle"},
      {(c.flip_target || c.flip_texture) && !claims.negative_pitch, "a negative pitch"},
      {!claims.perspective && !c.vertices.empty() && !has_equal_q(c.vertices), "perspective"},
      {longest(c.target_width_px, c.target_height_px) > claims.longest_side_px,
       "a target too large for it"},
      {longest(c.texture_width_texel, c.texture_height_texel) > claims.longest_side_texel,
       "a texture too large for it"},
      {!claims.any_texture_side &&
           !(is_power_of_two(c.texture_width_texel) && is_power_of_two(c.texture_height_texel)),
       "a texture whose sides are no powers of two"},
      {!claims.outside_texels && !lies_inside(c), "texture coordinates outside the texture"},
      {!lies_in_guard_band(claims, c), "vertices too far from the target for it"},
      {!are_on_steps(claims, c.vertices), "vertices between the places that it takes"},
      {!claims.named_errors && !is_valid(c), "an outline to be refused"},
  }};
  for (const auto& [is_beyond, what] : reasons) {
    if (is_beyond) return what;
  }
  // An outline that is refused has neither form nor winding.
  if (!is_outline_claimed(claims, c) && is_valid(c)) return "an outline that it does not draw";
  return std::nullopt;
}

Case within(const Capabilities& claims, const Case& c) {
  Case taken = c;
  if (!holds(claims.formats, c.format)) taken.format = one_of(claims.formats, c.choice);
  if (!holds(claims.filters, c.filter)) taken.filter = one_of(claims.filters, c.choice);
  if (!can_be_filtered(taken)) taken.filter = SELVAGE_FILTER_NEAREST;
  if (!holds(claims.addresses, c.address)) taken.address = one_of(claims.addresses, c.choice);
  taken.has_clip = c.has_clip && claims.clip;
  taken.flip_target = c.flip_target && claims.negative_pitch;
  taken.flip_texture = c.flip_texture && claims.negative_pitch;
  for (const auto side : {&Case::target_width_px, &Case::target_height_px}) {
    taken.*side = std::min(taken.*side, claims.longest_side_px);
  }
  for (const auto side : {&Case::texture_width_texel, &Case::texture_height_texel}) {
    taken.*side = std::min(taken.*side, claims.longest_side_texel);
    if (!claims.any_texture_side)
      taken.*side = static_cast<int32_t>(std::bit_floor(static_cast<uint32_t>(taken.*side)));
  }
  if (!claims.outside_texels) {
    for (selvage_vertex& v : taken.vertices) {
      v.u = inside(v.u, taken.texture_width_texel);
      v.v = inside(v.v, taken.texture_height_texel);
    }
  }
  take_into_guard_band(claims, &taken);
  for (selvage_vertex& v : taken.vertices) v = to_steps(v, claims);
  if (!taken.vertices.empty()) take_outline(claims, &taken);
  return taken;
}

void make_acceptable(const Profile& profile, const Capabilities& claims,
                     std::span<selvage_vertex> vertices) {
  make_acceptable(profile, vertices);
  for (selvage_vertex& v : vertices) v = to_steps(v, claims);
}

int32_t position_step_fx8(const Profile& profile, const Capabilities& claims) {
  return std::max(profile.whole_px ? int32_t{SELVAGE_SUBPIXELS} : 1, claims.position_step_fx8);
}

int32_t mapped_step_fx8(const Profile& profile, const Capabilities& claims) {
  constexpr int32_t kFx16PerFx8 = SELVAGE_SUBTEXELS / SELVAGE_SUBPIXELS;
  return std::max(position_step_fx8(profile, claims), claims.coordinate_step_fx16 / kFx16PerFx8);
}

int32_t in_guard_band(const Capabilities& claims, int32_t at_fx8, int32_t side_px) {
  const int64_t band_fx8 = int64_t{claims.guard_band_px} * SELVAGE_SUBPIXELS;
  const int64_t end_fx8 = int64_t{side_px} * SELVAGE_SUBPIXELS + band_fx8;
  return static_cast<int32_t>(std::clamp<int64_t>(at_fx8, -band_fx8, end_fx8));
}

void take_into_guard_band(const Capabilities& claims, Case* c) {
  for (selvage_vertex& v : c->vertices) {
    v.x = in_guard_band(claims, v.x, c->target_width_px);
    v.y = in_guard_band(claims, v.y, c->target_height_px);
  }
}

bool lies_in_guard_band(const Capabilities& claims, const Case& c) {
  return std::ranges::all_of(c.vertices, [&](const selvage_vertex& v) {
    return v.x == in_guard_band(claims, v.x, c.target_width_px) &&
           v.y == in_guard_band(claims, v.y, c.target_height_px);
  });
}

void make_visible(const Profile& profile, const Capabilities& claims,
                  std::vector<selvage_vertex>* vertices) {
  make_visible(profile, vertices);
  if (!profile.clockwise_only && !is_right_way(claims.winding, *vertices)) {
    std::ranges::reverse(*vertices);
  }
}

}  // namespace selvage::spec
