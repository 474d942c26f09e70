#include "spec/historic_line.h"

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

namespace selvage::spec {
namespace {

[[nodiscard]] int32_t whole(int32_t position_fx8) { return position_fx8 / SELVAGE_SUBPIXELS; }

// An edge from its upper vertex to its lower one, and how the outline runs along it.
struct Crossed {
  selvage_vertex top, bottom;
  bool runs_down;
  [[nodiscard]] int32_t height() const { return whole(bottom.y) - whole(top.y); }
};

// a + (b - a) walked / steps, in 1/unit of what is returned.
[[nodiscard]] Rational along(int32_t a, int32_t b, const Rational& walked, int32_t steps,
                             int32_t unit) {
  const Rational reached = a + rational(int64_t{b} - a) * walked / steps;
  return reached / unit;
}

[[nodiscard]] int64_t stepped_fx16(int32_t a_fx16, int32_t b_fx16, int32_t rows, int32_t height,
                                   bool prestep) {
  const int64_t step = truncated_quotient(int64_t{b_fx16} - a_fx16, height);
  return a_fx16 + rows * step + (prestep ? floor_half(step) : 0);
}

[[nodiscard]] int32_t ceiling(const Rational& number) { return -floor(-number); }
[[nodiscard]] int32_t rounded(const Rational& number) { return floor(number + Rational(1, 2)); }

[[nodiscard]] HistoricEnd two_stage_end(const Crossed& edge, int32_t y_px, bool prestep) {
  const auto& [top, bottom, runs_down] = edge;
  const int32_t rows = y_px - whole(top.y), height = edge.height();
  const Rational walked = rows + Rational(prestep ? 1 : 0, 2);
  const Rational x = along(top.x, bottom.x, rows, height, SELVAGE_SUBPIXELS);
  return {x,
          along(top.u, bottom.u, walked, height, SELVAGE_SUBTEXELS),
          along(top.v, bottom.v, walked, height, SELVAGE_SUBTEXELS),
          ceiling(x),
          stepped_fx16(top.u, bottom.u, rows, height, prestep),
          stepped_fx16(top.v, bottom.v, rows, height, prestep),
          rows};
}

[[nodiscard]] HistoricEnd classroom_end(const Crossed& edge, int32_t y_px) {
  HistoricEnd end = two_stage_end(edge, y_px, false);
  end.column_px = rounded(end.x);
  end.u_fx16 = int64_t{rounded(end.u)} * SELVAGE_SUBTEXELS;
  end.v_fx16 = int64_t{rounded(end.v)} * SELVAGE_SUBTEXELS;
  return end;
}

// The edges with y_top <= y < y_bottom; at the outline's lowest row those that end there.
[[nodiscard]] std::vector<Crossed> crossed_edges(std::span<const selvage_vertex> vertices,
                                                 int32_t y_px, bool at_bottom) {
  std::vector<Crossed> crossed;
  for (size_t i = 0; i < vertices.size(); ++i) {
    const selvage_vertex& a = vertices[i];
    const selvage_vertex& b = vertices[(i + 1) % vertices.size()];
    if (a.y == b.y) continue;
    const bool runs_down = a.y < b.y;
    const Crossed edge{runs_down ? a : b, runs_down ? b : a, runs_down};
    const int32_t top = whole(edge.top.y), bottom = whole(edge.bottom.y);
    if (at_bottom ? bottom == y_px : top <= y_px && y_px < bottom) crossed.push_back(edge);
  }
  return crossed;
}

}  // namespace

std::optional<HistoricLine> historic_line(selvage_profile profile,
                                          std::span<const selvage_vertex> vertices, int32_t y_px) {
  const bool classroom = profile == SELVAGE_PROFILE_DKIT;
  const int32_t lowest = whole(std::ranges::max(vertices, {}, &selvage_vertex::y).y);
  std::vector<Crossed> edges = crossed_edges(vertices, y_px, classroom && y_px == lowest);
  if (edges.size() != 2) return std::nullopt;
  if (!classroom) {
    if (edges[0].runs_down) std::swap(edges[0], edges[1]);
    const bool prestep = profile == SELVAGE_PROFILE_ABRASH57;
    return HistoricLine{profile, two_stage_end(edges[0], y_px, prestep),
                        two_stage_end(edges[1], y_px, prestep)};
  }
  HistoricEnd a = classroom_end(edges[0], y_px), b = classroom_end(edges[1], y_px);
  const auto order = [](const HistoricEnd& end) {
    return std::tuple(end.column_px, end.u_fx16, end.v_fx16);
  };
  if (order(b) < order(a)) std::swap(a, b);
  return HistoricLine{profile, std::move(a), std::move(b)};
}

}  // namespace selvage::spec
