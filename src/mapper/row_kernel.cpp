#include "mapper/row_kernel.h"

#include <cstring>

#include "mapper/address.h"
#include "mapper/lanes.h"

namespace selvage::mapper {
namespace {

struct TexelIndex {
  int32_t s, t;
};

[[nodiscard]] inline bool is_near_tie(int64_t lane_fx32, uint32_t margin_fx32) {
  return static_cast<uint32_t>(lane_fx32) >= 0U - margin_fx32;
}

// The exact texel under lanes of which one at least is a near-tie. Rare, and kept out of the loop.
[[nodiscard, gnu::noinline]] TexelIndex decide(const ExactTexel& exact, const Span& span,
                                               int32_t px, Lane lane, uint32_t margin_fx32) {
  TexelIndex texel{static_cast<int32_t>(lane.u_fx32 >> kLaneFraction),
                   static_cast<int32_t>(lane.v_fx32 >> kLaneFraction)};
  if (is_near_tie(lane.u_fx32, margin_fx32)) texel.s = exact.u(px, span.row, texel.s);
  if (is_near_tie(lane.v_fx32, margin_fx32)) texel.t = exact.v(px, span.row, texel.t);
  return texel;
}

// floor u and floor v at a pixel: those of the lanes, which are exact unless near-ties.
template <class Lanes>
[[nodiscard]] inline TexelIndex texel_at(const ExactTexel& exact, const Span& span,
                                         const Lanes& lanes, int32_t offset_px) {
  const Lane lane = lanes.at(offset_px);
  const uint32_t margin = lanes.margin_fx32();
  if (is_near_tie(lane.u_fx32, margin) || is_near_tie(lane.v_fx32, margin)) [[unlikely]] {
    return decide(exact, span, span.left_px + offset_px, lane, margin);
  }
  return {static_cast<int32_t>(lane.u_fx32 >> kLaneFraction),
          static_cast<int32_t>(lane.v_fx32 >> kLaneFraction)};
}

// Lanes, span and texture come by value: no store through `pixel` can change them.
template <class Pixel, class Address, class Lanes>
void draw_texels(const ExactTexel& exact, const Span span, const Lanes lanes,
                 const selvage_texture texture, char* pixel) {
  const char* texels = static_cast<const char*>(texture.texels);
  for (int32_t offset_px = 0; offset_px < span.width_px(); ++offset_px) {
    const TexelIndex texel = texel_at(exact, span, lanes, offset_px);
    const ptrdiff_t s = Address::index(texel.s, texture.width);
    const ptrdiff_t t = Address::index(texel.t, texture.height);
    std::memcpy(pixel, texels + t * texture.pitch + s * ptrdiff_t{sizeof(Pixel)}, sizeof(Pixel));
    pixel += sizeof(Pixel);
  }
}

[[nodiscard]] bool is_inside(TexelIndex texel, const selvage_texture& texture) {
  return 0 <= texel.s && texel.s < texture.width && 0 <= texel.t && texel.t < texture.height;
}

// u and v are monotone along a span, so its ends tell whether all of it is inside the texture.
template <class Pixel, class Lanes>
void draw_row(const Lanes& lanes, const ExactTexel& exact, const Span& span,
              const selvage_texture& texture, selvage_address address, void* row) {
  char* pixel = static_cast<char*>(row) + ptrdiff_t{span.left_px} * ptrdiff_t{sizeof(Pixel)};
  if (is_inside(texel_at(exact, span, lanes, 0), texture) &&
      is_inside(texel_at(exact, span, lanes, span.width_px() - 1), texture)) {
    draw_texels<Pixel, Inside>(exact, span, lanes, texture, pixel);
  } else if (address == SELVAGE_ADDRESS_CLAMP) {
    draw_texels<Pixel, Clamp>(exact, span, lanes, texture, pixel);
  } else if (WrapMasked::fits(texture.width) && WrapMasked::fits(texture.height)) {
    draw_texels<Pixel, WrapMasked>(exact, span, lanes, texture, pixel);
  } else {
    draw_texels<Pixel, Wrap>(exact, span, lanes, texture, pixel);
  }
}

template <class Lanes>
[[nodiscard]] RowKernel<Lanes> kernel_of(selvage_format format) {
  switch (format) {
    case SELVAGE_INDEX8:
      return draw_row<uint8_t, Lanes>;
    case SELVAGE_RGB565:
      return draw_row<uint16_t, Lanes>;
    default:
      return draw_row<uint32_t, Lanes>;
  }
}

}  // namespace

RowKernel<AffineLanes> affine_row_kernel(selvage_format format) {
  return kernel_of<AffineLanes>(format);
}

RowKernel<ProjectiveLanes> projective_row_kernel(selvage_format format) {
  return kernel_of<ProjectiveLanes>(format);
}

}  // namespace selvage::mapper
