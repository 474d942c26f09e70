#include "mapper/scalar_blend_kernel.h"

#include <algorithm>
#include <array>

#include "mapper/channels.h"
#include "mapper/filter_blend.h"
#include "mapper/filter_point.h"
#include "mapper/scalar_box_kernel.h"

namespace selvage::mapper {
namespace {

// So many pixels go through the stages at a time: their points stay in the nearest cache.
inline constexpr int32_t kPiece_px = 256;

template <BlendKernel kBlend, class Lanes>
void draw_row(const Lanes& lanes, const ExactMap& map, const Span& span, const Surface& surface) {
  std::array<FilterPoint, kPiece_px> points;
  char* const pixels = static_cast<char*>(surface.target.pixels) + span.row * surface.target.pitch;
  for (int32_t from_px = span.left_px; from_px < span.right_px; from_px += kPiece_px) {
    const int32_t count = std::min(kPiece_px, span.right_px - from_px);
    for (int32_t i = 0; i < count; ++i) {
      points[static_cast<size_t>(i)] = filter_point(map, span, lanes, from_px + i);
    }
    kBlend(std::span(points).first(static_cast<size_t>(count)), surface.texture, surface.address,
           pixels + ptrdiff_t{from_px} * kPixelBytes);
  }
}

template <BlendKernel kBlend>
void draw_affine(const AffineSpans& spans, const Surface& surface) {
  for (int32_t i = 0; i < spans.batch.rows; ++i) {
    draw_row<kBlend>(spans.field, spans.exact, spans.batch.span(i), surface);
  }
}

template <BlendKernel kBlend>
void draw_projective(const ProjectiveSpans& spans, const Surface& surface) {
  for (int32_t i = 0; i < spans.batch.rows; ++i) {
    const Span span = spans.batch.span(i);
    draw_row<kBlend>(spans.field.of(span), spans.exact, span, surface);
  }
}

}  // namespace

constexpr Kernels kFourScalar = {find_spans_scalar, find_lanes_scalar, find_ruled_lanes_scalar,
                                 draw_affine<blend_four>, draw_projective<blend_four>};
constexpr Kernels kBilinearScalar = {find_spans_scalar, find_lanes_scalar, find_ruled_lanes_scalar,
                                     draw_affine<blend_bilinear>, draw_projective<blend_bilinear>};
constexpr Kernels kAreaScalar = {
    .find_spans = find_spans_scalar,
    .find_lanes = find_lanes_scalar,
    .find_ruled_lanes = find_ruled_lanes_scalar,
    .draw_affine = draw_affine<blend_bilinear>,
    .draw_projective = draw_projective<blend_bilinear>,
    .draw_boxes_affine = draw_boxes_affine_scalar,
    .draw_boxes_projective = draw_boxes_projective_scalar,
    .draw_boxes = draw_boxes_scalar,
};

}  // namespace selvage::mapper
