// Each cache line of the texture that the picture needs, loaded once, and a fill of the covered
// spans: what reading those texels and writing those pixels costs at least, in that order.
#include "reports/bench/needed_lines.h"
#include "reports/bench/runs.h"
#include "reports/bench/subject.h"

namespace selvage::reports {

namespace {

constexpr size_t kAhead_lines = 256;
constexpr int32_t kGroup_px = 512;  // filled at a time, so that going back and forth costs nothing

// Behind its last run, and behind the lines that its runs need.
struct Group {
  size_t end_run, end_line;
};

class Touch {
 public:
  Touch(std::vector<PixelRun> runs, NeededLines needed, const uint32_t* texels)
      : runs_(std::move(runs)),
        texels_(texels),
        lines_(std::move(needed.texels)),
        fill_(fastest_fill(runs_)) {
    int32_t count_px = 0;
    for (size_t i = 0; i < runs_.size(); ++i) {
      count_px += runs_[i].count_px;
      if (count_px < kGroup_px && i + 1 < runs_.size()) continue;
      groups_.push_back({i + 1, needed.end[i]});
      count_px = 0;
    }
    // As many more as are asked for ahead.
    lines_.resize(lines_.size() + kAhead_lines, lines_.empty() ? 0 : lines_.back());
  }

  void operator()() {
    size_t run = 0, line = 0;
    for (const Group& group : groups_) {
      for (; line < group.end_line; ++line) {
        __builtin_prefetch(texels_ + lines_[line + kAhead_lines]);
        sum_ += texels_[lines_[line]];
      }
      fill_.fill(std::span(runs_).subspan(run, group.end_run - run), place_of(1, 1));
      run = group.end_run;
    }
  }

 private:
  std::vector<PixelRun> runs_;
  const uint32_t* texels_;
  std::vector<uint32_t> lines_;
  std::vector<Group> groups_;
  Fill fill_;
  uint32_t sum_ = 0;  // of the texels, so that they must be loaded
};

}  // namespace

Subject subject_touch() {
  Subject subject;
  subject.id = "touch";
  subject.title = "needed lines and a fill";
  subject.configuration =
      "one texel of each cache line of the texture that the exact picture needs, in the order in "
      "which drawing first needs them, asked for " +
      std::to_string(kAhead_lines) + " lines ahead, and after every " + std::to_string(kGroup_px) +
      " px or more a fill of the spans that need them, as of fill; lines and spans are listed "
      "beforehand: no set-up is timed";
  subject.group = "limits";
  subject.textures = false;
  subject.reference = true;
  subject.refusal = [](const Workload&) { return std::string(); };
  subject.prepare = [](const Workload& load, const Texture& texture,
                       Target& target) -> std::function<void()> {
    return Touch(runs_of(load, target), needed_lines(load, texture), texture.texels.data());
  };
  return subject;
}

}  // namespace selvage::reports
