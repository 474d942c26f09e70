#include "coverage/wrong_mappers.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "coverage/recipe.h"

namespace selvage::coverage {
namespace {

using spec::Rational;
using spec::Sample;
using spec::ScanLine;

class Catalogue {
 public:
  // `spoil` changes one step of the right recipe.
  template <class Spoil>
  void add(std::string_view name, std::string_view killer, std::string_view bug, Spoil spoil) {
    Recipe recipe;
    spoil(recipe);
    mappers_.push_back({name, bug, killer, subject_of(std::string(name), std::move(recipe))});
  }
  [[nodiscard]] std::vector<WrongMapper> take() { return std::move(mappers_); }

 private:
  std::vector<WrongMapper> mappers_;
};

[[nodiscard]] Rational half() { return {1, 2}; }

// (x, u q, v q, q) of an outline crossed at a height other than the row's centre.
[[nodiscard]] std::vector<selvage_vertex> lowered(std::vector<selvage_vertex> vertices,
                                                  int32_t dy_fx8) {
  for (selvage_vertex& v : vertices) v.y = std::clamp(v.y + dy_fx8, -8388608, 8388607);
  return vertices;
}

void spoil_coverage(Catalogue* catalogue) {
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

void spoil_clipping(Catalogue* catalogue) {
  catalogue->add("left_clip_keeps_source", "CLIP", "clipping on the left does not advance u and v",
                 [](Recipe& r) {
                   r.map = [](const Job& job, const ScanLine& line, const Rational& x) {
                     const Rational hidden =
                         std::max(Rational(0), Rational(job.clip.left - line.left.x));
                     return Recipe::interpolate(line, x - hidden);
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

void spoil_mapping(Catalogue* catalogue) {
  catalogue->add("no_prestep_x", "VERT", "u and v are taken at the pixel's left side",
                 [](Recipe& r) {
                   r.map = [](const Job&, const ScanLine& line, const Rational& x) {
                     return Recipe::interpolate(line, std::max(line.left.x, Rational(x - half())));
                   };
                 });
  catalogue->add("half_a_pixel_off", "IDENTITY", "u and v are taken half a pixel to the right",
                 [](Recipe& r) {
                   r.map = [](const Job&, const ScanLine& line, const Rational& x) {
                     return Recipe::interpolate(line, x + half());
                   };
                 });
  catalogue->add("reads_past_the_edge", "GAMUT", "u and v are extrapolated by a whole pixel",
                 [](Recipe& r) {
                   r.map = [](const Job&, const ScanLine& line, const Rational& x) {
                     return Recipe::interpolate(line, x + 1);
                   };
                 });
  catalogue->add("drifts", "MAP", "u gathers 1/256 texel a pixel along a span", [](Recipe& r) {
    r.map = [](const Job&, const ScanLine& line, const Rational& x) {
      Sample point = Recipe::interpolate(line, x);
      point.u += (x - line.left.x) / 256;
      return point;
    };
  });
  catalogue->add("gradient_of_eight_bits", "SPLIT", "the gradient along a span keeps 4 bits",
                 [](Recipe& r) {
                   r.map = [](const Job&, const ScanLine& line, const Rational& x) {
                     const Sample from = Recipe::interpolate(line, line.left.x);
                     const Sample to = Recipe::interpolate(line, line.left.x + 1);
                     const auto walk = [&](const Rational& a, const Rational& b) {
                       const Rational step = Rational(spec::floor((b - a) * 16)) / 16;
                       return Rational(a + step * (x - line.left.x));
                     };
                     return Sample{walk(from.u, to.u), walk(from.v, to.v)};
                   };
                 });
  catalogue->add("depends_on_the_column", "SHIFT", "every fourth column is shifted by half a texel",
                 [](Recipe& r) {
                   r.map = [](const Job&, const ScanLine& line, const Rational& x) {
                     Sample point = Recipe::interpolate(line, x);
                     if (spec::floor(x) % 4 == 0) point.u += half();
                     return point;
                   };
                 });
  catalogue->add("first_vertex_wins", "ORDER",
                 "u is offset by the first vertex's fraction of a texel", [](Recipe& r) {
                   r.map = [](const Job& job, const ScanLine& line, const Rational& x) {
                     Sample point = Recipe::interpolate(line, x);
                     point.u += Rational(job.vertices[0].u & 65535) / 65536;
                     return point;
                   };
                 });
  catalogue->add("ignores_q", "MAP", "perspective is left out", [](Recipe& r) {
    r.prepare = [](Job& job) {
      for (selvage_vertex& v : job.vertices) v.q = 1;
    };
  });
  catalogue->add("divides_at_span_ends", "AFFINE", "perspective is divided at span ends only",
                 [](Recipe& r) {
                   r.map = [](const Job&, const ScanLine& line, const Rational& x) {
                     ScanLine flat = line;
                     for (spec::Crossing* end : {&flat.left, &flat.right}) {
                       end->uq /= end->q;
                       end->vq /= end->q;
                       end->q = 1;
                     }
                     return Recipe::interpolate(flat, x);
                   };
                 });
  catalogue->add("q_of_sixteen_bits", "MAP", "q keeps its low 16 bits", [](Recipe& r) {
    r.prepare = [](Job& job) {
      for (selvage_vertex& v : job.vertices) v.q = std::max(v.q & 65535, 1);
    };
  });
}

void spoil_texels(Catalogue* catalogue) {
  catalogue->add(
      "rounds_texels", "MAP", "texels are rounded where flooring is meant",
      [](Recipe& r) { r.round = [](const Rational& u) { return spec::floor(u + half()); }; });
  catalogue->add("truncates_texels", "MAP", "texels are truncated toward zero", [](Recipe& r) {
    r.round = [](const Rational& u) { return sgn(u) < 0 ? -spec::floor(-u) : spec::floor(u); };
  });
  catalogue->add("wraps_by_truncation", "SHIFT", "a negative texel wraps by the remainder's sign",
                 [](Recipe& r) {
                   r.address = [](int32_t texel, int32_t size, selvage_address mode) {
                     return mode == SELVAGE_ADDRESS_WRAP ? std::abs(texel % size)
                                                         : spec::address_texel(texel, size, mode);
                   };
                 });
  catalogue->add("clamps_to_size", "GAMUT", "clamping stops one texel past the edge",
                 [](Recipe& r) {
                   r.address = [](int32_t texel, int32_t size, selvage_address mode) {
                     return mode == SELVAGE_ADDRESS_CLAMP ? std::clamp(texel, 0, size)
                                                          : spec::address_texel(texel, size, mode);
                   };
                 });
  catalogue->add("swaps_u_and_v", "ORACLE", "u and v are exchanged", [](Recipe& r) {
    r.map = [](const Job&, const ScanLine& line, const Rational& x) {
      const Sample point = Recipe::interpolate(line, x);
      return Sample{point.v, point.u};
    };
  });
}

void spoil_errors(Catalogue* catalogue) {
  catalogue->add("hides_errors", "TOTAL", "errors are reported as success",
                 [](Recipe& r) { r.status = [](selvage_status) { return SELVAGE_OK; }; });
  catalogue->add("blames_the_wrong_thing", "TOTAL", "every error is the same one", [](Recipe& r) {
    r.status = [](selvage_status status) {
      return status == SELVAGE_OK ? SELVAGE_OK : SELVAGE_ERROR_TARGET_NULL;
    };
  });
}

}  // namespace

std::span<const WrongMapper> wrong_mappers() {
  static const std::vector<WrongMapper> mappers = [] {
    Catalogue catalogue;
    spoil_coverage(&catalogue);
    spoil_clipping(&catalogue);
    spoil_mapping(&catalogue);
    spoil_texels(&catalogue);
    spoil_errors(&catalogue);
    return catalogue.take();
  }();
  return mappers;
}

spec::Subject right_mapper() { return subject_of("the recipe with nothing wrong", Recipe{}); }

}  // namespace selvage::coverage
