#include "spec/dda.h"

#include <algorithm>

namespace selvage::spec {
namespace {

[[nodiscard]] int64_t floor_quotient(int64_t a, int64_t b) {
  return truncated_quotient(a, b) - (a % b != 0 && (a < 0) != (b < 0) ? 1 : 0);
}

// One coordinate at pixel k of a span of `width` steps, floored or rounded to a texel.
[[nodiscard]] int32_t two_stage(int64_t left_fx16, int64_t right_fx16, int64_t k, int64_t width,
                                bool prestep) {
  const int64_t step = truncated_quotient(right_fx16 - left_fx16, width);
  const int64_t start = left_fx16 + (prestep ? floor_half(step) + SELVAGE_SUBTEXELS / 2 : 0);
  return static_cast<int32_t>(floor_quotient(start + k * step, SELVAGE_SUBTEXELS));
}

[[nodiscard]] int32_t classroom(int64_t left_fx16, int64_t right_fx16, int64_t k, int64_t width) {
  const int64_t left = left_fx16 / SELVAGE_SUBTEXELS, right = right_fx16 / SELVAGE_SUBTEXELS;
  if (width == 0) return static_cast<int32_t>(left);
  return static_cast<int32_t>(left + floor_quotient(2 * k * (right - left) + width, 2 * width));
}

}  // namespace

std::optional<Texel> dda_texel(const HistoricLine& line, int32_t x_px) {
  if (!line.covers(x_px)) return std::nullopt;
  const auto& [profile, left, right] = line;
  const int64_t k = x_px - left.column_px;
  const int64_t width = right.column_px - left.column_px;
  if (profile == SELVAGE_PROFILE_DKIT) {
    return Texel{classroom(left.u_fx16, right.u_fx16, k, width),
                 classroom(left.v_fx16, right.v_fx16, k, width)};
  }
  const bool prestep = profile == SELVAGE_PROFILE_ABRASH57;
  return Texel{two_stage(left.u_fx16, right.u_fx16, k, width, prestep),
               two_stage(left.v_fx16, right.v_fx16, k, width, prestep)};
}

std::optional<Texel> centred_block_shift(std::span<const selvage_vertex> vertices) {
  if (vertices.empty()) return std::nullopt;
  // Per side: x in px, u in texels, both of the first end that is met.
  struct Side {
    std::optional<Rational> x, u;
  } up, down;
  const auto [highest, lowest] = std::ranges::minmax(vertices, {}, &selvage_vertex::y);
  const Rational top = Rational(highest.y) / SELVAGE_SUBPIXELS;
  const Rational height = Rational(lowest.y) / SELVAGE_SUBPIXELS - top;
  std::optional<Rational> top_v;  // what v would be on top, by the end that is met first
  for (size_t i = 0; i < vertices.size(); ++i) {
    const selvage_vertex& from = vertices[i];
    const selvage_vertex& to = vertices[(i + 1) % vertices.size()];
    if (from.y == to.y) continue;
    Side& side = from.y < to.y ? down : up;
    for (const selvage_vertex& end : {from, to}) {
      const Rational x = Rational(end.x) / SELVAGE_SUBPIXELS;
      const Rational u = Rational(end.u) / SELVAGE_SUBTEXELS;
      const Rational rows = Rational(end.y) / SELVAGE_SUBPIXELS - top;
      const Rational v = Rational(end.v) / SELVAGE_SUBTEXELS - rows * (height - 1) / height;
      if (!side.x) side = {x, u};
      if (!top_v) top_v = v;
      if (x != *side.x || u != *side.u || v != *top_v) return std::nullopt;
    }
  }
  if (!up.x || !down.x) return std::nullopt;
  const Rational ds = *up.u - *up.x, dt = *top_v - top;
  if (*down.u - (*down.x - 1) != ds || ds.get_den() != 1 || dt.get_den() != 1) return std::nullopt;
  return Texel{floor(ds), floor(dt)};
}

}  // namespace selvage::spec
