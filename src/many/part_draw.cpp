#include "many/part_draw.h"

#include <algorithm>

#include "many/band_work.h"
#include "many/work_left.h"
#include "mapper/polygon.h"

namespace selvage::many {
namespace {

// Less than this is drawn sooner than another worker would notice.
constexpr double kLeastPiece_px = 32768, kLeastToGive_px = 8192;
// Polygons, after which what could not be halved is judged again; then twice as many, and so on: in
// a list that never can be, judging must not take longer than drawing.
constexpr size_t kFirstPause = 64;

[[nodiscard]] bool is_large(const mapper::Polygon& polygon) {
  const double width_px = polygon.right_px - polygon.left_px,
               rows = polygon.bottom_row - polygon.top_row;
  return width_px * rows > 2 * kLeastPiece_px;
}

}  // namespace

void PartDraw::draw_all() {
  for (size_t i; (i = walk_.next()) != BandIndex::Walk::kEnd;) {
    const Prepared& one = request_.prepared[i];
    if (is_asked(i)) give_half(i, bands_);
    if (is_large(one.polygon)) {
      draw_in_pieces(i);
    } else {
      painter_.draw(one);
    }
  }
  painter_.finish();
}

void PartDraw::draw_in_pieces(size_t polygon) {
  BandRange left = bands_of(request_, index_.bands(), polygon).within(bands_);
  while (left.count() != 0) {
    const BandRange piece = piece_of(polygon, left);
    painter_.show(visible(piece));
    painter_.draw(request_.prepared[polygon]);
    left.first = piece.end;
    if (left.count() != 0 && is_asked(polygon)) give_half(polygon, left);
    left = left.within(bands_);
  }
  painter_.show(visible(bands_));
}

// Half of it: the less is left, the less one waits who comes now.
BandRange PartDraw::piece_of(size_t polygon, BandRange left) const {
  const double band_px = cost_of_band_px(request_, index_.bands(), polygon);
  const size_t least = static_cast<size_t>(kLeastPiece_px / band_px) + 1;
  return {left.first, std::min(left.first + std::max(left.count() / 2, least), left.end)};
}

void PartDraw::give_half(size_t polygon, BandRange left) {
  if (bands_.count() == 1) return;
  const BandWork work = work_left(request_, index_.bands(), {polygon, bands_}, left);
  const BandShares shares(work, bands_);
  const size_t cut = std::max(shares.part(0, 2).end, left.first);
  if (shares.all_px() < kLeastToGive_px || cut == bands_.end) {
    pause_ = std::max(2 * pause_, kFirstPause);
    next_answer_ = polygon + pause_;
    return;
  }
  painter_.finish();
  pause_ = 0;
  bands_.end = others_.give({polygon, {cut, bands_.end}});
  painter_.show(visible(bands_));
  walk_ = {index_, bands_, polygon + 1};
}

}  // namespace selvage::many
