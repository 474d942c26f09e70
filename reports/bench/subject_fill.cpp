// A solid fill of the covered spans: what writing those pixels costs at least.
#include "reports/bench/runs.h"
#include "reports/bench/subject.h"

namespace selvage::reports {

Subject subject_fill() {
  Subject subject;
  subject.id = "fill";
  subject.title = "solid fill";
  subject.configuration = "the covered spans, listed beforehand, each filled by the fastest of";
  for (const Fill& fill : fills_here()) subject.configuration += std::string(" ") + fill.name + ",";
  subject.configuration += " found for each item beforehand: no set-up is timed";
  subject.group = "limits";
  subject.bilinear = true;
  subject.area = true;
  subject.textures = false;
  subject.reference = true;  // the number of covered pixels rests on the same spans
  subject.refusal = [](const Workload&) { return std::string(); };
  subject.prepare = [](const Workload& load, const Texture&,
                       Target& target) -> std::function<void()> {
    std::vector<PixelRun> runs = runs_of(load, target);
    const Fill fastest = fastest_fill(runs);
    return [runs = std::move(runs), fastest] { fastest.fill(runs, place_of(1, 1)); };
  };
  return subject;
}

}  // namespace selvage::reports
