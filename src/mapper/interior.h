// The interior: which pixels surely show texels of the texture, whatever the address mode.
#pragma once

#include <cstdint>

#include "mapper/lanes.h"
#include "mapper/span.h"
#include "mapper/span_batch.h"
#include "selvage.h"

namespace selvage::mapper {

// Whether rows are wide enough for the answer to save more than it costs.
[[nodiscard]] bool pays_to_ask_inside(const SpanBatch& batch);

// Whether the texels that all pixels of a batch show, near-ties among them, lie in the texture.
[[nodiscard]] bool is_inside(const SpanBatch& batch, const AffineField& field,
                             const selvage_texture& texture);

// Columns of a row, still in doubles.
struct Columns {
  double first, end;
};

// Where a lane and what it may lack lie in [1/2, size - 1/2) texels: all lanes are of u - 1/2 here.
class InteriorOfLine {
 public:
  InteriorOfLine(int64_t step_fx32, int32_t size_texel, uint32_t margin_fx32);

  // Leaves the columns where the line is inside.
  void narrow(int64_t lane_fx32, Columns* columns) const;

 private:
  static constexpr double kSlack = 1, kSteep = 0x1p80;

  int64_t end_fx32_;
  double columns_per_fx32_;
};

// The pixels of a row that have the four texels around them in a texture of rows.
class Interior {
 public:
  Interior(const AffineField& field, const selvage_texture& texture);

  // May be empty, and may lack some pixels at its ends.
  [[nodiscard]] Span of(const Span& span) const;

 private:
  AffineField field_;
  bool has_pairs_;  // of texels side by side, and of rows
  InteriorOfLine u_, v_;
};

}  // namespace selvage::mapper
