// Wrong mappers: which pixels are drawn.
#include <algorithm>
#include <cstdlib>
#include <optional>
#include <vector>

#include "coverage/catalogue.h"
#include "coverage/recipe.h"

namespace selvage::coverage {
namespace {

using spec::Rational;
using spec::ScanLine;

// The outline moved down, and kept in range.
[[nodiscard]] std::vector<selvage_vertex> lowered(std::vector<selvage_vertex> vertices,
                                                  int32_t dy_fx8) {
  for (selvage_vertex& v : vertices) {
    v.y = std::clamp(v.y + dy_fx8, int32_t{SELVAGE_X_MIN}, SELVAGE_X_END - 1);
  }
  return vertices;
}

// Edges of less than 1/16 px height get a level step to below their upper end, and go straight
// down.
void straighten_low_edges(std::vector<selvage_vertex>* vertices) {
  constexpr int32_t kLow_fx8 = SELVAGE_SUBPIXELS / 16;
  std::vector<selvage_vertex> straight;
  for (size_t i = 0; i < vertices->size(); ++i) {
    const selvage_vertex &a = (*vertices)[i], &b = (*vertices)[(i + 1) % vertices->size()];
    const bool is_low = a.y != b.y && std::abs(a.y - b.y) < kLow_fx8;
    straight.push_back(a);
    if (!is_low) continue;
    selvage_vertex corner = a.y < b.y ? b : a;  // the lower end, at the upper one's x
    corner.x = a.y < b.y ? a.x : b.x;
    straight.push_back(corner);
  }
  *vertices = straight;
}

// What another row's edges carry, at this row's positions.
void move_source(const ScanLine& from, ScanLine* to) {
  const ScanLine positions = *to;
  *to = from;
  to->left.x = positions.left.x;
  to->right.x = positions.right.x;
}

void spoil_fill_rule(Catalogue* catalogue) {
  catalogue->add("both_ends_in", "PART", "the right edge belongs to the polygon too",
                 [](Recipe& r) {
                   r.covers = [](const ScanLine& line, const Rational& x) {
                     return line.left.x <= x && x <= line.right.x;
                   };
                 });
  catalogue->add("both_ends_out", "PINWHEEL", "the left edge does not belong to the polygon",
                 [](Recipe& r) {
                   r.covers = [](const ScanLine& line, const Rational& x) {
                     return line.left.x < x && x < line.right.x;
                   };
                 });
  catalogue->add("right_edges_own", "COV", "right edges own their pixels instead of left ones",
                 [](Recipe& r) {
                   r.covers = [](const ScanLine& line, const Rational& x) {
                     return line.left.x < x && x <= line.right.x;
                   };
                 });
  catalogue->add("bottom_edges_own", "COV", "bottom edges own their pixels instead of top ones",
                 [](Recipe& r) {
                   r.cross = [](const Job& job, int32_t y) {
                     return spec::scan_line(lowered(job.vertices, 1), y);
                   };
                 });
  catalogue->add("error_term_off_by_one", "COV",
                 "an edge that misses a centre by a hair touches it", [](Recipe& r) {
                   r.covers = [](const ScanLine& line, const Rational& x) {
                     const Rational hair(1, 1 << 20);
                     return line.left.x - hair <= x && x < line.right.x - hair;
                   };
                 });
  catalogue->add("edges_in_float", "COV", "edge positions are rounded to float", [](Recipe& r) {
    r.covers = [](const ScanLine& line, const Rational& x) {
      const auto rounded = [](const Rational& edge) { return static_cast<float>(edge.get_d()); };
      const auto centre = static_cast<float>(x.get_d());
      return rounded(line.left.x) <= centre && centre < rounded(line.right.x);
    };
  });
}

void spoil_outline(Catalogue* catalogue) {
  catalogue->add("large_area_overflows", "COV", "a doubled area beyond 32 bits counts as none",
                 [](Recipe& r) {
                   r.prepare = [](Job& job) {
                     const auto [l, h] = std::ranges::minmax(job.vertices, {}, &selvage_vertex::x);
                     const auto [t, b] = std::ranges::minmax(job.vertices, {}, &selvage_vertex::y);
                     if (int64_t{h.x - l.x} * (b.y - t.y) >= int64_t{1} << 31) job.vertices.clear();
                   };
                 });
  catalogue->add("y_snapped_x_not", "COV", "y is rounded to whole pixels and x is not",
                 [](Recipe& r) {
                   r.prepare = [](Job& job) {
                     for (selvage_vertex& v : job.vertices) v.y = (v.y + 128) & ~255;
                   };
                 });
  catalogue->add("low_edges_start_at_their_top", "COV",
                 "an edge of less than 1/16 px height has one x, its upper end's", [](Recipe& r) {
                   r.prepare = [](Job& job) { straighten_low_edges(&job.vertices); };
                 });
  catalogue->add("draws_nothing", "IDENTITY", "the picture stays empty", [](Recipe& r) {
    r.covers = [](const ScanLine&, const Rational&) { return false; };
  });
  catalogue->add("loses_vertical_edges", "MIRROR",
                 "the first column after a vertical left edge is lost, as after a quarter turn",
                 [](Recipe& r) {
                   r.covers = [](const ScanLine& line, const Rational& x) {
                     const bool on_grid = line.left.x.get_den() == 1;
                     return line.left.x + (on_grid ? 1 : 0) <= x && x < line.right.x;
                   };
                 });
}

void spoil_rows(Catalogue* catalogue) {
  catalogue->add("left_edge_with_right_slope", "COV",
                 "the left edge is stepped with the right edge's slope", [](Recipe& r) {
                   r.cross = [](const Job& job, int32_t y) {
                     std::optional<ScanLine> line = spec::scan_line(job.vertices, y);
                     const std::optional<ScanLine> above = spec::scan_line(job.vertices, y - 1);
                     if (line && above) {
                       const Rational step = line->right.x - above->right.x;
                       line->left.x = std::min(line->right.x, Rational(above->left.x + step));
                     }
                     return line;
                   };
                 });
  catalogue->add(
      "width_and_height_swapped", "COV", "the target's sides are exchanged", [](Recipe& r) {
        r.in_clip = [](const Job& job, int32_t x, int32_t y) {
          return x < job.target.height && y < job.target.width && Recipe().in_clip(job, x, y);
        };
      });
}

void spoil_clip_source(Catalogue* catalogue) {
  catalogue->add("left_clip_keeps_source", "CLIP", "clipping on the left does not advance u and v",
                 [](Recipe& r) {
                   r.map = [](const Job& job, const ScanLine& line, const Rational& x) {
                     const Rational hidden =
                         std::max(Rational(0), Rational(job.clip.left - line.left.x));
                     return Recipe::interpolate(line, x - hidden);
                   };
                 });
  catalogue->add("top_clip_keeps_source", "CLIP", "clipping at the top does not advance u and v",
                 [](Recipe& r) {
                   r.cross = [](const Job& job, int32_t y) {
                     std::optional<ScanLine> line = spec::scan_line(job.vertices, y);
                     const auto highest = std::ranges::min(job.vertices, {}, &selvage_vertex::y);
                     const int32_t hidden = job.clip.top - ((highest.y + 127) >> 8);
                     if (!line || hidden <= 0) return line;
                     const auto source = spec::scan_line(job.vertices, y - hidden);
                     if (source) move_source(*source, &*line);
                     return line;
                   };
                 });
  catalogue->add("clamps_vertices", "CLIP",
                 "vertices beyond the clip are moved onto it and keep their texture coordinates",
                 [](Recipe& r) {
                   r.prepare = [](Job& job) {
                     const int32_t left = std::clamp(job.clip.left, -32768, 32767) * 256;
                     for (selvage_vertex& v : job.vertices) v.x = std::max(v.x, left);
                   };
                 });
}

void spoil_clip_rectangle(Catalogue* catalogue) {
  catalogue->add("scissor_mirrored", "CLIP", "the clip rectangle counts rows from the bottom",
                 [](Recipe& r) {
                   r.in_clip = [](const Job& job, int32_t x, int32_t y) {
                     const int32_t row = job.target.height - 1 - y;
                     return job.clip.left <= x && x < job.clip.right && job.clip.top <= row &&
                            row < job.clip.bottom;
                   };
                 });
  catalogue->add("clip_inclusive", "MEM", "the clip's right column is drawn too", [](Recipe& r) {
    r.in_clip = [](const Job& job, int32_t x, int32_t y) {
      return job.clip.left <= x && x <= job.clip.right && job.clip.top <= y && y < job.clip.bottom;
    };
  });
  catalogue->add("writes_past_the_row", "MEM", "a byte after the target's last pixel is written",
                 [](Recipe& r) {
                   r.finish = [](const Job& job) {
                     const ptrdiff_t bytes = job.target.format == SELVAGE_INDEX8   ? 1
                                             : job.target.format == SELVAGE_RGB565 ? 2
                                                                                   : 4;
                     const int32_t last = job.target.pitch > 0 ? job.target.height - 1 : 0;
                     char* row = static_cast<char*>(job.target.pixels) + last * job.target.pitch;
                     row[job.target.width * bytes] = 0;
                   };
                 });
}

}  // namespace

void add_wrong_coverage(Catalogue* catalogue) {
  spoil_fill_rule(catalogue);
  spoil_outline(catalogue);
  spoil_rows(catalogue);
  spoil_clip_source(catalogue);
  spoil_clip_rectangle(catalogue);
}

}  // namespace selvage::coverage
