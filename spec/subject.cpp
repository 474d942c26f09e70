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

Subject built_in(selvage_profile profile) {
  Subject subject;
  subject.name = "selvage " + std::string(selvage_version());
  subject.draw = selvage_draw;
  subject.profile = profile;
  subject.draw_many = draw_many;
  return subject;
}

}  // namespace selvage::spec
