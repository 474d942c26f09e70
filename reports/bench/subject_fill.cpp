// A solid fill of the covered spans: what writing those pixels costs at least.
#include <algorithm>

#include "reports/bench/spans.h"
#include "reports/bench/subject.h"

namespace selvage::reports {

Subject subject_fill() {
  Subject subject;
  subject.id = "fill";
  subject.title = "solid fill";
  subject.configuration = "std::fill over the covered spans, listed beforehand: no set-up is timed";
  subject.group = "limits";
  subject.bilinear = true;
  subject.area = true;
  subject.textures = false;
  subject.reference = true;  // the number of covered pixels rests on the same spans
  subject.refusal = [](const Workload&) { return std::string(); };
  subject.prepare = [](const Workload& load, const Texture&, Target& target) {
    std::vector<Span> spans;
    for (const auto& polygon : load.polygons) {
      for_each_span(polygon, target.width_px, target.height_px,
                    [&](const Span& span) { spans.push_back(span); });
    }
    return [spans = std::move(spans), &target] {
      for (const Span& span : spans) {
        uint32_t* row = target.row(span.y_px);
        std::fill(row + span.left_px, row + span.right_px, place_of(1, 1));
      }
    };
  };
  return subject;
}

}  // namespace selvage::reports
