// Laws of symmetry: CLIP, SHIFT, ORDER, MIRROR.
#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "spec/geometry.h"
#include "spec/law_list.h"
#include "spec/law_tools.h"

namespace selvage::spec {
namespace {

[[nodiscard]] bool contains(const selvage_rect& r, int32_t x, int32_t y) {
  return r.left <= x && x < r.right && r.top <= y && y < r.bottom;
}

[[nodiscard]] selvage_rect choose_rect(const Case& c, Choices& choices) {
  const int32_t w = c.target_width_px, h = c.target_height_px;
  const int32_t x = choices.pick(0, w), y = choices.pick(0, h);
  switch (choices.pick(0, 6)) {
    case 0:  // one pixel
      return {x, y, x + 1, y + 1};
    case 1:  // the rest of the rows, from a column on, with no end
      return {x, y, std::numeric_limits<int32_t>::max(), std::numeric_limits<int32_t>::max()};
    case 2:  // up to a column, from beyond the beginning
      return {std::numeric_limits<int32_t>::min(), -1, x, y};
    case 3:  // wholly beyond the target
      return x % 2 == 0 ? selvage_rect{w, -9, w + 9, h} : selvage_rect{-9, h, w, h + 9};
    case 4:  // inverted or empty
      return {x, y, x - choices.pick(0, 3), h};
    default:
      return {x, y, choices.pick(x, w) + 1, choices.pick(y, h) + 1};
  }
}

}  // namespace

Judgement check_clip(const Subject& subject, const Case& c) {
  if (!is_valid(c)) return {};
  Case whole_case = c;
  whole_case.has_clip = false;
  const Picture whole = draw(subject, whole_case);
  Choices choices(c.choice);
  Judgement judgement;
  for (int i = 0; i < 4; ++i) {
    Case clipped = c;
    clipped.has_clip = true;
    if (i > 0 || !c.has_clip) clipped.clip = choose_rect(c, choices);
    const auto wanted = [&](int32_t x, int32_t y) {
      return must_be(contains(clipped.clip, x, y) ? whole.at(x, y) : MaybePixel());
    };
    if (add(&judgement,
            compare("CLIP", "drawing clipped is drawing whole and cropping", clipped,
                    draw(subject, clipped),
                    drawing_of(subject, "the whole drawing, cropped, shows it"), wanted))) {
      break;
    }
  }
  return judgement;
}

namespace {

// Along one axis alone where a subject that takes no vertices far from the target leaves no more.
[[nodiscard]] Pixel choose_shift(const Subject& subject, const Case& c, Choices& choices) {
  const Pixel both{choices.pick(-4, 5), choices.pick(-4, 5)};
  for (const Pixel by : {both, Pixel{both.x_px, 0}, Pixel{0, both.y_px}}) {
    if (moved_in_band(subject.claims, c, int64_t{by.x_px} * SELVAGE_SUBPIXELS,
                      int64_t{by.y_px} * SELVAGE_SUBPIXELS)) {
      return by;
    }
  }
  return both;
}

[[nodiscard]] Judgement judge_target_shift(const Subject& subject, const Case& c,
                                           Choices& choices) {
  const auto [dx, dy] = choose_shift(subject, c, choices);
  const auto vertices =
      moved(c.vertices, int64_t{dx} * SELVAGE_SUBPIXELS, int64_t{dy} * SELVAGE_SUBPIXELS);
  if (!vertices) return {};
  Case shifted = with_vertices(subject.claims, c, *vertices);
  shifted.clip = {c.clip.left + dx, c.clip.top + dy, c.clip.right + dx, c.clip.bottom + dy};
  const Picture before = draw(subject, c);
  const selvage_rect target{0, 0, c.target_width_px, c.target_height_px};
  return compare("SHIFT", "polygon and clip shifted by whole pixels shift the picture", shifted,
                 draw(subject, shifted), drawing_of(subject, "the unshifted polygon shows it"),
                 [&](int32_t x, int32_t y) {
                   if (!contains(target, x - dx, y - dy)) return unjudged();
                   return must_be(before.at(x - dx, y - dy));
                 });
}

// Shifts u and v by whole texels as far as int32_t allows.
[[nodiscard]] bool shift_texture(std::vector<selvage_vertex>* vertices, int32_t ds, int32_t dt) {
  for (selvage_vertex& v : *vertices) {
    const int64_t u = v.u + int64_t{ds} * SELVAGE_SUBTEXELS;
    const int64_t w = v.v + int64_t{dt} * SELVAGE_SUBTEXELS;
    if (u != static_cast<int32_t>(u) || w != static_cast<int32_t>(w)) return false;
    v.u = static_cast<int32_t>(u);
    v.v = static_cast<int32_t>(w);
  }
  return true;
}

[[nodiscard]] Judgement judge_texture_shift(const Subject& subject, const Case& c,
                                            Choices& choices) {
  Case wrapped = with_nearest(c);
  wrapped.address = SELVAGE_ADDRESS_WRAP;
  const int32_t ds = choices.pick(-1100, 1101), dt = choices.pick(-1100, 1101);
  Case shifted = wrapped;
  if (!shift_texture(&shifted.vertices, ds, dt)) return {};
  const Picture before = draw(subject, wrapped);
  return compare(
      "SHIFT", "(u, v) shifted by whole texels shift the texels", shifted, draw(subject, shifted),
      drawing_of(subject, "the unshifted (u, v) show it, shifted"), [&](int32_t x, int32_t y) {
        const MaybePixel& pixel = before.at(x, y);
        if (!pixel) return must_be(std::nullopt);
        const Texel texel = texel_of(*pixel);
        return must_be(addressed_value(wrapped, {texel.s + ds, texel.t + dt}));
      });
}

// By whole periods of a texture that is repeated: the same picture, whatever the filter.
[[nodiscard]] Judgement judge_period_shift(const Subject& subject, const Case& c,
                                           Choices& choices) {
  Case wrapped = c;
  wrapped.address = SELVAGE_ADDRESS_WRAP;
  const int32_t ds = choices.pick(-1100, 1101) / c.texture_width_texel * c.texture_width_texel;
  const int32_t dt = choices.pick(-1100, 1101) / c.texture_height_texel * c.texture_height_texel;
  Case shifted = wrapped;
  if (!shift_texture(&shifted.vertices, ds, dt)) return {};
  const Picture before = draw(subject, wrapped);
  return compare("SHIFT", "(u, v) shifted by whole periods of the texture change nothing", shifted,
                 draw(subject, shifted), drawing_of(subject, "the unshifted (u, v) show it"),
                 [&](int32_t x, int32_t y) { return must_be(before.at(x, y)); });
}

}  // namespace

Judgement check_shift(const Subject& subject, const Case& c) {
  if (!is_valid(c)) return {};
  Choices choices(c.choice);
  Judgement judgement = judge_target_shift(subject, c, choices);
  const bool wraps =
      holds(subject.claims.addresses, SELVAGE_ADDRESS_WRAP) && subject.claims.outside_texels;
  if (!wraps || judgement.violation) return judgement;
  if (!add(&judgement, judge_texture_shift(subject, c, choices)) &&
      c.filter != SELVAGE_FILTER_NEAREST) {
    add(&judgement, judge_period_shift(subject, c, choices));
  }
  return judgement;
}

Judgement check_order(const Subject& subject, const Case& c) {
  if (!is_valid(c)) return {};
  Choices choices(c.choice);
  const Picture before = draw(subject, c);
  const auto wanted = [&](int32_t x, int32_t y) { return must_be(before.at(x, y)); };

  Case rotated = c;
  const auto first = choices.pick(1, static_cast<int32_t>(c.vertices.size()));
  std::ranges::rotate(rotated.vertices, rotated.vertices.begin() + first);
  Judgement judgement =
      compare("ORDER", "which vertex comes first changes nothing", rotated, draw(subject, rotated),
              drawing_of(subject, "the outline in its own order shows it"), wanted);
  if (judgement.violation || subject.claims.winding != Winding::kBoth) return judgement;
  std::ranges::reverse(rotated.vertices);
  const Picture reversed = draw(subject, rotated);
  if (!profile_of(c).clockwise_only) {
    add(&judgement, compare("ORDER", "the winding changes nothing", rotated, reversed,
                            drawing_of(subject, "the other winding shows it"), wanted));
    return judgement;
  }
  add(&judgement, compare("ORDER", "a pixel is drawn by one winding only", rotated, reversed,
                          {"the other winding has drawn it"}, [&](int32_t x, int32_t y) {
                            return before.at(x, y) ? must_be(std::nullopt) : unjudged();
                          }));
  return judgement;
}

}  // namespace selvage::spec
