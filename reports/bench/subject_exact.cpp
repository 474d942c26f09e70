// Our mapper, through its public call.
#include <stdexcept>

#include "reports/bench/subject.h"

namespace selvage::reports {

Subject subject_exact() {
  Subject subject;
  subject.id = "Selvage";
  subject.title = "Selvage, exact profile";
  subject.configuration = "selvage_draw once a polygon, nearest, clamp; set-up is timed";
  subject.reference = true;
  subject.refusal = [](const Workload&) { return std::string(); };
  subject.prepare = [](const Workload& load, const Texture& texture, Target& target) {
    return [&load, view = texture.view(), image = target.image()] {
      for (const auto& polygon : load.polygons) {
        const selvage_status status =
            selvage_draw(&image, nullptr, polygon.data(), polygon.size(), &view, nullptr);
        if (status != SELVAGE_OK)
          throw std::runtime_error(load.id + ": selvage_draw: " + selvage_status_text(status));
      }
    };
  };
  return subject;
}

}  // namespace selvage::reports
