#include "cli/counterexample_picture.h"

#include <cstdint>

#include "cli/comparison_picture.h"
#include "spec/fan.h"
#include "spec/filter_texture.h"
#include "spec/geometry.h"
#include "spec/profiles.h"
#include "spec/refusal.h"

namespace selvage::cli {
namespace {

// The function, with `failed` for the answer of a call that fails.
template <class Function, class Answer>
[[nodiscard]] auto calmed(Function function, Answer failed) {
  return [function, failed](auto... arguments) -> Answer {
    try {
      return function(arguments...);
    } catch (const spec::SubjectFailure&) {
      return failed;
    }
  };
}

// A drawing that fails has drawn what it had until then; from a texture that could not be prepared
// nothing is drawn.
[[nodiscard]] spec::Subject unfailing(const spec::Subject& subject) {
  spec::Subject calm = subject;
  calm.draw = calmed(subject.draw, selvage_status{SELVAGE_OK});
  if (calm.prepare) {
    const selvage_status failed = SELVAGE_ERROR_TEXTURE_PREPARED;
    calm.prepare->prepare = calmed(subject.prepare->prepare, failed);
    calm.prepare->bytes = calmed(subject.prepare->bytes, SIZE_MAX);
  }
  return calm;
}

// The colour of a pixel that so many more tiles draw clockwise than the other way round. Its fourth
// byte, which is not shown, tells one count from another.
[[nodiscard]] std::optional<uint32_t> colour_of(int count) {
  constexpr uint32_t once = 0xE0963C, twice = 0x3CC8F0, otherwise = 0xFFFFFF;  // blue, green, red
  if (count == 0) return std::nullopt;
  const uint32_t colour = count == 1 ? once : count == 2 ? twice : otherwise;
  return colour | static_cast<uint32_t>(count) << 24;
}

struct FanPictures {
  spec::Picture drawn, expected;
};

[[nodiscard]] FanPictures fan_pictures(const spec::Subject& subject, const spec::Case& region,
                                       const selvage_vertex& centre,
                                       const spec::Drawings* drawings) {
  const spec::TexelAt texture = spec::coordinate_texture();
  const spec::Subject calm = unfailing(subject);
  const spec::Fan fan = spec::draw_fan(region, centre, subject.claims, [&](const spec::Case& tile) {
    const spec::Picture* noted = drawings != nullptr ? drawings->find(tile, texture) : nullptr;
    return noted != nullptr ? *noted : spec::draw_whatever_answered(calm, tile);
  });
  FanPictures pictures;
  for (spec::Picture* picture : {&pictures.drawn, &pictures.expected}) {
    picture->width_px = region.target_width_px;
    picture->height_px = region.target_height_px;
  }
  for (const spec::Times& times : fan.times)
    pictures.drawn.pixels.push_back(colour_of(times.sum()));
  for (int32_t y = 0; y < region.target_height_px; ++y) {
    for (int32_t x = 0; x < region.target_width_px; ++x) {
      const spec::Point sample = spec::sample_point(spec::profile_of(region), x, y);
      pictures.expected.pixels.push_back(colour_of(spec::winding_number(sample, region.vertices)));
    }
  }
  return pictures;
}

[[nodiscard]] Colour in_red(const std::optional<uint32_t>&, const std::optional<uint32_t>&) {
  return {255, 0, 0};
}

}  // namespace

PictureComparison counterexample(const spec::Subject& judged, const spec::Violation& violation,
                                 const spec::Drawings* drawings) {
  const spec::Case& shown = violation.shown;
  if (violation.comparison) {
    const bool is_mixed = shown.filter != SELVAGE_FILTER_NEAREST;
    return {.scene = shown,
            .colours = is_mixed || !violation.comparison->shows_texels,
            .drawn = violation.comparison->drawn,
            .expected = violation.comparison->wanted,
            .x_px = violation.x_px,
            .y_px = violation.y_px,
            .difference = in_red};
  }
  if (const auto centre = spec::fan_centre(violation.law, shown, violation.x_px, violation.y_px)) {
    FanPictures fan = fan_pictures(judged, shown, *centre, drawings);
    return {.scene = shown,
            .colours = true,
            .drawn = std::move(fan.drawn),
            .expected = std::move(fan.expected),
            .x_px = violation.x_px,
            .y_px = violation.y_px,
            .difference = in_red};
  }
  // A mixed pixel tells no texel: these are shown with a texture of colours, that of law FILTER.
  const bool colours = shown.filter != SELVAGE_FILTER_NEAREST || violation.law == "FILTER";
  spec::TexelAt texture = colours ? spec::filter_texture(shown) : spec::coordinate_texture();
  const spec::Picture* noted = drawings != nullptr ? drawings->find(shown, texture) : nullptr;
  if (noted == nullptr && drawings != nullptr && colours) {
    // A law that does not judge colours was broken by a call that did not end as calls do.
    const spec::TexelAt places = spec::coordinate_texture();
    noted = drawings->find(shown, places);
    if (noted != nullptr) texture = places;
  }
  const auto drawn_anew = [&] {
    const spec::Subject calm = unfailing(judged);
    return colours ? spec::draw_whatever_answered(calm, shown, texture)
                   : spec::draw_whatever_answered(calm, shown);
  };
  return {.scene = shown,
          .colours = colours,
          .drawn = noted != nullptr ? *noted : drawn_anew(),
          .expected = spec::expected(shown, texture),
          .x_px = violation.x_px,
          .y_px = violation.y_px,
          .difference = in_red};
}

Raster counterexample_picture(const spec::Subject& judged, const spec::Violation& violation,
                              const spec::Drawings* drawings) {
  return comparison_picture(counterexample(judged, violation, drawings));
}

}  // namespace selvage::cli
