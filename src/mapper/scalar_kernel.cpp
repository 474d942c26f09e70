// The kernels for every machine: a pixel at a time.
#include <cstring>

#include "mapper/address.h"
#include "mapper/image.h"
#include "mapper/kernel.h"
#include "mapper/texel_index.h"

namespace selvage::mapper {
namespace {

// Lanes, span and texture come by value: no store through `pixel` can change them.
template <class Pixel, class Address, class Lanes>
int32_t draw_texels(const ExactMap& exact, const Span span, const Lanes lanes,
                    const selvage_texture texture, char* pixel) {
  const char* texels = static_cast<const char*>(texture.texels);
  int32_t decided = 0;
  for (int32_t px = span.left_px; px < span.right_px; ++px) {
    const Lane lane = lanes.at(px - span.left_px);
    const TexelIndex texel = texel_under(lane, lanes.margin_fx32(), exact, px, span.row);
    const ptrdiff_t s = Address::index(texel.s, texture.width);
    const ptrdiff_t t = Address::index(texel.t, texture.height);
    std::memcpy(pixel, texels + t * texture.pitch + s * ptrdiff_t{sizeof(Pixel)}, sizeof(Pixel));
    pixel += sizeof(Pixel);
    decided += is_near_tie(lane, lanes.margin_fx32()) ? 1 : 0;
  }
  return decided;
}

[[nodiscard]] bool is_inside(TexelIndex texel, const selvage_texture& texture) {
  return 0 <= texel.s && texel.s < texture.width && 0 <= texel.t && texel.t < texture.height;
}

// u and v are monotone along a span, so its ends tell whether all of it is inside the texture.
template <class Lanes>
[[nodiscard]] bool stays_inside(const Lanes& lanes, const ExactMap& exact, const Span& span,
                                const selvage_texture& texture) {
  const auto inside_at = [&](int32_t px) {
    return is_inside(
        texel_under(lanes.at(px - span.left_px), lanes.margin_fx32(), exact, px, span.row),
        texture);
  };
  return inside_at(span.left_px) && inside_at(span.right_px - 1);
}

template <class Pixel, class Lanes>
int32_t draw_row(const Lanes& lanes, const ExactMap& exact, const Span& span,
                 const Surface& surface) {
  const selvage_texture& texture = surface.texture;
  char* pixel = static_cast<char*>(surface.target.pixels) + span.row * surface.target.pitch +
                span.left_px * ptrdiff_t{sizeof(Pixel)};
  if (stays_inside(lanes, exact, span, texture)) {
    return draw_texels<Pixel, Inside>(exact, span, lanes, texture, pixel);
  }
  if (surface.address == SELVAGE_ADDRESS_CLAMP) {
    return draw_texels<Pixel, Clamp>(exact, span, lanes, texture, pixel);
  }
  if (WrapMasked::fits(texture.width) && WrapMasked::fits(texture.height)) {
    return draw_texels<Pixel, WrapMasked>(exact, span, lanes, texture, pixel);
  }
  return draw_texels<Pixel, Wrap>(exact, span, lanes, texture, pixel);
}

template <class Lanes>
int32_t draw_lanes(const Lanes& lanes, const ExactMap& exact, const Span& span,
                   const Surface& surface) {
  switch (surface.target.format) {
    case SELVAGE_INDEX8:
      return draw_row<uint8_t>(lanes, exact, span, surface);
    case SELVAGE_RGB565:
      return draw_row<uint16_t>(lanes, exact, span, surface);
    default:
      return draw_row<uint32_t>(lanes, exact, span, surface);
  }
}

int32_t draw_affine(const AffineSpans& spans, const Surface& surface) {
  int32_t decided = 0;
  for (int32_t i = 0; i < spans.batch.rows; ++i) {
    const Span span = spans.batch.span(i);
    if (span.empty()) continue;
    const AffineLanes lanes(spans.field.at(span.left_px, span.row), spans.field.step_x,
                            spans.field.margin_fx32);
    decided += draw_lanes(lanes, spans.exact, span, surface);
  }
  return decided;
}

int32_t draw_projective(const ProjectiveSpans& spans, const Surface& surface) {
  int32_t decided = 0;
  for (const ProjectiveSpan& each : spans.spans) {
    decided += draw_lanes(each.lanes, spans.exact, each.span, surface);
  }
  return decided;
}

constexpr Kernels kScalar = {draw_affine, draw_projective};

}  // namespace

const Kernels& scalar_kernels() { return kScalar; }

}  // namespace selvage::mapper
