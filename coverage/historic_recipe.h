// The historic profiles by recipe: the steps of spec/historic.md, pixel by pixel, each of which a
// wrong mapper may replace.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>

#include "coverage/job.h"
#include "spec/exact.h"
#include "spec/subject.h"

namespace selvage::coverage {

// The greatest whole number not above a / b; b > 0.
[[nodiscard]] int64_t floor_quotient(int64_t a, int64_t b);

// An edge of some height, from its upper vertex to its lower one. Whole pixels.
struct HistoricEdge {
  selvage_vertex top, bottom;
  bool runs_down;  // as the outline goes along it
  int32_t top_px, bottom_px;

  [[nodiscard]] int64_t height_px() const { return int64_t{bottom_px} - top_px; }
  [[nodiscard]] int64_t left_px() const { return top.x / SELVAGE_SUBPIXELS; }  // of its top
  [[nodiscard]] int64_t width_px() const { return bottom.x / SELVAGE_SUBPIXELS - left_px(); }
};

// Where an edge meets a row: the column and 1/65536 texels, as the profile rounds them.
struct EdgePoint {
  HistoricEdge edge;
  int64_t rows;  // walked down the edge
  int64_t column_px, u_fx16, v_fx16;
};

// A row between its two ends; the columns that are covered may be none.
struct HistoricSpan {
  EdgePoint left, right;
};

// A coordinate that goes from a to b in `steps` > 0 steps, of which `walked` are done.
using Walk = std::function<int64_t(int64_t a, int64_t b, int64_t walked, int64_t steps)>;

// abrash56: of steps that are truncated.
[[nodiscard]] int64_t truncated_walk(int64_t a, int64_t b, int64_t walked, int64_t steps);
// abrash57: half a step further on.
[[nodiscard]] int64_t prestepped_walk(int64_t a, int64_t b, int64_t walked, int64_t steps);
// dkit: without error; on an edge to whole texels, on a span to 1/65536 of one, rounded down.
[[nodiscard]] int64_t rounded_walk(int64_t a, int64_t b, int64_t walked, int64_t steps);
[[nodiscard]] int64_t even_walk(int64_t a, int64_t b, int64_t walked, int64_t steps);

struct HistoricRecipe {
  // The steps of a profile.
  explicit HistoricRecipe(selvage_profile id);

  selvage_profile profile;
  // Pixel (x, y) belongs to the clip rectangle.
  std::function<bool(const Job&, int32_t x, int32_t y)> in_clip = coverage::in_clip;
  // Row y meets the edge.
  std::function<bool(const Job&, const HistoricEdge&, int32_t y)> meets;
  // The rows walked down it, in the target and in the source.
  using Rows = std::function<int64_t(const Job&, const HistoricEdge&, int32_t y)>;
  Rows target_rows, source_rows;
  // The column it is in after so many rows.
  std::function<int64_t(const HistoricEdge&, int64_t rows)> column;
  Walk edge_walk;
  // Which of the two ends of a row is the left one. They are in the outline's order.
  std::function<HistoricSpan(const EdgePoint&, const EdgePoint&)> order;
  std::function<bool(const HistoricSpan&, int32_t x)> covers;
  // The steps that a span is divided into, and how many of them lie before column x.
  std::function<int64_t(const Job&, const HistoricSpan&)> steps;
  std::function<int64_t(const Job&, const HistoricSpan&, int32_t x)> walked;
  Walk span_walk;  // never of 0 steps: then it is the left end's coordinate
  // Texel coordinate, before the address mode.
  std::function<int64_t(int64_t fx16)> texel;
  // Along one axis: texel, size, mode.
  std::function<int32_t(int64_t, int32_t, selvage_address)> address;
  // The shift by which an untransformed rectangle is copied, apart from all that.
  std::function<std::optional<spec::Texel>(const Job&)> block_shift;
  // The status that the call ends with.
  EndStatus status = [](selvage_status s) { return s; };
};

[[nodiscard]] spec::Subject subject_of(std::string name, HistoricRecipe recipe);

}  // namespace selvage::coverage
