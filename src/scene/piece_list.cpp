#include "scene/piece_list.h"

#include <algorithm>
#include <utility>

namespace selvage::scene {

void PieceList::add(int32_t row, const RowSpan& span, int32_t first_px, int32_t end_px) {
  const int32_t left_px = first_px == span.first_px() ? 0 : first_px;
  const int32_t right_px = end_px == span.end_px() ? width_px_ : end_px;
  std::vector<size_t>& last = last_of_face_[span.face()];
  std::erase_if(last, [&](size_t piece) { return pieces_[piece].clip.bottom < row; });
  for (const size_t piece : last) {
    selvage_rect& clip = pieces_[piece].clip;
    if (clip.bottom == row && clip.left == left_px && clip.right == right_px) {
      clip.bottom = row + 1;
      return;
    }
  }
  last.push_back(pieces_.size());
  pieces_.push_back({span.face(), {left_px, row, right_px, row + 1}});
}

std::vector<Piece> PieceList::take() && {
  std::ranges::stable_sort(pieces_, {}, &Piece::face);
  return std::move(pieces_);
}

}  // namespace selvage::scene
