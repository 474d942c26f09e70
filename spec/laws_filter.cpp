// Law FILTER: what a pixel is made of.
#include <algorithm>
#include <utility>

#include "spec/allowed_pixel.h"
#include "spec/filter_texture.h"
#include "spec/law_list.h"
#include "spec/law_tools.h"

namespace selvage::spec {
namespace {

[[nodiscard]] Violation filter_violation(std::string what, const Case& shown, Pixel at,
                                         std::string allowed, uint32_t drawn) {
  Violation violation =
      violation_at("FILTER", std::move(what), shown, at.x_px, at.y_px, std::move(allowed), drawn);
  violation.drawn = describe_colour(drawn);  // with nearest, too: these texels are colours
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

}  // namespace

Judgement check_filter(const Subject& subject, const Case& c) {
  if (!is_valid(c) || !can_be_filtered(c)) return {};
  Choices choices(c.choice);
  Judgement judgement = judge_constant(subject, c, choices);
  if (judgement.violation) return judgement;
  if (shows_exact_texels(subject.claims)) {
    add(&judgement, judge_formula(subject, c));
  } else if (subject.claims.accuracy_fx16 < SELVAGE_SUBTEXELS) {
    add(&judgement, judge_formula_within(subject, c));
  }
  return judgement;
}

}  // namespace selvage::spec
