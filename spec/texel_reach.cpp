#include "spec/texel_reach.h"

#include <algorithm>
#include <tuple>

#include "spec/coordinate_texture.h"
#include "spec/law_tools.h"
#include "spec/model.h"
#include "spec/profiles.h"

namespace selvage::spec {

bool TexelRange::holds(int32_t texel) const {
  if (texel < 0 || texel >= size) return false;
  if (address == SELVAGE_ADDRESS_CLAMP) {
    return std::clamp(first, 0, size - 1) <= texel && texel <= std::clamp(last, 0, size - 1);
  }
  const int32_t from_first =
      address_texel(texel - address_texel(first, size, address), size, SELVAGE_ADDRESS_WRAP);
  return from_first <= last - first;
}

std::string TexelRange::text() const {
  const auto between = [](int32_t a, int32_t b) {
    return std::to_string(a) + (a == b ? "" : " .. " + std::to_string(b));
  };
  if (address == SELVAGE_ADDRESS_CLAMP) {
    return between(std::clamp(first, 0, size - 1), std::clamp(last, 0, size - 1));
  }
  if (int64_t{last} - first >= size - 1) return between(0, size - 1);
  const int32_t from = address_texel(first, size, address), to = address_texel(last, size, address);
  return from <= to ? between(from, to) : between(from, size - 1) + " or " + between(0, to);
}

std::optional<Margin> margin_along(const Reaching& reach, int32_t texel, int32_t size,
                                   selvage_address address) {
  const double u = reach.exact.get_d(), below = reach.below.get_d(), above = reach.above.get_d();
  const int32_t at = floor(reach.exact);
  const bool wraps = address == SELVAGE_ADDRESS_WRAP;
  const bool is_beyond = (texel == 0 && at < 0) || (texel == size - 1 && at >= size);
  // The texels at or before `at`, and after it, that address to this one.
  const int64_t before = wraps ? int64_t{at} - address_texel(at - texel, size, address) : texel;
  const int64_t after = wraps ? before + size : texel;
  if (before == at || (!wraps && is_beyond)) {
    const double bound = std::max(below, above);
    return bound > 0 ? std::optional(Margin{0, bound}) : std::nullopt;
  }
  std::optional<Margin> least;
  const auto take = [&](double measured, double bound) {
    const Margin margin{measured, bound};
    if (bound > 0 && (!least || margin.share() < least->share())) least = margin;
  };
  if (before < at) take(u - static_cast<double>(before + 1), below);
  if (after > at) take(static_cast<double>(after) - u, above);
  return least;
}

void add(std::optional<Margin>* nearest, const std::optional<Margin>& other) {
  const auto order = [](const Margin& m) { return std::tuple(m.share(), m.bound, m.measured); };
  if (other && (!*nearest || order(*other) > order(**nearest))) *nearest = other;
}

namespace {

// One axis of a reach, from where the profile takes the texel by its floor.
[[nodiscard]] Reaching along(const Rational& exact, const Rational& below, const Rational& above,
                             const Case& c) {
  Rational rounding(profile_of(c).rounding_fx16, SELVAGE_SUBTEXELS);
  rounding.canonicalize();
  return {exact + rounding, below, above};
}

[[nodiscard]] TexelRange range_of(const Reaching& reach, int32_t size, selvage_address address) {
  return {floor(reach.exact - reach.below), floor(reach.exact + reach.above), size, address};
}

// One axis of an offset.
struct Step {
  double texels;
  bool is_in_place;
};
[[nodiscard]] Step step_along(const Rational& exact, int32_t texel, int32_t size, const Case& c) {
  const Reaching reach = along(exact, 1, 1, c);
  const auto margin = margin_along(reach, texel, size, c.address);
  return {margin ? margin->measured : 0,
          address_texel(floor(reach.exact), size, c.address) == texel};
}

}  // namespace

std::optional<Offset> offset_to(const Texel& texel, const Sample& exact, const Case& shown) {
  const Step u = step_along(exact.u, texel.s, shown.texture_width_texel, shown);
  const Step v = step_along(exact.v, texel.t, shown.texture_height_texel, shown);
  if (u.is_in_place && v.is_in_place) return std::nullopt;
  return Offset{u.texels, v.texels};
}

bool TexelLaw::judge(Pixel at, const Reach& reach, uint32_t drawn, Judgement* judgement) const {
  const Reaching u = along(reach.u, reach.u_below, reach.u_above, shown);
  const Reaching v = along(reach.v, reach.v_below, reach.v_above, shown);
  const TexelRange s = range_of(u, shown.texture_width_texel, shown.address);
  const TexelRange t = range_of(v, shown.texture_height_texel, shown.address);
  const Texel texel = texel_of(drawn);
  ++judgement->judged_px;
  if (s.holds(texel.s) && t.holds(texel.t)) {
    add(&judgement->margin, margin_along(u, texel.s, s.size, shown.address));
    add(&judgement->margin, margin_along(v, texel.t, t.size, shown.address));
    return true;
  }
  const bool is_one = s.first == s.last && t.first == t.last;
  judgement->violation =
      violation_at(name, what, shown, at.x_px, at.y_px,
                   is_one ? describe_pixel(shown, addressed_value(shown, {s.first, t.first}))
                          : "columns " + s.text() + ", rows " + t.text(),
                   drawn);
  return false;
}

}  // namespace selvage::spec
