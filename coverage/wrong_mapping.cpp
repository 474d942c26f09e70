// Wrong mappers: which texel they show, and what the call returns.
#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <utility>
#include <vector>

#include "coverage/catalogue.h"
#include "coverage/recipe.h"

namespace selvage::coverage {
namespace {

using spec::Rational;
using spec::Sample;
using spec::ScanLine;

void spoil_prestep(Catalogue* catalogue) {
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
}

void spoil_gradient(Catalogue* catalogue) {
  catalogue->add("drifts", "MAP", "u gathers 1/256 texel a pixel along a span", [](Recipe& r) {
    r.map = [](const Job&, const ScanLine& line, const Rational& x) {
      Sample point = Recipe::interpolate(line, x);
      point.u += (x - line.left.x) / 256;
      return point;
    };
  });
  catalogue->add("gradient_of_four_bits", "SPLIT", "the gradient along a span keeps 4 bits",
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
  catalogue->add("reversed_uv_ignored", "MAP", "u that falls along a span is made to rise",
                 [](Recipe& r) {
                   r.map = [](const Job&, const ScanLine& line, const Rational& x) {
                     ScanLine rising = line;
                     if (rising.right.uq / rising.right.q < rising.left.uq / rising.left.q) {
                       std::swap(rising.left.uq, rising.right.uq);
                     }
                     return Recipe::interpolate(rising, x);
                   };
                 });
}

void spoil_origin(Catalogue* catalogue) {
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
}

void spoil_perspective(Catalogue* catalogue) {
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
  catalogue->add("w_is_linear", "MAP", "w is interpolated along a span instead of 1 / w",
                 [](Recipe& r) {
                   r.map = [](const Job&, const ScanLine& line, const Rational& x) {
                     ScanLine flat = line;
                     for (spec::Crossing* end : {&flat.left, &flat.right}) end->q = 1 / end->q;
                     const Rational t = (x - line.left.x) / (line.right.x - line.left.x);
                     const Rational w = flat.left.q + t * (flat.right.q - flat.left.q);
                     for (spec::Crossing* end : {&flat.left, &flat.right}) end->q = 1;
                     const Sample point = Recipe::interpolate(flat, x);
                     return Sample{point.u * w, point.v * w};
                   };
                 });
  catalogue->add("q_of_sixteen_bits", "MAP", "q keeps its low 16 bits", [](Recipe& r) {
    r.prepare = [](Job& job) {
      for (selvage_vertex& v : job.vertices) v.q = std::max(v.q & 65535, 1);
    };
  });
}

void spoil_rounding(Catalogue* catalogue) {
  catalogue->add(
      "rounds_texels", "MAP", "texels are rounded where flooring is meant",
      [](Recipe& r) { r.round = [](const Rational& u) { return spec::floor(u + half()); }; });
  catalogue->add("truncates_texels", "MAP", "texels are truncated toward zero", [](Recipe& r) {
    r.round = [](const Rational& u) { return sgn(u) < 0 ? -spec::floor(-u) : spec::floor(u); };
  });
  catalogue->add(
      "u_of_32_bits", "MAP", "u is rounded to 2^-32 texel before it is floored", [](Recipe& r) {
        r.round = [](const Rational& u) {
          const Rational unit(4294967296.0);
          mpz_class nearest;
          const Rational scaled = u * unit + half();
          mpz_fdiv_q(nearest.get_mpz_t(), scaled.get_num_mpz_t(), scaled.get_den_mpz_t());
          return spec::floor(Rational(nearest) / unit);
        };
      });
}

void spoil_address(Catalogue* catalogue) {
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

// Texels of a narrow format tell their whole place only digit by digit.
void spoil_narrow_formats(Catalogue* catalogue) {
  const auto with_place = [](selvage_format format, spec::Texel (*of)(spec::Texel)) {
    return [=](Recipe& r) {
      r.prepare = [=](Job& job) {
        if (job.texture.format != format) return;
        job.place = [of](const selvage_texture& texture, spec::Texel texel) {
          return place_of(texture, of(texel));
        };
      };
    };
  };
  catalogue->add("index8_column_of_four_bits", "MAP", "of INDEX8 the column keeps 4 bits",
                 with_place(SELVAGE_INDEX8, [](spec::Texel texel) {
                   return spec::Texel{texel.s & 15, texel.t};
                 }));
  catalogue->add("rgb565_row_of_eight_bits", "MAP", "of RGB565 the row keeps 8 bits",
                 with_place(SELVAGE_RGB565, [](spec::Texel texel) {
                   return spec::Texel{texel.s, texel.t & 255};
                 }));
}

// A copy of the texture that was drawn last.
class TextureCache {
 public:
  // The texture's copy: made anew only where its description is another than the last one's.
  [[nodiscard]] selvage_texture copy_of(const selvage_texture& texture,
                                        bool looks_at_first = false) {
    const ptrdiff_t bytes = bytes_per_texel(texture.format);
    const auto first_differs = [&] {
      return std::memcmp(texels_.data(), texture.texels, static_cast<size_t>(bytes)) != 0;
    };
    if (!is_same(texture) || (looks_at_first && first_differs())) {
      seen_ = texture;
      texels_.resize(static_cast<size_t>(bytes * texture.width * texture.height));
      for (int32_t t = 0; t < texture.height; ++t) {
        std::memcpy(texels_.data() + t * texture.width * bytes,
                    static_cast<const char*>(texture.texels) + t * texture.pitch,
                    static_cast<size_t>(texture.width * bytes));
      }
    }
    selvage_texture copy = texture;
    copy.texels = texels_.data();
    copy.pitch = texture.width * bytes;
    return copy;
  }

 private:
  [[nodiscard]] bool is_same(const selvage_texture& texture) const {
    return texture.texels == seen_.texels && texture.width == seen_.width &&
           texture.height == seen_.height && texture.pitch == seen_.pitch &&
           texture.format == seen_.format;
  }

  selvage_texture seen_{};
  std::vector<char> texels_;
};

// The vertices of the outline that was drawn last: those of the same places are taken for the same.
void take_last_if_alike(std::vector<selvage_vertex>* vertices) {
  thread_local std::vector<selvage_vertex> last;
  const auto is_there = [](const selvage_vertex& a, const selvage_vertex& b) {
    return a.x == b.x && a.y == b.y;
  };
  if (std::ranges::equal(*vertices, last, is_there)) {
    *vertices = last;
  } else {
    last = *vertices;
  }
}

void spoil_memory(Catalogue* catalogue) {
  catalogue->add("knows_textures_by_address", "SAME",
                 "a texture is not read again where the one before lay there and was as large",
                 [](Recipe& r) {
                   r.prepare = [](Job& job) {
                     thread_local TextureCache cache;  // mappers are tried by several threads
                     job.texture = cache.copy_of(job.texture);
                   };
                 });
  catalogue->add("knows_textures_by_first_texel", "SAME",
                 "the same, but where the first texel is another", [](Recipe& r) {
                   r.prepare = [](Job& job) {
                     thread_local TextureCache cache;
                     job.texture = cache.copy_of(job.texture, /*looks_at_first=*/true);
                   };
                 });
  catalogue->add("knows_outlines_by_place", "SHIFT",
                 "set-up is kept where x and y of all vertices are the last ones", [](Recipe& r) {
                   r.prepare = [](Job& job) { take_last_if_alike(&job.vertices); };
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

void add_wrong_mapping(Catalogue* catalogue) {
  spoil_prestep(catalogue);
  spoil_gradient(catalogue);
  spoil_origin(catalogue);
  spoil_perspective(catalogue);
  spoil_rounding(catalogue);
  spoil_address(catalogue);
  spoil_narrow_formats(catalogue);
  spoil_memory(catalogue);
  spoil_errors(catalogue);
}

}  // namespace selvage::coverage
