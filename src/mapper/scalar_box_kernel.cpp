// The area filter for every machine: points, sides, means.
#include <cmath>

#include "mapper/box_row.h"
#include "mapper/channels.h"
#include "mapper/kernel.h"
#include "mapper/plane_footprint.h"
#include "mapper/scalar_blend_kernel.h"
#include "mapper/scalar_box_kernel.h"

namespace selvage::mapper {
namespace {

void fill_sides(BoxSides sides, BoxRow* boxes) {
  boxes->width_fx8.fill(sides.u_fx8);
  boxes->height_fx8.fill(sides.v_fx8);
}

template <class Lanes>
void find_points(const Lanes& lanes, const ExactMap& map, const Span& span, const Span& piece,
                 BoxRow* boxes) {
  for (int32_t px = piece.left_px; px < piece.right_px; ++px) {
    const FilterPoint point = filter_point(map, span, lanes, px);
    const auto i = static_cast<size_t>(px - piece.left_px);
    boxes->u_fx8[i] = point.u_fx8;
    boxes->v_fx8[i] = point.v_fx8;
  }
}

struct SideBounds {
  int32_t least_fx8, most_fx8;
};

[[nodiscard]] SideBounds side_bounds(const FootprintLine& line, double offset_px, double weight) {
  const double changes = line.across + std::abs(line.down_start + offset_px * line.down_step);
  return {ceil_side((changes - line.slack) * weight * weight),
          ceil_side((changes + line.slack) * weight * weight)};
}

void find_sides(const PlaneFootprint& footprint, const FootprintRow& row, const Span& piece,
                BoxRow* boxes) {
  for (int32_t i = 0; i < piece.width_px(); ++i) {
    const double weight = 1 / (row.denominator.start + i * row.denominator.step);
    const SideBounds u = side_bounds(row.u, i, weight), v = side_bounds(row.v, i, weight);
    BoxSides sides{u.most_fx8, v.most_fx8};
    if (u.least_fx8 != u.most_fx8 || v.least_fx8 != v.most_fx8) [[unlikely]] {
      sides = footprint.exact(piece.left_px + i, piece.row, {u.least_fx8, v.least_fx8}, sides);
    }
    boxes->set_sides(i, sides);
  }
}

}  // namespace

void draw_boxes_scalar(const BoxRow& boxes, const Span& piece, const Surface& surface) {
  char* pixel = static_cast<char*>(surface.target.pixels) + piece.row * surface.target.pitch +
                ptrdiff_t{piece.left_px} * kPixelBytes;
  for (int32_t i = 0; i < piece.width_px(); ++i, pixel += kPixelBytes) {
    store_pixel(pixel, box_mean(surface.texture, surface.address, boxes.box(i)));
  }
}

void draw_boxes_affine_scalar(const AffineSpans& spans, BoxSides sides, const Surface& surface) {
  BoxRow boxes;
  fill_sides(sides, &boxes);
  for (int32_t i = 0; i < spans.batch.rows; ++i) {
    const Span span = spans.batch.span(i);
    for_each_box_piece(span, [&](const Span& piece) {
      find_points(spans.field, spans.exact, span, piece, &boxes);
      draw_boxes_scalar(boxes, piece, surface);
    });
  }
}

void draw_boxes_projective_scalar(const ProjectiveSpans& spans, const PlaneFootprint& footprint,
                                  const Surface& surface) {
  BoxRow boxes;
  for (int32_t i = 0; i < spans.batch.rows; ++i) {
    const Span span = spans.batch.span(i);
    const DividedLanes lanes = spans.field.of(span);
    for_each_box_piece(span, [&](const Span& piece) {
      const FootprintRow row = footprint.row(piece);
      if (row.is_least(piece.width_px())) {
        return kBilinearScalar.draw_projective(
            {one_span(piece), spans.field, spans.texels, spans.exact}, surface);
      }
      find_points(lanes, spans.exact, span, piece, &boxes);
      find_sides(footprint, row, piece, &boxes);
      draw_boxes_scalar(boxes, piece, surface);
    });
  }
}

}  // namespace selvage::mapper
