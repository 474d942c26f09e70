#include "reports/bench/threads.h"

#include <cstddef>
#include <string>
#include <utility>

#include "reports/bench/image.h"
#include "reports/bench/report.h"
#include "reports/bench/statistics.h"

namespace selvage::reports {

namespace {

// A workload as a list for one call, with all that it draws on and from.
class Scene {
 public:
  explicit Scene(const Workload& load)
      : load_(load),
        texture_(load.texture_side_texel),
        target_(load.target_side_px, load.target_side_px),
        view_(texture_.view()),
        scratch_(selvage_draw_many_bytes(load.polygons.size())) {
    for (const auto& outline : load.polygons) {
      polygons_.push_back({outline.data(), outline.size(), &view_});
    }
  }
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  void draw_in_turn() {
    const selvage_image image = target_.image();
    for (const auto& [vertices, count, texture] : polygons_) {
      require(selvage_draw(&image, nullptr, vertices, count, texture, nullptr));
    }
  }
  void draw_together(int32_t threads) {
    const selvage_image image = target_.image();
    require(selvage_draw_many(&image, nullptr, polygons_.data(), polygons_.size(), nullptr, threads,
                              scratch_.data(), scratch_.size(), nullptr));
  }
  // Over a target that nothing was drawn on.
  template <class Draw>
  [[nodiscard]] std::vector<uint32_t> picture(const Draw& draw) {
    target_ = Target(load_.target_side_px, load_.target_side_px);
    draw();
    return target_.pixels;
  }

 private:
  void require(selvage_status status) const {
    if (status != SELVAGE_OK) throw WrongAnswer(load_.id + ": " + selvage_status_text(status));
  }

  const Workload& load_;
  Texture texture_;
  Target target_;
  selvage_texture view_;
  std::vector<selvage_polygon> polygons_;
  std::vector<std::byte> scratch_;
};

void check(const Workload& load, Scene& scene, const std::vector<int32_t>& threads) {
  const auto expected = scene.picture([&] { scene.draw_in_turn(); });
  for (const int32_t count : threads) {
    if (scene.picture([&] { scene.draw_together(count); }) == expected) continue;
    throw WrongAnswer(load.id + ": " + std::to_string(count) + " threads draw another picture");
  }
}

[[nodiscard]] nlohmann::ordered_json measure(const Workload& load,
                                             const std::vector<int32_t>& threads,
                                             const TimingOptions& options) {
  Scene scene(load);
  check(load, scene, threads);
  std::vector<Timed> timed{{load.id + "/loop", [&] { scene.draw_in_turn(); }}};
  for (const int32_t count : threads) {
    timed.push_back({load.id + "/threads-" + std::to_string(count),
                     [&scene, count] { scene.draw_together(count); }});
  }
  const auto times_ns = measure_ns(timed, options, [] {});
  const double first_ns = spread_of(times_ns[1]).median;
  auto rows = nlohmann::ordered_json::array();
  for (size_t i = 0; i < threads.size(); ++i) {
    const Spread spread = spread_of(times_ns[i + 1]);
    rows.push_back({{"threads", threads[i]},
                    {"median_ns", spread.median},
                    {"lower_quartile_ns", spread.lower_quartile},
                    {"upper_quartile_ns", spread.upper_quartile},
                    {"speed_up", first_ns / spread.median}});
  }
  return {{"workload", load.id},
          {"loop_ns", spread_of(times_ns[0]).median},
          {"threads", std::move(rows)}};
}

}  // namespace

nlohmann::ordered_json measure_threads(const std::vector<Workload>& loads,
                                       const std::vector<int32_t>& threads,
                                       const TimingOptions& options) {
  auto all = nlohmann::ordered_json::array();
  for (const Workload& load : loads) all.push_back(measure(load, threads, options));
  return all;
}

}  // namespace selvage::reports
