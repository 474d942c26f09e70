// Wrong mappers: which texels they mix, how much of each, and how they round.
#include <algorithm>
#include <cstdlib>

#include "coverage/catalogue.h"
#include "coverage/recipe.h"

namespace selvage::coverage {
namespace {

using spec::BoxSides;
using spec::Gradient;
using spec::Rational;
using spec::Tap;
using spec::Taps;
using spec::TexelAt;

constexpr std::string_view kFilterLaw = "FILTER";

// Two neighbours where there is one: the other one with weight 0.
[[nodiscard]] Taps as_two(const Taps& taps) {
  return taps.size() == 1 ? Taps{taps[0], {taps[0].texel, 0}} : taps;
}

void spoil_taps(Catalogue* catalogue) {
  catalogue->add("filter_half_a_texel_off", kFilterLaw, "texel centres are put on whole u",
                 [](Recipe& r) {
                   r.taps = [](selvage_filter filter, const Rational& u, int32_t side) {
                     return spec::taps(filter, u + half(), side);
                   };
                 });
  catalogue->add("filter_weights_of_7_bits", kFilterLaw, "weights keep 7 bits", [](Recipe& r) {
    r.taps = [](selvage_filter filter, const Rational& u, int32_t side) {
      if (filter != SELVAGE_FILTER_BILINEAR) return spec::taps(filter, u, side);
      return spec::taps(filter, Rational(spec::floor(u * 128)) / 128, side);
    };
  });
  catalogue->add("filter_swaps_weights", kFilterLaw,
                 "columns get the rows' weights and the reverse", [](Recipe& r) {
                   r.mean = [](const Taps& columns, const Taps& rows, const TexelAt& texel_at) {
                     Taps c = as_two(columns), d = as_two(rows);
                     if (c.size() != 2 || d.size() != 2) {
                       return spec::weighted_mean(columns, rows, texel_at);
                     }
                     for (size_t i = 0; i < 2; ++i) std::swap(c[i].weight, d[i].weight);
                     return spec::weighted_mean(c, d, texel_at);
                   };
                 });
}

void spoil_tap_address(Catalogue* catalogue) {
  catalogue->add("filter_neighbour_by_increment", kFilterLaw,
                 "the neighbour is the texel after the addressed one, not addressed by itself",
                 [](Recipe& r) {
                   r.address_taps = [](const Taps& taps, int32_t size, selvage_address mode) {
                     Taps result = taps;
                     const int32_t first = spec::address_texel(taps[0].texel, size, mode);
                     for (Tap& tap : result) {
                       tap.texel = std::min(first + (tap.texel - taps[0].texel), size - 1);
                     }
                     return spec::addressed(result, size, mode);
                   };
                 });
  catalogue->add("filter_wraps_by_truncation", kFilterLaw,
                 "a negative texel wraps by the remainder's sign", [](Recipe& r) {
                   r.address_taps = [](const Taps& taps, int32_t size, selvage_address mode) {
                     Taps result = taps;
                     for (Tap& tap : result) {
                       if (mode == SELVAGE_ADDRESS_WRAP) tap.texel = std::abs(tap.texel % size);
                     }
                     return spec::addressed(result, size, mode);
                   };
                 });
}

// The mean of one channel by the sums of weights and of weighted values.
template <class Round>
void round_by(Recipe& r, Round round) {
  r.mean = [=](const Taps& columns, const Taps& rows, const TexelAt& texel_at) {
    uint32_t pixel = 0;
    for (int i = 0; i < 4; ++i) {
      int64_t sum = 0, total = 0;
      for (const Tap& row : rows) {
        for (const Tap& column : columns) {
          sum += column.weight * row.weight * spec::channel(texel_at({column.texel, row.texel}), i);
          total += column.weight * row.weight;
        }
      }
      pixel |= spec::in_channel(static_cast<uint32_t>(round(sum, total)), i);
    }
    return pixel;
  };
}

void spoil_mean(Catalogue* catalogue) {
  catalogue->add("filter_truncates", kFilterLaw, "means are rounded down", [](Recipe& r) {
    round_by(r, [](int64_t sum, int64_t total) { return sum / total; });
  });
  catalogue->add("filter_halves_down", kFilterLaw, "halves are rounded down", [](Recipe& r) {
    round_by(r, [](int64_t sum, int64_t total) { return (2 * sum + total - 1) / (2 * total); });
  });
  catalogue->add("filter_rounds_twice", kFilterLaw,
                 "each row's mean is rounded, then the mean of rows", [](Recipe& r) {
                   r.mean = [](const Taps& columns, const Taps& rows, const TexelAt& texel_at) {
                     return spec::weighted_mean({{0, 1}}, rows, [&](spec::Texel of) {
                       return spec::weighted_mean(columns, {{of.t, 1}}, texel_at);
                     });
                   };
                 });
  catalogue->add("filter_skips_alpha", kFilterLaw, "alpha is the first texel's", [](Recipe& r) {
    r.mean = [](const Taps& columns, const Taps& rows, const TexelAt& texel_at) {
      const uint32_t first = texel_at({columns[0].texel, rows[0].texel});
      const uint32_t alpha = spec::in_channel(255, 3);
      return (spec::weighted_mean(columns, rows, texel_at) & ~alpha) | (first & alpha);
    };
  });
}

void spoil_box(Catalogue* catalogue) {
  catalogue->add("box_of_one_size", kFilterLaw, "the box is a square of the longer side",
                 [](Recipe& r) {
                   r.sides = [](const Gradient& g) {
                     const BoxSides sides = spec::box_sides(g);
                     const int32_t longer = std::max(sides.u_fx8, sides.v_fx8);
                     return BoxSides{longer, longer};
                   };
                 });
  catalogue->add("box_of_the_row", kFilterLaw, "the box's sides are what changes along x alone",
                 [](Recipe& r) {
                   r.sides = [](const Gradient& g) {
                     return BoxSides{spec::box_side_fx8(abs(g.u_along_x)),
                                     spec::box_side_fx8(abs(g.v_along_x))};
                   };
                 });
  catalogue->add("box_rounded_down", kFilterLaw, "the box's sides are rounded down", [](Recipe& r) {
    r.sides = [](const Gradient& g) {
      const auto down = [](const Rational& scale) {
        const Rational whole = std::min(Rational(scale), Rational(65536)) * 256;
        return spec::box_side_fx8(Rational(spec::floor(whole)) / 256);
      };
      return BoxSides{down(abs(g.u_along_x) + abs(g.u_along_y)),
                      down(abs(g.v_along_x) + abs(g.v_along_y))};
    };
  });
  catalogue->add("box_of_a_texel_and_less", kFilterLaw, "the box shrinks below a texel",
                 [](Recipe& r) {
                   r.sides = [](const Gradient& g) {
                     BoxSides sides = spec::box_sides(g);
                     if (sides.u_fx8 == spec::kLeastBoxSide_fx8) sides.u_fx8 = 128;
                     return sides;
                   };
                 });
  catalogue->add("box_not_centred", kFilterLaw, "the box starts at the point", [](Recipe& r) {
    r.taps = [](selvage_filter filter, const Rational& u, int32_t side) {
      return spec::taps(filter, u + Rational((side - 256) / 2) / 256, side);
    };
  });
  catalogue->add("box_without_perspective", kFilterLaw, "the footprint is that of the affine map",
                 [](Recipe& r) {
                   r.gradient = [](const Job& job, int32_t x, int32_t y) {
                     std::vector<selvage_vertex> flat = job.vertices;
                     for (selvage_vertex& v : flat) v.q = 1;
                     return gradient_at(flat, x, y);
                   };
                 });
}

}  // namespace

void add_wrong_filters(Catalogue* catalogue) {
  spoil_taps(catalogue);
  spoil_tap_address(catalogue);
  spoil_mean(catalogue);
  spoil_box(catalogue);
}

}  // namespace selvage::coverage
