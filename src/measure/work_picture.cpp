#include "measure/work_picture.h"

#include <array>
#include <cstring>

namespace selvage::measure {
namespace {

// Turned, and magnified by about 3; or minified by about 2.
inline constexpr WorkShape kMagnified{64, 120, 120, 124, 80, -38, 38, 100, 30, 9};
inline constexpr WorkShape kMinified{20, 560, 48, 564, 538, 51, 5, 461, 4, 3};

[[nodiscard]] constexpr size_t target_bytes(const WorkShape& shape) {
  return static_cast<size_t>(WorkPicture::kWidth_px * shape.height_px) * sizeof(uint32_t);
}
[[nodiscard]] constexpr size_t bytes(const WorkShape& shape) {
  return target_bytes(shape) +
         static_cast<size_t>(shape.pitch_texel * shape.texture_height) * sizeof(uint32_t);
}
static_assert(bytes(kMagnified) <= SELVAGE_FASTEST_KERNEL_BYTES);
static_assert(bytes(kMinified) <= SELVAGE_FASTEST_KERNEL_BYTES);

// Nearly all of the target, by rows of different widths.
[[nodiscard]] std::array<selvage_vertex, 4> quadrangle(const WorkShape& shape, selvage_work work) {
  constexpr int32_t kFar = 1 << 18;
  const bool flat = work == SELVAGE_WORK_LARGE;
  const auto corner = [&](int32_t x_px, int32_t y_px, int32_t nearness) {
    return shape.vertex_at(x_px * SELVAGE_SUBPIXELS, y_px * SELVAGE_SUBPIXELS,
                           flat ? 1 : nearness * kFar);
  };
  const int32_t bottom_px = shape.height_px;
  return {corner(3, 0, 4), corner(250, 1, 1), corner(255, bottom_px, 2),
          corner(9, bottom_px * 31 / 32, 7)};
}

// The corners of a mesh's cells, moved by up to 2 px either way.
inline constexpr int32_t kCell_px = 10;
[[nodiscard]] selvage_vertex knot(const WorkShape& shape, int32_t column, int32_t row) {
  const auto moved = [](int32_t cells, int32_t seed) {
    return cells * kCell_px * SELVAGE_SUBPIXELS + seed * 389 % 1024 - 2 * SELVAGE_SUBPIXELS;
  };
  return shape.vertex_at(moved(column, column + 7 * row), moved(row, 3 * column + row), 1);
}

}  // namespace

WorkPicture::WorkPicture(selvage_filter filter, selvage_format format, void* memory)
    : filter_(filter), shape_(filter == SELVAGE_FILTER_AREA ? kMinified : kMagnified) {
  const ptrdiff_t pixel_bytes = format == SELVAGE_INDEX8 ? 1 : format == SELVAGE_RGB565 ? 2 : 4;
  char* const texels = static_cast<char*>(memory) + target_bytes(shape_);
  std::memset(texels, 0x5A, SELVAGE_FASTEST_KERNEL_BYTES - target_bytes(shape_));
  target_ = {memory, kWidth_px, shape_.height_px, kWidth_px * pixel_bytes, format};
  texture_ = {texels,
              shape_.texture_width,
              shape_.texture_height,
              shape_.pitch_texel * pixel_bytes,
              format,
              SELVAGE_LAYOUT_ROWS,
              nullptr};
}

void WorkPicture::draw_polygon(std::span<const selvage_vertex> vertices,
                               selvage_kernel kernel) const {
  const selvage_options options{SELVAGE_PROFILE_EXACT, filter_, SELVAGE_ADDRESS_CLAMP, 0, kernel};
  static_cast<void>(
      selvage_draw(&target_, nullptr, vertices.data(), vertices.size(), &texture_, &options));
}

void WorkPicture::draw_mesh(selvage_kernel kernel) const {
  for (int32_t row = 0; row < shape_.height_px / kCell_px; ++row) {
    for (int32_t column = 0; column < kWidth_px / kCell_px; ++column) {
      const selvage_vertex a = knot(shape_, column, row), b = knot(shape_, column + 1, row),
                           c = knot(shape_, column + 1, row + 1), d = knot(shape_, column, row + 1);
      draw_polygon(std::array{a, b, d}, kernel);
      draw_polygon(std::array{b, c, d}, kernel);
    }
  }
}

// In perspective the map of all four corners is no plane's. Of the area filter most of what is done
// there is the same for all kernels: it draws both halves by themselves.
void WorkPicture::draw(selvage_work work, selvage_kernel kernel) const {
  if (work == SELVAGE_WORK_MESH) return draw_mesh(kernel);
  const auto corners = quadrangle(shape_, work);
  if (filter_ != SELVAGE_FILTER_AREA || work == SELVAGE_WORK_LARGE) {
    return draw_polygon(corners, kernel);
  }
  draw_polygon(std::span(corners).first(3), kernel);
  draw_polygon(std::array{corners[0], corners[2], corners[3]}, kernel);
}

}  // namespace selvage::measure
