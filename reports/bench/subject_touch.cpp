// Each cache line of the texture that the picture needs, loaded once, and a fill of the covered
// spans: what reading those texels and writing those pixels costs at least, in that order.
#include "reports/bench/needed_lines.h"
#include "reports/bench/runs.h"
#include "reports/bench/subject.h"

namespace selvage::reports {

namespace {

constexpr size_t kAhead_lines = 256;

struct Touch {
  std::vector<PixelRun> runs;
  NeededLines needed;
  const uint32_t* texels;
  uint32_t sum = 0;  // of the texels, so that they must be loaded

  // As many more at the end as are asked for ahead.
  void pad() {
    const uint32_t last = needed.texels.empty() ? 0 : needed.texels.back();
    needed.texels.resize(needed.texels.size() + kAhead_lines, last);
  }
  void run() {
    size_t next = 0;
    for (size_t i = 0; i < runs.size(); ++i) {
      for (; next < needed.end[i]; ++next) {
        __builtin_prefetch(texels + needed.texels[next + kAhead_lines]);
        sum += texels[needed.texels[next]];
      }
      fill_run(runs[i], place_of(1, 1));
    }
  }
};

}  // namespace

Subject subject_touch() {
  Subject subject;
  subject.id = "touch";
  subject.title = "needed lines and a fill";
  subject.configuration =
      "span by span, one texel of each cache line of the texture that the exact picture needs and "
      "did not need before, asked for " +
      std::to_string(kAhead_lines) +
      " lines ahead, and a fill of overlapping stores; lines and spans are listed beforehand: no "
      "set-up is timed";
  subject.group = "limits";
  subject.textures = false;
  subject.reference = true;
  subject.refusal = [](const Workload&) { return std::string(); };
  subject.prepare = [](const Workload& load, const Texture& texture,
                       Target& target) -> std::function<void()> {
    Touch touch{runs_of(load, target), needed_lines(load, texture), texture.texels.data()};
    touch.pad();
    return [touch = std::move(touch)]() mutable { touch.run(); };
  };
  return subject;
}

}  // namespace selvage::reports
