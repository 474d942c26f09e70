#include "spec/subject.h"

#include <cstddef>
#include <vector>

namespace selvage::spec {
namespace {

[[nodiscard]] selvage_status draw_many(const selvage_image* target, const selvage_rect* clip,
                                       const selvage_polygon* polygons, size_t count,
                                       const selvage_options* options, int32_t threads) {
  std::vector<std::byte> scratch(selvage_draw_many_bytes(count));
  return selvage_draw_many(target, clip, polygons, count, options, threads, scratch.data(),
                           scratch.size(), nullptr);
}

}  // namespace

void demand_claimed(const Subject& subject, const Case& c) {
  if (std::optional<std::string> what = beyond(subject.claims, c)) throw NotClaimed{*what};
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
