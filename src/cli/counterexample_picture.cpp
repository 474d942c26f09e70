#include "cli/counterexample_picture.h"

#include "cli/comparison_picture.h"
#include "spec/filter_texture.h"

namespace selvage::cli {
namespace {

// A call that fails has drawn what it had until then.
[[nodiscard]] spec::Subject unfailing(const spec::Subject& subject) {
  spec::Subject calm = subject;
  calm.draw = [draw = subject.draw](auto... arguments) -> selvage_status {
    try {
      return draw(arguments...);
    } catch (const spec::SubjectFailure&) {
      return SELVAGE_OK;
    }
  };
  return calm;
}

}  // namespace

Raster counterexample_picture(const spec::Subject& judged, const spec::Violation& violation) {
  const spec::Subject subject = unfailing(judged);
  const spec::Case& shown = violation.shown;
  // A mixed pixel tells no texel: these are shown with a texture of colours, that of law FILTER.
  const bool colours = shown.filter != SELVAGE_FILTER_NEAREST || violation.law == "FILTER";
  const spec::TexelAt texture = colours ? spec::filter_texture(shown) : spec::TexelAt();
  return comparison_picture(
      {.scene = shown,
       .colours = colours,
       .drawn = colours ? spec::draw(subject, shown, texture) : spec::draw(subject, shown),
       .expected = colours ? spec::expected(shown, texture) : spec::expected(shown),
       .x_px = violation.x_px,
       .y_px = violation.y_px,
       .difference = [](const auto&, const auto&) {
         return Colour{255, 0, 0};
       }});
}

}  // namespace selvage::cli
