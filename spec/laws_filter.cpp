// Law FILTER: what a pixel is made of.
#include <algorithm>
#include <cstdint>
#include <utility>

#include "spec/allowed_pixel.h"
#include "spec/filter_texture.h"
#include "spec/law_list.h"
#include "spec/law_tools.h"
#include "spec/wide_rows.h"

namespace selvage::spec {
namespace {

// Cases that are drawn over a wide row, too, which takes longer than most of them.
inline constexpr int32_t kWideOneIn = 3;

[[nodiscard]] Violation filter_violation(std::string what, const Case& shown, Pixel at,
                                         std::string allowed, uint32_t drawn) {
  Violation violation =
      violation_at("FILTER", std::move(what), shown, at.x_px, at.y_px, std::move(allowed), drawn);
  violation.drawn = describe_colour(drawn);  // with nearest, too: these texels are colours
  violation.off_by.reset();
  return violation;
}

[[nodiscard]] Judgement judge_constant(const Subject& subject, const Case& c, Choices& choices) {
  const auto byte = [&] { return static_cast<uint32_t>(choices.pick(0, 256)); };
  uint32_t colour = 0;
  for (int i = 0; i < 4; ++i) colour |= in_channel(byte(), i);
  const Picture picture = draw(subject, c, [=](Texel) { return colour; });
  Judgement judgement;
  for (int32_t y = 0; y < c.target_height_px; ++y) {
    for (int32_t x = 0; x < c.target_width_px; ++x) {
      const MaybePixel& pixel = picture.at(x, y);
      if (!pixel) continue;
      ++judgement.judged_px;
      if (*pixel == colour) continue;
      judgement.violation = filter_violation("a texture of one colour draws that colour", c, {x, y},
                                             describe_colour(colour), *pixel);
      return judgement;
    }
  }
  return judgement;
}

// Each channel lies between the least and the greatest of the texels that it is made of.
[[nodiscard]] bool is_between_inputs(uint32_t pixel, const Weights& weights,
                                     const TexelAt& texel_at) {
  for (int i = 0; i < 4; ++i) {
    uint32_t least = 255, greatest = 0;
    for (const Tap& row : weights.rows) {
      for (const Tap& column : weights.columns) {
        const uint32_t value = channel(texel_at({column.texel, row.texel}), i);
        least = std::min(least, value);
        greatest = std::max(greatest, value);
      }
    }
    if (channel(pixel, i) < least || channel(pixel, i) > greatest) return false;
  }
  return true;
}

// Judges the drawn pixels that the polygon covers, by fault_of(at, exact, drawn).
template <class FaultOf>
[[nodiscard]] Judgement judge_covered(const Subject& subject, const Case& c,
                                      const TexelAt& texel_at, const FaultOf& fault_of) {
  const Picture picture = draw(subject, c, texel_at);
  Judgement judgement;
  for (int32_t y = 0; y < c.target_height_px; ++y) {
    const ModelRow row(c, y);
    for (int32_t x = 0; x < c.target_width_px; ++x) {
      const MaybePixel& pixel = picture.at(x, y);
      const std::optional<Sample> point = pixel ? row.coordinates(x) : std::nullopt;
      if (!point) continue;
      ++judgement.judged_px;
      judgement.violation = fault_of(Pixel{x, y}, *point, *pixel);
      if (judgement.violation) return judgement;
    }
  }
  return judgement;
}

[[nodiscard]] Judgement judge_formula(const Subject& subject, const Case& c) {
  const TexelAt texel_at = filter_texture(c);
  return judge_covered(
      subject, c, texel_at,
      [&](Pixel at, const Sample& exact, uint32_t drawn) -> std::optional<Violation> {
        const Weights weights = filter_weights(c, at.x_px, at.y_px, exact);
        const uint32_t mean = weighted_mean(weights.columns, weights.rows, texel_at);
        if (drawn == mean) return std::nullopt;
        return filter_violation(
            is_between_inputs(drawn, weights, texel_at)
                ? "a pixel is the weighted mean that its filter's formula gives"
                : "a pixel lies between the least and the greatest of the texels it is made of",
            c, at, describe_colour(mean), drawn);
      });
}

// Of a subject that claims an accuracy: what the formula gives for some (u, v) within it.
[[nodiscard]] Judgement judge_formula_within(const Subject& subject, const Case& c) {
  const TexelAt texel_at = filter_texture(c);
  const Rational accuracy = accuracy_of(subject);
  return judge_covered(
      subject, c, texel_at,
      [&](Pixel at, const Sample& exact, uint32_t drawn) -> std::optional<Violation> {
        const AllowedPixel allowed(c, at, exact, texel_at, accuracy);
        if (allowed.holds(drawn)) return std::nullopt;
        return filter_violation(
            "a pixel is what its filter's formula gives within the claimed "
            "accuracy, " +
                accuracy.get_str() + " texel, of its exact (u, v)",
            c, at, allowed.text(), drawn);
      });
}

[[nodiscard]] Judgement judge_formula_of(const Subject& subject, const Case& c) {
  if (shows_exact_texels(subject.claims)) return judge_formula(subject, c);
  if (subject.claims.accuracy_fx16 < SELVAGE_SUBTEXELS) return judge_formula_within(subject, c);
  return {};
}

// A row of several vectors of pixels, half of them over a border of the texture: between two of its
// copies, where it wraps.
[[nodiscard]] Case wide_row(const Case& c, Choices& choices) {
  Case wide = made_wide(c, choices);
  wide.target_height_px = 1;
  if (choices.pick(0, 2) == 0) return wide;
  const auto about_border = [&](int32_t selvage_vertex::*axis, int32_t size_texel) {
    const int64_t border = int64_t{size_texel} * choices.pick(0, 4);
    const int64_t reach = choices.pick(1, 4);
    const auto fx16 = [](int64_t texel) {
      return std::clamp<int64_t>(texel * SELVAGE_SUBTEXELS, INT32_MIN, INT32_MAX);
    };
    fit(&wide.vertices, axis, fx16(border - reach), fx16(border + reach));
  };
  about_border(&selvage_vertex::u, c.texture_width_texel);
  about_border(&selvage_vertex::v, c.texture_height_texel);
  return wide;
}

}  // namespace

Judgement check_filter(const Subject& subject, const Case& c) {
  if (!is_valid(c) || !can_be_filtered(c)) return {};
  Choices choices(c.choice);
  Judgement judgement = judge_constant(subject, c, choices);
  if (judgement.violation) return judgement;
  if (add(&judgement, judge_formula_of(subject, c))) return judgement;
  // The area filter's boxes may be many texels there, and the model slow.
  const bool mixes_few = c.filter == SELVAGE_FILTER_FOUR || c.filter == SELVAGE_FILTER_BILINEAR;
  if (!mixes_few || choices.pick(0, kWideOneIn) != 0) return judgement;
  const Case wide = within(subject.claims, wide_row(c, choices));
  if (is_valid(wide)) add(&judgement, judge_formula_of(subject, wide));
  return judgement;
}

}  // namespace selvage::spec
