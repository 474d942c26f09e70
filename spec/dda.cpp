#include "spec/dda.h"

#include <algorithm>
#include <array>

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
  if (vertices.size() != 4) return std::nullopt;
  const auto [x_least, x_most] = std::ranges::minmax(vertices, {}, &selvage_vertex::x);
  const auto [y_least, y_most] = std::ranges::minmax(vertices, {}, &selvage_vertex::y);
  const int32_t left = x_least.x, right = x_most.x, top = y_least.y, bottom = y_most.y;
  if (left == right || top == bottom) return std::nullopt;

  const auto texel_of = [](int32_t position_fx8, bool far_side) {
    return (int64_t{position_fx8} / SELVAGE_SUBPIXELS - (far_side ? 1 : 0)) * SELVAGE_SUBTEXELS;
  };
  const int64_t ds_fx16 = vertices[0].u - texel_of(vertices[0].x, vertices[0].x == right);
  const int64_t dt_fx16 = vertices[0].v - texel_of(vertices[0].y, vertices[0].y == bottom);
  if (ds_fx16 % SELVAGE_SUBTEXELS != 0 || dt_fx16 % SELVAGE_SUBTEXELS != 0) return std::nullopt;
  for (size_t i = 0; i < 4; ++i) {
    const selvage_vertex& v = vertices[i];
    const selvage_vertex& next = vertices[(i + 1) % 4];
    // Clockwise: from the top left rightward, then down, leftward and up.
    const bool clockwise = (v.x == left && v.y == top && next.x == right && next.y == top) ||
                           (v.x == right && v.y == top && next.x == right && next.y == bottom) ||
                           (v.x == right && v.y == bottom && next.x == left && next.y == bottom) ||
                           (v.x == left && v.y == bottom && next.x == left && next.y == top);
    if (!clockwise || v.u - texel_of(v.x, v.x == right) != ds_fx16 ||
        v.v - texel_of(v.y, v.y == bottom) != dt_fx16) {
      return std::nullopt;
    }
  }
  return Texel{static_cast<int32_t>(ds_fx16 / SELVAGE_SUBTEXELS),
               static_cast<int32_t>(dt_fx16 / SELVAGE_SUBTEXELS)};
}

}  // namespace selvage::spec
