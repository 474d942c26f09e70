#include "cli/counterexample_picture.h"

#include <cstdint>

#include "cli/comparison_picture.h"
#include "spec/filter_texture.h"
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

}  // namespace

Raster counterexample_picture(const spec::Subject& judged, const spec::Violation& violation,
                              const spec::Drawings* drawings) {
  const spec::Case& shown = violation.shown;
  // A mixed pixel tells no texel: these are shown with a texture of colours, that of law FILTER.
  const bool colours = shown.filter != SELVAGE_FILTER_NEAREST || violation.law == "FILTER";
  spec::TexelAt texture =
      colours ? spec::filter_texture(shown) : spec::coordinate_texture(shown.format);
  const spec::Picture* noted = drawings != nullptr ? drawings->find(shown, texture) : nullptr;
  if (noted == nullptr && drawings != nullptr && colours) {
    // A law that does not judge colours was broken by a call that did not end as calls do.
    const spec::TexelAt places = spec::coordinate_texture(shown.format);
    noted = drawings->find(shown, places);
    if (noted != nullptr) texture = places;
  }
  return comparison_picture(
      {.scene = shown,
       .colours = colours,
       .drawn = noted != nullptr ? *noted
                                 : spec::draw_whatever_answered(unfailing(judged), shown, texture),
       .expected = spec::expected(shown, texture),
       .x_px = violation.x_px,
       .y_px = violation.y_px,
       .difference = [](const auto&, const auto&) {
         return Colour{255, 0, 0};
       }});
}

}  // namespace selvage::cli
