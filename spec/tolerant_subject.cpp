#include "spec/tolerant_subject.h"

#include "spec/status_name.h"

namespace selvage::spec {
namespace {

// Calls call(options), which draws nothing where it answers that there is no such kernel.
template <class Call>
[[nodiscard]] selvage_status by_some_kernel(selvage_options options, const Call& call) {
  const selvage_status status = call(options);
  if (status != SELVAGE_ERROR_KERNEL) return status;
  options.kernel = SELVAGE_KERNEL_FASTEST;
  return call(options);
}

}  // namespace

Subject tolerating(const Subject& subject, const Tolerance& tolerance) {
  Subject tolerant = subject;
  tolerant.draw = [draw = subject.draw, tolerance](
                      const selvage_image* target, const selvage_rect* clip,
                      const selvage_vertex* vertices, size_t count, const selvage_texture* texture,
                      const selvage_options* options) {
    selvage_options changed = *options;
    changed.tolerance = tolerance.fx16;
    changed.kernel = tolerance.kernel;
    return by_some_kernel(changed, [&](const selvage_options& by) {
      return draw(target, clip, vertices, count, texture, &by);
    });
  };
  return tolerant;
}

AskedChoice::AskedChoice(const Subject& subject, const Case& c, const Tolerance& tolerance)
    : subject_(subject),
      case_(c),
      options_{c.profile, c.filter, c.address, tolerance.fx16, tolerance.kernel},
      target_(c.format, c.target_width_px, c.target_height_px, c.padding_px, c.flip_target, 0x5A),
      untouched_(target_),
      texture_(c.format, c.texture_width_texel, c.texture_height_texel, c.padding_px,
               c.flip_texture, 0) {}

selvage_choice AskedChoice::all() { return by_clip(case_.has_clip ? &case_.clip : nullptr); }

selvage_choice AskedChoice::row(int32_t y_px) {
  selvage_rect clip = case_.has_clip ? case_.clip : selvage_rect{0, 0, case_.target_width_px, 0};
  const bool visible = !case_.has_clip || (clip.top <= y_px && y_px < clip.bottom);
  clip.top = y_px;
  clip.bottom = visible ? y_px + 1 : y_px;
  return by_clip(&clip);
}

selvage_choice AskedChoice::by_clip(const selvage_rect* clip) {
  const selvage_image image = target_.image();
  const selvage_texture texture = texture_.texture();
  selvage_choice choice{-1, -1, -1};  // stays, where an error is returned
  const selvage_status status = by_some_kernel(options_, [&](const selvage_options& by) {
    return subject_.choose(&image, clip, case_.vertices.data(), case_.vertices.size(), &texture,
                           &by, &choice);
  });
  if (status != SELVAGE_OK) fault_ = "the choice is refused: status " + status_name(status);
  if (!(target_ == untouched_)) fault_ = "asking for the choice has written to the target";
  return choice;
}

}  // namespace selvage::spec
