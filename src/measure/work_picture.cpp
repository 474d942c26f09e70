#include "measure/work_picture.h"

#include <array>
#include <cstring>

namespace selvage::measure {
namespace {

inline constexpr size_t kTargetBytes =
    size_t{WorkPicture::kWidth_px} * WorkPicture::kHeight_px * sizeof(uint32_t);
static_assert(kTargetBytes +
                  size_t{WorkPicture::kPitch_texel} * WorkPicture::kSide_texel * sizeof(uint32_t) <=
              SELVAGE_FASTEST_KERNEL_BYTES);

// Turned, and magnified by about 3: all of the target lies within the texture.
[[nodiscard]] selvage_vertex vertex_at(int32_t x_fx8, int32_t y_fx8, int32_t q = 1) {
  return {x_fx8, y_fx8, 80 * x_fx8 - 38 * y_fx8 + (30 << 16), 38 * x_fx8 + 100 * y_fx8 + (9 << 16),
          q};
}

// Nearly all of the target, by rows of different widths.
[[nodiscard]] std::array<selvage_vertex, 4> quadrangle(selvage_work work) {
  constexpr int32_t kFar = 1 << 18;
  const bool flat = work == SELVAGE_WORK_LARGE;
  const auto corner = [&](int32_t x_px, int32_t y_px, int32_t nearness) {
    return vertex_at(x_px * SELVAGE_SUBPIXELS, y_px * SELVAGE_SUBPIXELS,
                     flat ? 1 : nearness * kFar);
  };
  return {corner(3, 0, 4), corner(250, 1, 1), corner(255, 64, 2), corner(9, 62, 7)};
}

// The corners of a mesh's cells, moved by up to 2 px either way.
inline constexpr int32_t kCell_px = 10;
[[nodiscard]] selvage_vertex knot(int32_t column, int32_t row) {
  const auto moved = [](int32_t cells, int32_t seed) {
    return cells * kCell_px * SELVAGE_SUBPIXELS + seed * 389 % 1024 - 2 * SELVAGE_SUBPIXELS;
  };
  return vertex_at(moved(column, column + 7 * row), moved(row, 3 * column + row));
}

}  // namespace

WorkPicture::WorkPicture(selvage_format format, void* memory) {
  const ptrdiff_t bytes = format == SELVAGE_INDEX8 ? 1 : format == SELVAGE_RGB565 ? 2 : 4;
  char* const texels = static_cast<char*>(memory) + kTargetBytes;
  std::memset(texels, 0x5A, SELVAGE_FASTEST_KERNEL_BYTES - kTargetBytes);
  target_ = {memory, kWidth_px, kHeight_px, kWidth_px * bytes, format};
  texture_ = {texels, kSide_texel,         kSide_texel, kPitch_texel * bytes,
              format, SELVAGE_LAYOUT_ROWS, nullptr};
}

void WorkPicture::draw_polygon(const selvage_vertex* vertices, size_t count,
                               const selvage_options& options) const {
  static_cast<void>(selvage_draw(&target_, nullptr, vertices, count, &texture_, &options));
}

void WorkPicture::draw_mesh(const selvage_options& options) const {
  for (int32_t row = 0; row < kHeight_px / kCell_px; ++row) {
    for (int32_t column = 0; column < kWidth_px / kCell_px; ++column) {
      const selvage_vertex a = knot(column, row), b = knot(column + 1, row),
                           c = knot(column + 1, row + 1), d = knot(column, row + 1);
      const selvage_vertex upper[] = {a, b, d}, lower[] = {b, c, d};
      draw_polygon(upper, 3, options);
      draw_polygon(lower, 3, options);
    }
  }
}

void WorkPicture::draw(selvage_work work, selvage_filter filter, selvage_kernel kernel) const {
  const selvage_options options{SELVAGE_PROFILE_EXACT, filter, SELVAGE_ADDRESS_CLAMP, 0, kernel};
  if (work == SELVAGE_WORK_MESH) return draw_mesh(options);
  const auto corners = quadrangle(work);
  draw_polygon(corners.data(), corners.size(), options);
}

}  // namespace selvage::measure
