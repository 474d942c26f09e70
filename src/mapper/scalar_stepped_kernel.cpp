// Stepped rows for every machine: the lanes of the vector kernels, a pixel at a time.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "mapper/address.h"
#include "mapper/image.h"
#include "mapper/kernel.h"
#include "mapper/layout.h"
#include "mapper/stepped.h"

namespace selvage::mapper {
namespace {

struct SteppedRow {
  Span span;   // the pixels to be drawn
  Span whole;  // the row that the lanes are of: holds the span
  DividedLanes lanes;
  int32_t segment_px;
};

struct Point {
  double u_fx16, v_fx16;
};

// The segments of a row, from that of the span's first pixel on.
class SegmentWalk {
 public:
  explicit SegmentWalk(const SteppedRow& row)
      : row_(row),
        px_((row.span.left_px - row.whole.left_px) / row.segment_px * row.segment_px),
        from_(at(px_)) {}

  [[nodiscard]] int32_t first_px() const { return row_.whole.left_px + px_; }
  // The segment that starts at first_px(); then goes to the next one.
  [[nodiscard]] Segment next() {
    const int32_t end_px = std::min(px_ + row_.segment_px, row_.whole.width_px() - 1);
    const Point to = at(end_px);
    const double per_px =
        1.0 / std::max<int32_t>(end_px - px_, 1);  // a single pixel is a segment too
    const Segment segment{
        {whole(from_.u_fx16) << kStepShift, whole(from_.v_fx16) << kStepShift},
        {step((to.u_fx16 - from_.u_fx16) * per_px), step((to.v_fx16 - from_.v_fx16) * per_px)}};
    px_ += row_.segment_px;
    from_ = to;
    return segment;
  }

 private:
  [[nodiscard]] Point at(int32_t px) const {
    const double w = 1.0 / value(row_.lanes.denominator(), px);
    const auto quotient_fx16 = [&](const DividedLanes::Linear& numerator_fx32) {
      return (value(numerator_fx32, px) * w - static_cast<double>(row_.lanes.error_fx32())) *
             kStepUnit_fx16;
    };
    return {quotient_fx16(row_.lanes.u_numerator_fx32()),
            quotient_fx16(row_.lanes.v_numerator_fx32())};
  }
  [[nodiscard]] static double value(const DividedLanes::Linear& line, double px) {
    return line.start + px * line.step;
  }
  [[nodiscard]] static int64_t whole(double fx16) { return static_cast<int64_t>(std::floor(fx16)); }
  [[nodiscard]] static int64_t step(double fx16) { return static_cast<int64_t>(step_fx32(fx16)); }

  const SteppedRow& row_;
  int32_t px_;  // of the segment, counted from the row's first pixel
  Point from_;
};

// Of the i-th pixel of a group whose first one has the lane.
[[nodiscard]] int32_t texel(int64_t lane_fx32, int64_t step_fx32, int32_t i) {
  return static_cast<int32_t>(((lane_fx32 >> kStepShift) + (i * step_fx32 >> kStepShift)) >>
                              kTexelFraction);
}

template <class Pixel, class Address, class Layout>
void draw_part(const SegmentPart& part, const selvage_texture texture, char* row) {
  const char* texels = static_cast<const char*>(texture.texels);
  const ptrdiff_t pitch_texel = texture.pitch / ptrdiff_t{sizeof(Pixel)};
  const Lane step = part.segment.step;
  int32_t px = part.left_px;
  for (int32_t group_px = part.group_px(); px < part.right_px; group_px += kStepGroup_px) {
    const Lane lane = part.at(group_px);
    const int32_t end_px = std::min(group_px + kStepGroup_px, part.right_px);
    for (; px < end_px; ++px) {
      const int32_t s = texel(lane.u_fx32, step.u_fx32, px - group_px);
      const int32_t t = texel(lane.v_fx32, step.v_fx32, px - group_px);
      const ptrdiff_t place = Layout::row(Address::index(t, texture.height), pitch_texel) +
                              Layout::column(Address::index(s, texture.width));
      std::memcpy(row + px * ptrdiff_t{sizeof(Pixel)}, texels + place * ptrdiff_t{sizeof(Pixel)},
                  sizeof(Pixel));
    }
  }
}

// Whether all texels of a part lie in the texture: lanes go one way, but for what their floors take
// away.
[[nodiscard]] bool is_inside(const SegmentPart& part, const selvage_texture& texture) {
  const auto all_in = [](int64_t first_fx32, int64_t last_fx32, int32_t size_texel) {
    constexpr int64_t kFloors_fx32 = int64_t{kStepTruncations_fx16} << kStepShift;
    return std::min(first_fx32, last_fx32) >= kFloors_fx32 &&
           std::max(first_fx32, last_fx32) < int64_t{size_texel} << kLaneFraction;
  };
  const Lane first = part.at(part.left_px), last = part.at(part.right_px - 1);
  return all_in(first.u_fx32, last.u_fx32, texture.width) &&
         all_in(first.v_fx32, last.v_fx32, texture.height);
}

template <class Pixel, class Address, class Layout>
void draw_parts(const SteppedRow& of, const Surface& surface) {
  char* const row = static_cast<char*>(surface.target.pixels) + of.span.row * surface.target.pitch;
  SegmentWalk walk(of);
  for (int32_t left_px = of.span.left_px; left_px < of.span.right_px;) {
    const int32_t first_px = walk.first_px();
    const int32_t right_px = std::min(first_px + of.segment_px, of.span.right_px);
    const SegmentPart part{walk.next(), first_px, left_px, right_px};
    if (is_inside(part, surface.texture)) {
      draw_part<Pixel, Inside, Layout>(part, surface.texture, row);
    } else {
      draw_part<Pixel, Address, Layout>(part, surface.texture, row);
    }
    left_px = right_px;
  }
}

template <class Pixel, class Address>
void draw_laid_out(const SteppedRow& of, const Surface& surface) {
  with_layout(surface.texture.layout,
              [&](auto layout) { draw_parts<Pixel, Address, decltype(layout)>(of, surface); });
}

template <class Pixel>
void draw_pixels(const SteppedRow& of, const Surface& surface) {
  if (surface.address == SELVAGE_ADDRESS_CLAMP) return draw_laid_out<Pixel, Clamp>(of, surface);
  if (WrapMasked::fits(surface.texture.width) && WrapMasked::fits(surface.texture.height)) {
    return draw_laid_out<Pixel, WrapMasked>(of, surface);
  }
  draw_laid_out<Pixel, Wrap>(of, surface);
}

void draw_row(const SteppedRow& row, const Surface& surface) {
  switch (surface.target.format) {
    case SELVAGE_INDEX8:
      return draw_pixels<uint8_t>(row, surface);
    case SELVAGE_RGB565:
      return draw_pixels<uint16_t>(row, surface);
    default:
      return draw_pixels<uint32_t>(row, surface);
  }
}

}  // namespace

void draw_stepped_scalar(const SteppedSpans& spans, const Surface& surface) {
  for (int32_t i = 0; i < spans.batch.rows; ++i) {
    const Span span = spans.batch.span(i), whole = spans.whole.span(i);
    if (!span.empty()) draw_row({span, whole, spans.field.of(whole), spans.segment_px[i]}, surface);
  }
}

}  // namespace selvage::mapper
