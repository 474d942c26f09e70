// What the arithmetics share that is no arithmetic: the checking of a call, the window it may draw
// in, and the copying of a texel.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

#include "selvage.h"

namespace selvage::stability {

// A call whose arguments are fine.
struct Call {
  selvage_image target;
  selvage_rect visible;  // what target and clip share; may be empty or inverted
  std::span<const selvage_vertex> outline;
  bool affine;  // all q are equal
  selvage_texture texture;
};

struct Clamp {
  [[nodiscard]] static int32_t index(int32_t texel, int32_t size_texel) {
    return std::clamp(texel, 0, size_texel - 1);
  }
};

struct Wrap {
  [[nodiscard]] static int32_t index(int32_t texel, int32_t size_texel) {
    const int32_t rest = texel % size_texel;
    return rest < 0 ? rest + size_texel : rest;
  }
};

// The address mode is a type and the size of a pixel a constant, so that a copy is one move.
template <size_t kPixelBytes, class Address>
class Pixels {
 public:
  explicit Pixels(const Call& call) : target_(call.target), texture_(call.texture) {}

  [[nodiscard]] char* row(int32_t y_px) const {
    return static_cast<char*>(target_.pixels) + y_px * target_.pitch;
  }

  // Any texel: it is addressed into the texture.
  void copy(char* row, int32_t x_px, int32_t s, int32_t t) const {
    const ptrdiff_t column = Address::index(s, texture_.width);
    const char* texels = static_cast<const char*>(texture_.texels) +
                         Address::index(t, texture_.height) * texture_.pitch;
    constexpr auto pixel_bytes = static_cast<ptrdiff_t>(kPixelBytes);
    std::memcpy(row + x_px * pixel_bytes, texels + column * pixel_bytes, kPixelBytes);
  }

 private:
  selvage_image target_;
  selvage_texture texture_;
};

template <class Address, class Paint>
void paint_in_format(const Call& call, const Paint& paint) {
  switch (call.target.format) {
    case SELVAGE_INDEX8:
      return paint(call, Pixels<1, Address>(call));
    case SELVAGE_RGB565:
      return paint(call, Pixels<2, Address>(call));
    default:
      return paint(call, Pixels<4, Address>(call));
  }
}

// Calls paint(call, pixels) if the arguments are fine. What is checked is no part of an arithmetic:
// selvage_draw does it, asked for nothing else by an empty clip.
template <class Paint>
[[nodiscard]] selvage_status draw_checked(const selvage_image* target, const selvage_rect* clip,
                                          const selvage_vertex* vertices, size_t count,
                                          const selvage_texture* texture,
                                          const selvage_options* options, const Paint& paint) {
  const selvage_rect nothing{0, 0, 0, 0};
  const selvage_status status = selvage_draw(target, &nothing, vertices, count, texture, options);
  if (status != SELVAGE_OK) return status;
  selvage_rect visible{0, 0, target->width, target->height};
  if (clip != nullptr) {
    visible = {std::max(clip->left, 0), std::max(clip->top, 0),
               std::min(clip->right, target->width), std::min(clip->bottom, target->height)};
  }
  const std::span outline(vertices, count);
  const bool affine = std::all_of(outline.begin(), outline.end(), [&](const selvage_vertex& v) {
    return v.q == outline.front().q;
  });
  const Call call{*target, visible, outline, affine, *texture};
  if (options != nullptr && options->address == SELVAGE_ADDRESS_WRAP)
    paint_in_format<Wrap>(call, paint);
  else
    paint_in_format<Clamp>(call, paint);
  return SELVAGE_OK;
}

}  // namespace selvage::stability
