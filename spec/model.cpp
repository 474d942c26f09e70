#include "spec/model.h"

#include <algorithm>

#include "spec/profiles.h"
#include "spec/reach.h"

namespace selvage::spec {

selvage_status validity(const Case& c) {
  if (c.filter != SELVAGE_FILTER_NEAREST && !can_be_filtered(c)) {
    return c.profile != SELVAGE_PROFILE_EXACT ? SELVAGE_ERROR_FILTER_PROFILE
                                              : SELVAGE_ERROR_FILTER_FORMAT;
  }
  const selvage_status outline = validity(c.vertices);
  if (outline != SELVAGE_OK || !profile_of(c).whole_px) return outline;
  const auto has_fraction = [](const selvage_vertex& v) {
    return v.x % SELVAGE_SUBPIXELS != 0 || v.y % SELVAGE_SUBPIXELS != 0;
  };
  const auto differs_in_q = [&](const selvage_vertex& v) { return v.q != c.vertices.front().q; };
  if (std::ranges::any_of(c.vertices, has_fraction)) return SELVAGE_ERROR_VERTEX_FRACTION;
  if (std::ranges::any_of(c.vertices, differs_in_q)) return SELVAGE_ERROR_VERTEX_Q_DIFFERS;
  return SELVAGE_OK;
}

ModelRow::ModelRow(const Case& c, int32_t y_px) : y_px_(y_px) {
  if (c.profile == SELVAGE_PROFILE_EXACT) {
    line_ = scan_line(c.vertices, y_px);
  } else {
    line_ = historic_line(c.profile, c.vertices, y_px);
  }
  if (c.profile == SELVAGE_PROFILE_ABRASH57) block_shift_ = centred_block_shift(c.vertices);
}

std::optional<Texel> ModelRow::texel(int32_t x_px) const {
  if (const auto* exact = std::get_if<std::optional<ScanLine>>(&line_)) {
    const std::optional<Sample> point = *exact ? sample(**exact, x_px) : std::nullopt;
    return point ? std::optional(Texel{floor(point->u), floor(point->v)}) : std::nullopt;
  }
  const auto& historic = std::get<std::optional<HistoricLine>>(line_);
  if (!historic || !historic->covers(x_px)) return std::nullopt;
  if (block_shift_) return Texel{x_px + block_shift_->s, y_px_ + block_shift_->t};
  return dda_texel(*historic, x_px);
}

std::optional<Sample> ModelRow::coordinates(int32_t x_px) const {
  if (const auto* exact = std::get_if<std::optional<ScanLine>>(&line_)) {
    return *exact ? sample(**exact, x_px) : std::nullopt;
  }
  const auto& historic = std::get<std::optional<HistoricLine>>(line_);
  const std::optional<Reach> point = historic ? reach(*historic, x_px) : std::nullopt;
  return point ? std::optional(Sample{point->u, point->v}) : std::nullopt;
}

}  // namespace selvage::spec
