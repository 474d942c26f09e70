// The kernels for every machine: a pixel at a time.
#include <cstring>

#include "mapper/address.h"
#include "mapper/image.h"
#include "mapper/kernel.h"
#include "mapper/layout.h"
#include "mapper/scalar_blend_kernel.h"
#include "mapper/texel_index.h"

namespace selvage::mapper {
namespace {

// Lanes and texture come by value: no store through `pixel` can change them.
template <class Pixel, class Address, class Layout, class Lanes>
void draw_laid_out(RowOnDemand& exact, const int32_t width_px, const Lanes lanes,
                   const selvage_texture texture, char* pixel) {
  const char* texels = static_cast<const char*>(texture.texels);
  const ptrdiff_t pitch_texel = texture.pitch / ptrdiff_t{sizeof(Pixel)};
  for (int32_t offset_px = 0; offset_px < width_px; ++offset_px) {
    const Lane lane = lanes.at(offset_px);
    const TexelIndex texel = texel_under(lane, lanes.margin_fx32(), exact, offset_px);
    const ptrdiff_t place = Layout::row(Address::index(texel.t, texture.height), pitch_texel) +
                            Layout::column(Address::index(texel.s, texture.width));
    std::memcpy(pixel, texels + place * ptrdiff_t{sizeof(Pixel)}, sizeof(Pixel));
    pixel += sizeof(Pixel);
  }
}

template <class Pixel, class Address, class Lanes>
void draw_texels(RowOnDemand& exact, int32_t width_px, const Lanes& lanes,
                 const selvage_texture& texture, char* pixel) {
  with_layout(texture.layout, [&](auto layout) {
    draw_laid_out<Pixel, Address, decltype(layout)>(exact, width_px, lanes, texture, pixel);
  });
}

[[nodiscard]] bool is_inside(TexelIndex texel, const selvage_texture& texture) {
  return 0 <= texel.s && texel.s < texture.width && 0 <= texel.t && texel.t < texture.height;
}

// u and v are monotone along a span, so its ends tell whether all of it is inside the texture.
template <class Lanes>
[[nodiscard]] bool stays_inside(const Lanes& lanes, RowOnDemand& exact, int32_t width_px,
                                const selvage_texture& texture) {
  const auto inside_at = [&](int32_t offset_px) {
    return is_inside(texel_under(lanes.at(offset_px), lanes.margin_fx32(), exact, offset_px),
                     texture);
  };
  return inside_at(0) && inside_at(width_px - 1);
}

template <class Pixel, class Lanes>
void draw_row(const Lanes& lanes, const ExactMap& map, const Span& span, const Surface& surface) {
  const selvage_texture& texture = surface.texture;
  char* pixel = static_cast<char*>(surface.target.pixels) + span.row * surface.target.pitch +
                span.left_px * ptrdiff_t{sizeof(Pixel)};
  const int32_t width_px = span.width_px();
  RowOnDemand exact(map, span);
  if (stays_inside(lanes, exact, width_px, texture)) {
    return draw_texels<Pixel, Inside>(exact, width_px, lanes, texture, pixel);
  }
  if (surface.address == SELVAGE_ADDRESS_CLAMP) {
    return draw_texels<Pixel, Clamp>(exact, width_px, lanes, texture, pixel);
  }
  if (WrapMasked::fits(texture.width) && WrapMasked::fits(texture.height)) {
    return draw_texels<Pixel, WrapMasked>(exact, width_px, lanes, texture, pixel);
  }
  return draw_texels<Pixel, Wrap>(exact, width_px, lanes, texture, pixel);
}

template <class Lanes>
void draw_lanes(const Lanes& lanes, const ExactMap& map, const Span& span, const Surface& surface) {
  switch (surface.target.format) {
    case SELVAGE_INDEX8:
      return draw_row<uint8_t>(lanes, map, span, surface);
    case SELVAGE_RGB565:
      return draw_row<uint16_t>(lanes, map, span, surface);
    default:
      return draw_row<uint32_t>(lanes, map, span, surface);
  }
}

void draw_affine(const AffineSpans& spans, const Surface& surface) {
  for (int32_t i = 0; i < spans.batch.rows; ++i) {
    const Span span = spans.batch.span(i);
    if (span.empty()) continue;
    const AffineLanes lanes(spans.field.at(span.left_px, span.row), spans.field.step_x,
                            spans.field.margin_fx32);
    draw_lanes(lanes, spans.exact, span, surface);
  }
}

void draw_projective(const ProjectiveSpans& spans, const Surface& surface) {
  for (int32_t i = 0; i < spans.batch.rows; ++i) {
    const Span span = spans.batch.span(i);
    if (!span.empty()) draw_lanes(spans.field.of(span), spans.exact, span, surface);
  }
}

[[nodiscard]] bool always_pays(const AffineField& /*field*/, const Surface& /*surface*/) {
  return true;
}

constexpr Kernels kScalar = {
    .find_spans = find_spans_scalar,
    .find_lanes = find_lanes_scalar,
    .find_ruled_lanes = find_ruled_lanes_scalar,
    .draw_affine = draw_affine,
    .draw_projective = draw_projective,
    .pays_near_plane = always_pays,
    .draw_near_plane = draw_affine,
    .draw_stepped = draw_stepped_scalar,
};

}  // namespace

const Kernels& scalar_kernels(selvage_filter filter) {
  switch (filter) {
    case SELVAGE_FILTER_FOUR:
      return kFourScalar;
    case SELVAGE_FILTER_BILINEAR:
      return kBilinearScalar;
    case SELVAGE_FILTER_AREA:
      return kAreaScalar;
    default:
      return kScalar;
  }
}

}  // namespace selvage::mapper
