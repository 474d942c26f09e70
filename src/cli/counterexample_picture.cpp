#include "cli/counterexample_picture.h"

#include "cli/comparison_picture.h"

namespace selvage::cli {

Raster counterexample_picture(const spec::Subject& subject, const spec::Violation& violation) {
  return comparison_picture({.scene = violation.shown,
                             .drawn = spec::draw(subject, violation.shown),
                             .expected = spec::expected(violation.shown),
                             .x_px = violation.x_px,
                             .y_px = violation.y_px,
                             .difference = [](const auto&, const auto&) {
                               return Colour{255, 0, 0};
                             }});
}

}  // namespace selvage::cli
