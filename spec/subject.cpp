#include "spec/subject.h"

#include <cstddef>
#include <vector>

namespace selvage::spec {
namespace {

[[nodiscard]] selvage_status draw_many(const selvage_image* target, const selvage_rect* clip,
                                       const selvage_polygon* polygons, size_t count,
                                       const selvage_options* options, int32_t threads,
                                       size_t* failed) {
  std::vector<std::byte> scratch(selvage_draw_many_bytes(count));
  return selvage_draw_many(target, clip, polygons, count, options, threads, scratch.data(),
                           scratch.size(), failed);
}

}  // namespace

void demand_claimed(const Subject& subject, const Case& c) {
  if (std::optional<std::string> what = beyond(subject.claims, c)) throw NotClaimed{*what};
}

void take_kernel(selvage_kernel kernel, Subject* subject) {
  const auto options_with = [kernel](const selvage_options* options) {
    selvage_options changed = options != nullptr ? *options : selvage_options{};
    if (changed.kernel == SELVAGE_KERNEL_FASTEST) changed.kernel = kernel;
    return changed;
  };
  subject->draw = [options_with, draw = subject->draw](auto* target, auto* clip, auto* vertices,
                                                       size_t count, auto* texture, auto* options) {
    const selvage_options changed = options_with(options);
    return draw(target, clip, vertices, count, texture, &changed);
  };
  if (subject->draw_many) {
    subject->draw_many = [options_with, draw = subject->draw_many](
                             auto* target, auto* clip, auto* polygons, size_t count, auto* options,
                             int32_t threads, size_t* failed) {
      const selvage_options changed = options_with(options);
      return draw(target, clip, polygons, count, &changed, threads, failed);
    };
  }
  if (subject->choose) {
    subject->choose = [options_with, choose = subject->choose](
                          auto* target, auto* clip, auto* vertices, size_t count, auto* texture,
                          auto* options, auto* choice) {
      const selvage_options changed = options_with(options);
      return choose(target, clip, vertices, count, texture, &changed, choice);
    };
  }
}

Subject built_in(selvage_profile profile) {
  Subject subject;
  subject.name = "selvage " + std::string(selvage_version());
  subject.draw = selvage_draw;
  subject.profile = profile;
  subject.draw_many = draw_many;
  subject.prepare = Prepare{selvage_prepare, selvage_prepare_bytes};
  subject.choose = selvage_choose;
  return subject;
}

}  // namespace selvage::spec
