// Draws a part of what was prepared, and gives half of what is left away when another worker wants
// it. Each cut between workers sets polygons up twice: so there is none that nobody asked for.
// Large polygons alone are drawn in pieces, between which it listens.
#pragma once

#include <cstddef>
#include <cstdint>

#include "many/band_index.h"
#include "many/bands.h"
#include "many/hand_over.h"
#include "many/painter.h"
#include "many/prepare.h"
#include "selvage.h"

namespace selvage::many {

class PartDraw {
 public:
  // Of the same request, index and workers throughout, to which it refers.
  PartDraw(const Request& request, const BandIndex& index, HandOver* others, const Part& part)
      : request_(request),
        index_(index),
        others_(*others),
        bands_(part.bands),
        walk_(index, part.bands, part.first),
        painter_(request, visible(part.bands)) {}

  // But for what is given away.
  void draw_all();

 private:
  // One polygon, from above, so that others need not wait until it is drawn.
  void draw_in_pieces(size_t polygon);
  // The first bands of what is left of it.
  [[nodiscard]] BandRange piece_of(size_t polygon, BandRange left) const;

  [[nodiscard]] bool is_asked(size_t polygon) const {
    return others_.waiting() != 0 && polygon >= next_answer_;
  }
  // Where all polygons before this one are drawn, and of this one what is not in `left`: gives away
  // bands that are in `left` or below, if anyone takes them.
  void give_half(size_t polygon, BandRange left);

  [[nodiscard]] selvage_rect visible(BandRange bands) const {
    const Rows rows = index_.bands().rows(bands);
    return {request_.visible.left, rows.first, request_.visible.right, rows.end};
  }

  const Request& request_;
  const BandIndex& index_;
  HandOver& others_;
  BandRange bands_;
  BandIndex::Walk walk_;
  Painter painter_;
  size_t next_answer_ = 0, pause_ = 0;  // the polygon at which it listens again, since so many
};

}  // namespace selvage::many
