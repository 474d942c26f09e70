#include "reports/stability/bound.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "spec/profiles.h"

namespace selvage::stability {
namespace {

using spec::Rational;

constexpr double kTooFar = std::numeric_limits<double>::infinity();

// The texels of the plane that are addressed to a drawn one, nearest to a coordinate's own: at or
// below it, and at or above it.
struct Neighbours {
  std::optional<int32_t> below, above;
};

[[nodiscard]] Neighbours neighbours(int32_t own, int32_t drawn, int32_t size_texel,
                                    selvage_address address) {
  if (spec::address_texel(own, size_texel, address) == drawn) return {own, own};
  if (address == SELVAGE_ADDRESS_CLAMP) {
    // Those beyond the border show the border's texel; the border's is the nearest.
    return drawn < own ? Neighbours{drawn, {}} : Neighbours{{}, drawn};
  }
  const int32_t down = spec::address_texel(own - drawn, size_texel, address);
  return {own - down, own - down + size_texel};
}

[[nodiscard]] double part(const Rational& distance, const Rational& bound) {
  if (bound > 0) return Rational(distance / bound).get_d();
  return kTooFar;
}

}  // namespace

double part_of_bound(const Coordinate& coordinate, int32_t drawn, int32_t size_texel,
                     selvage_address address, const Rational& rounding_texel) {
  const Rational place = coordinate.exact + rounding_texel;
  const int32_t own = spec::floor(place);
  const Neighbours shown = neighbours(own, drawn, size_texel, address);
  if (shown.below == own) return 0;
  double least = kTooFar;
  if (shown.below) least = part(place - (*shown.below + 1), coordinate.below);
  if (shown.above) least = std::min(least, part(*shown.above - place, coordinate.above));
  return least;
}

double part_of_bound(const spec::Case& c, const spec::Reach& reach, const spec::Texel& drawn) {
  const Rational rounding = Rational(spec::profile_of(c.profile).rounding_fx16) / SELVAGE_SUBTEXELS;
  return std::max(part_of_bound({reach.u, reach.u_below, reach.u_above}, drawn.s,
                                c.texture_width_texel, c.address, rounding),
                  part_of_bound({reach.v, reach.v_below, reach.v_above}, drawn.t,
                                c.texture_height_texel, c.address, rounding));
}

}  // namespace selvage::stability
