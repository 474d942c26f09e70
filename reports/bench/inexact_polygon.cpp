#include "reports/bench/inexact_polygon.h"

#include <algorithm>

#include "spec/vertex_units.h"

namespace selvage::reports {

namespace {

using spec::kPixel_fx8;
using spec::kTexel_fx16;

constexpr double kPerPixel = 1.0 / kPixel_fx8, kPerTexel = 1.0 / kTexel_fx16;
constexpr double kOne_fx32 = 4294967296.0;
constexpr int kTexelBits = 16;
static_assert(1 << kTexelBits == kTexel_fx16);

InexactEdge edge_between(const selvage_vertex& a, const selvage_vertex& b, int32_t height_px) {
  const selvage_vertex& top = a.y < b.y ? a : b;
  const selvage_vertex& bottom = a.y < b.y ? b : a;
  InexactEdge edge;
  edge.first_row_px = std::max(row_at_or_below(top.y), 0);
  edge.end_row_px = std::min(row_at_or_below(bottom.y), height_px);
  if (edge.first_row_px >= edge.end_row_px) return edge;
  const double slope = static_cast<double>(bottom.x - top.x) / (bottom.y - top.y);
  const double below_px = edge.first_row_px + 0.5 - top.y * kPerPixel;
  edge.x_fx32 = static_cast<int64_t>((top.x * kPerPixel - 0.5 + slope * below_px) * kOne_fx32);
  edge.step_fx32 = static_cast<int64_t>(slope * kOne_fx32);
  return edge;
}

void add_edges(InexactPolygon& to, std::span<const selvage_vertex> polygon, int32_t height_px) {
  for (size_t i = 0; i < polygon.size(); ++i) {
    const selvage_vertex& next = polygon[i + 1 == polygon.size() ? 0 : i + 1];
    const InexactEdge edge = edge_between(polygon[i], next, height_px);
    if (edge.first_row_px >= edge.end_row_px) continue;
    size_t at = to.edge_count++;
    for (; at > 0 && to.edges[at - 1].first_row_px > edge.first_row_px; --at)
      to.edges[at] = to.edges[at - 1];
    to.edges[at] = edge;
  }
}

TexelRange texels_of(std::span<const selvage_vertex> polygon, int32_t selvage_vertex::*of) {
  constexpr int64_t kRounding_fx16 = 64;
  int32_t least = polygon[0].*of, most = least;
  for (const selvage_vertex& vertex : polygon) {
    least = std::min(least, vertex.*of);
    most = std::max(most, vertex.*of);
  }
  const auto texel = [](int64_t at_fx16) { return static_cast<int32_t>(at_fx16 >> kTexelBits); };
  return {texel(least - kRounding_fx16), texel(most + kRounding_fx16)};
}

// Planes over pixels through three vertices.
class Frame {
 public:
  Frame(const selvage_vertex& a, const selvage_vertex& b, const selvage_vertex& c)
      : x1_(b.x - a.x),
        y1_(b.y - a.y),
        x2_(c.x - a.x),
        y2_(c.y - a.y),
        reciprocal_(kPixel_fx8 / (x1_ * y2_ - x2_ * y1_)),
        x_px_(0.5 - a.x * kPerPixel),
        y_px_(0.5 - a.y * kPerPixel) {}

  [[nodiscard]] Plane through(double a, double b, double c) const {
    const double dx = ((b - a) * y2_ - (c - a) * y1_) * reciprocal_;
    const double dy = ((c - a) * x1_ - (b - a) * x2_) * reciprocal_;
    return {dx, dy, a + dx * x_px_ + dy * y_px_};
  }

 private:
  double x1_, y1_, x2_, y2_, reciprocal_, x_px_, y_px_;
};

}  // namespace

InexactPolygon inexact_polygon(std::span<const selvage_vertex> polygon, int32_t height_px) {
  InexactPolygon made;
  add_edges(made, polygon, height_px);
  made.columns = texels_of(polygon, &selvage_vertex::u);
  made.rows = texels_of(polygon, &selvage_vertex::v);
  const selvage_vertex &a = polygon[0], &b = polygon[1], &c = polygon.back();
  const Frame frame(a, b, c);
  made.affine = a.q == b.q && a.q == c.q;
  if (made.affine) {
    made.u = frame.through(a.u, b.u, c.u);
    made.v = frame.through(a.v, b.v, c.v);
    return made;
  }
  const double per_q = 1.0 / a.q, q_b = b.q * per_q, q_c = c.q * per_q;
  made.u = frame.through(a.u * kPerTexel, b.u * kPerTexel * q_b, c.u * kPerTexel * q_c);
  made.v = frame.through(a.v * kPerTexel, b.v * kPerTexel * q_b, c.v * kPerTexel * q_c);
  made.q = frame.through(1, q_b, q_c);
  return made;
}

}  // namespace selvage::reports
