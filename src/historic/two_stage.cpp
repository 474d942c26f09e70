#include "historic/two_stage.h"

#include <algorithm>
#include <optional>

#include "historic/block.h"
#include "historic/texel_row.h"
#include "historic/whole_px.h"
#include "mapper/copy_row.h"
#include "mapper/image.h"

namespace selvage::historic {
namespace {

inline constexpr int64_t kTexel_fx16 = SELVAGE_SUBTEXELS;

// A source coordinate walked along a span; see texel_row.h.
struct SpanWalk : SourceWalk {
  using SourceWalk::SourceWalk;

  [[nodiscard]] int32_t texel() const { return texel(0); }
  [[nodiscard]] int32_t texel(int32_t px) const {
    return static_cast<int32_t>((at_fx16 + step_fx16 * px) >> 16);
  }
  void step() { at_fx16 += step_fx16; }
  [[nodiscard]] bool is_unit() const { return step_fx16 == kTexel_fx16; }
  [[nodiscard]] bool is_constant() const { return step_fx16 == 0; }
};

// From the left edge's coordinate to the right edge's in as many steps as there are whole columns
// between them, `skipped_px` of which the clip hides.
[[nodiscard]] SpanWalk span_walk(int64_t left_fx16, int64_t right_fx16, int32_t width_px,
                                 int32_t skipped_px, Prestep prestep) {
  SpanWalk walk(left_fx16, right_fx16, width_px, prestep);
  walk.advance(skipped_px);
  if (prestep == Prestep::kHalf) walk.at_fx16 += kTexel_fx16 / 2;  // texel centres at whole u
  return walk;
}

}  // namespace

void draw_two_stage(const selvage_image& target, const selvage_rect& visible,
                    const mapper::Polygon& polygon, const selvage_texture& texture,
                    selvage_address address, Prestep prestep) {
  EdgeScan left(polygon, EdgeScan::Direction::kLeft, prestep);
  EdgeScan right(polygon, EdgeScan::Direction::kRight, prestep);
  const std::optional<BlockShift> block =
      prestep == Prestep::kHalf ? block_shift(polygon) : std::nullopt;

  const int32_t end_row = std::min(polygon.bottom_row, visible.bottom);
  for (int32_t row = std::max(polygon.top_row, visible.top); row < end_row; ++row) {
    left.go_to(row);
    right.go_to(row);
    const int32_t width_px = right.column_px() - left.column_px();
    const int32_t first_px = std::max(left.column_px(), visible.left);
    const int32_t end_px = std::min(right.column_px(), visible.right);
    if (first_px >= end_px) continue;

    char* const pixels = static_cast<char*>(target.pixels) + row * target.pitch +
                         first_px * mapper::bytes_per_pixel(target.format);
    if (block) {
      mapper::copy_row(texture, address, first_px + block->ds, row + block->dt, end_px - first_px,
                       pixels);
      continue;
    }
    const int32_t skipped_px = first_px - left.column_px();
    const TexelRow out{pixels, end_px - first_px, texture, address};
    write_row(out, span_walk(left.u_fx16(), right.u_fx16(), width_px, skipped_px, prestep),
              span_walk(left.v_fx16(), right.v_fx16(), width_px, skipped_px, prestep));
  }
}

}  // namespace selvage::historic
