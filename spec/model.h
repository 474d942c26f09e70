// The model of a case: what its profile says about each pixel, whatever the profile.
#pragma once

#include <cstdint>
#include <optional>
#include <variant>

#include "spec/case.h"
#include "spec/dda.h"
#include "spec/exact.h"

namespace selvage::spec {

// What a mapper must answer: SELVAGE_OK, or the first of SELVAGE_ERROR_FILTER_PROFILE,
// SELVAGE_ERROR_FILTER_FORMAT, SELVAGE_ERROR_VERTEX_COUNT, SELVAGE_ERROR_NOT_MONOTONE and, in
// historic profiles, SELVAGE_ERROR_VERTEX_FRACTION and SELVAGE_ERROR_VERTEX_Q_DIFFERS that applies.
[[nodiscard]] selvage_status validity(const Case& c);
// It is one that a mapper must draw.
[[nodiscard]] inline bool is_valid(const Case& c) { return validity(c) == SELVAGE_OK; }

// One row of a valid case. Target and clip do not matter.
class ModelRow {
 public:
  ModelRow(const Case& c, int32_t y_px);

  // The texel that the profile shows at column x_px, not yet addressed; empty if not covered.
  [[nodiscard]] std::optional<Texel> texel(int32_t x_px) const;
  // The exact coordinates there: those that are to be shown, or, in a historic profile, those that
  // its arithmetic is an approximation of.
  [[nodiscard]] std::optional<Sample> coordinates(int32_t x_px) const;

 private:
  int32_t y_px_;
  std::variant<std::optional<ScanLine>, std::optional<HistoricLine>> line_;
  std::optional<Texel> block_shift_;
};

}  // namespace selvage::spec
