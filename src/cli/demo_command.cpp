#include "cli/demo_command.h"

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "cli/demo_picture.h"
#include "cli/demo_window.h"
#include "cli/error.h"
#include "cli/polygon_text.h"
#include "cli/scene_file.h"
#include "cli/shipped_scene.h"
#include "scene/clip.h"

namespace selvage::cli {
namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

inline constexpr double kMostStep_s = 0.25;  // a long pause is no jump
inline constexpr int64_t kFrame_ms = 16;     // at least, so that a core is left to others

[[nodiscard]] scene::Size parse_window_size(const std::string& text) {
  const Size size = parse_size_text(text);
  if (size.width_px > scene::kMostSide_px || size.height_px > scene::kMostSide_px) {
    throw UserError("windows have sides of at most " + std::to_string(scene::kMostSide_px) + " px");
  }
  return {size.width_px, size.height_px};
}

[[nodiscard]] scene::Scene read_demo_scene(const DemoOptions& options) {
  const std::string path =
      options.scene.empty() ? first_scene(shipped_scene_places("station")).string() : options.scene;
  scene::Scene scene = read_scene(path);
  if (scene.objects.empty()) throw UserError(path + ": nothing stands in it that could turn");
  return scene;
}

[[nodiscard]] int64_t since_ms(Clock::time_point start) {
  return std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now() - start).count();
}

// Since the last report, or the start.
struct Rate {
  Clock::time_point since = Clock::now();
  int64_t frames = 0;
  Seconds drawing{};
};

void report(const DemoState& state, const DemoPicture& picture, Rate& rate,
            const Console& console) {
  const double frames = static_cast<double>(std::max<int64_t>(rate.frames, 1));
  char text[96];
  std::snprintf(text, sizeof text, "%.1f frames/s, %.2f ms to draw one; ",
                frames / Seconds(Clock::now() - rate.since).count(),
                1000 * rate.drawing.count() / frames);
  console.out << text << demo_settings(state) << "; " << demo_counts(state, picture) << std::endl;
  if (!console.out) throw UserError("cannot write to the standard output");
  rate = {};
}

void run(const scene::Scene& scene, DemoWindow& window, int32_t frames, const Console& console) {
  DemoState state = demo_start(scene);
  scene::Scene now = scene;
  scene::Paints paints(now, scene::kLitBytes);
  Rate rate;
  Clock::time_point last = Clock::now();
  for (int32_t frame = 0; frames == 0 || frame < frames; frame += frames != 0) {
    const Clock::time_point start = Clock::now();
    for (const DemoKey key : window.keys()) press(state, key);
    if (state.quit) return;
    advance(state, std::min(Seconds(start - last).count(), kMostStep_s));
    last = start;
    pose(scene, state, now);
    DemoPicture picture = posed_picture(now, state, window.size(), paints);
    rate.drawing += Clock::now() - start;
    ++rate.frames;
    window.show(picture.raster);
    if (state.report) report(state, picture, rate, console);
    state.report = false;
    window.rest_ms(kFrame_ms - since_ms(start));
  }
}

}  // namespace

int run_demo(const DemoOptions& options, const Console& console) {
  if (options.frames < 0) throw UserError("--frames: 1 or more, or 0 for no end");
  const scene::Size size = about("--size", [&] { return parse_window_size(options.size); });
  const scene::Scene scene = read_demo_scene(options);
  DemoWindow window("Selvage", size);
  run(scene, window, options.frames, console);
  return kExitFine;
}

}  // namespace selvage::cli
