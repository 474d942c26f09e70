// The mapper's own kind of loop without its exactness: what that costs is the ratio of the two.
#include <algorithm>
#include <chrono>
#include <limits>

#include "reports/bench/inexact_loops.h"
#include "reports/bench/subject.h"

namespace selvage::reports {

namespace {

void draw_all(const InexactLoop& loop, const Workload& load, const Texture& texture,
              Target& target) {
  for (const auto& polygon : load.polygons)
    loop.draw(inexact_polygon(polygon, target.height_px), texture, target);
}

// Of a few passes, the first of which warms up.
double least_ns(const InexactLoop& loop, const Workload& load, const Texture& texture,
                Target& target) {
  constexpr int kPasses = 4;
  double least = std::numeric_limits<double>::infinity();
  for (int pass = 0; pass < kPasses; ++pass) {
    const auto begin = std::chrono::steady_clock::now();
    draw_all(loop, load, texture, target);
    const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - begin;
    least = std::min(least, time.count());
  }
  return least;
}

// They draw the same, so that trying them out leaves the picture that any of them draws.
InexactLoop fastest(const Workload& load, const Texture& texture, Target& target) {
  InexactLoop best;
  double best_ns = std::numeric_limits<double>::infinity();
  for (const InexactLoop& loop : inexact_loops()) {
    const double ns = least_ns(loop, load, texture, target);
    if (ns >= best_ns) continue;
    best_ns = ns;
    best = loop;
  }
  return best;
}

std::string names() {
  std::string text;
  for (const InexactLoop& loop : inexact_loops()) text += (text.empty() ? "" : ", ") + loop.name;
  return text;
}

using ChooseLoop =
    std::function<InexactLoop(const Workload& load, const Texture& texture, Target& target)>;

Subject subject_of_loop(std::string id, const std::string& which, ChooseLoop choose) {
  Subject subject;
  subject.id = std::move(id);
  subject.title = "vector lanes like the mapper's, inexact";
  subject.configuration =
      "edges in 32.32 and gradients in double once a polygon, lanes of 16.16 along a row, in "
      "perspective of single precision with a division a pixel; clamp, left out where a row is "
      "inside the texture; no look for near-ties; " +
      which + "; set-up is timed";
  subject.group = "usual";
  subject.refusal = [](const Workload&) {
    return std::string(inexact_loops().empty() ? "it needs vector kernels, which are not here"
                                               : "");
  };
  subject.prepare = [choose = std::move(choose)](const Workload& load, const Texture& texture,
                                                 Target& target) -> std::function<void()> {
    return [loop = choose(load, texture, target), &load, &texture, &target] {
      draw_all(loop, load, texture, target);
    };
  };
  return subject;
}

}  // namespace

Subject subject_inexact() {
  return subject_of_loop("inexact", "on each item the fastest of " + names() + ", found beforehand",
                         fastest);
}

std::vector<Subject> subjects_inexact_by_loop() {
  std::vector<Subject> subjects;
  for (const InexactLoop& loop : inexact_loops()) {
    subjects.push_back(
        subject_of_loop(loop.name, "by " + loop.name,
                        [loop](const Workload&, const Texture&, Target&) { return loop; }));
  }
  return subjects;
}

}  // namespace selvage::reports
