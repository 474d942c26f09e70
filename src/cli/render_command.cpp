#include "cli/render_command.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>

#include "cli/apng.h"
#include "cli/error.h"
#include "cli/file.h"
#include "cli/job.h"
#include "cli/png.h"
#include "cli/polygon_text.h"
#include "cli/render_report.h"
#include "cli/render_stats.h"
#include "cli/scene_file.h"
#include "cli/status_line.h"

namespace selvage::cli {
namespace {

inline constexpr int32_t kMostFrames = 99999;
inline constexpr int32_t kMostSide_px = 16384;  // the scene's guard band

[[nodiscard]] scene::Hidden parse_hidden(const std::string& name) {
  if (name == "scan-line") return scene::Hidden::kScanLine;
  if (name == "painter") return scene::Hidden::kPainter;
  throw UserError("'" + name + "' is no way to hide surfaces; these are: scan-line, painter");
}

[[nodiscard]] std::optional<selvage_filter> parse_wished_filter(const std::string& name) {
  if (name == "auto") return std::nullopt;
  return parse_filter(name);
}

[[nodiscard]] Size parse_picture_size(const std::string& text) {
  const Size size = parse_size_text(text);
  if (size.width_px > kMostSide_px || size.height_px > kMostSide_px) {
    throw UserError("pictures of scenes have sides of at most " + std::to_string(kMostSide_px) +
                    " px");
  }
  return size;
}

[[nodiscard]] bool is_animation(const RenderOptions& options) {
  return std::filesystem::path(options.output).extension() == ".apng";
}

// "NAME=FILE" each.
[[nodiscard]] SceneFiles parse_textures(const std::vector<std::string>& texts) {
  SceneFiles files;
  for (const std::string& text : texts) {
    const size_t split = text.find('=');
    if (split == 0 || split == std::string::npos || split + 1 == text.size()) {
      throw UserError("'" + text + "': MATERIAL=FILE is needed");
    }
    if (!files.textures.emplace(text.substr(0, split), text.substr(split + 1)).second) {
      throw UserError("'" + text.substr(0, split) + "' stands twice");
    }
  }
  return files;
}

void check(const RenderOptions& options) {
  if (options.frames < 1 || options.frames > kMostFrames) {
    throw UserError("--frames: 1 to " + std::to_string(kMostFrames) + " are possible");
  }
  if (!std::isfinite(options.start_s)) throw UserError("--time: a number of seconds is needed");
  if (!(options.frames_per_s > 0) || !std::isfinite(options.frames_per_s)) {
    throw UserError("--rate: a number of frames a second, above 0, is needed");
  }
  if (std::filesystem::path(options.output).extension() != ".png" && !is_animation(options)) {
    throw UserError("cannot write '" + options.output +
                    "': the output is a PNG or an animated PNG; name it .png or .apng");
  }
}

// Of one frame, and of an animation, the name as it is; of several "name-00001.png" and so on.
[[nodiscard]] std::string frame_name(const RenderOptions& options, int32_t frame) {
  if (options.frames == 1 || is_animation(options)) return options.output;
  char number[16];
  std::snprintf(number, sizeof number, "-%05d", frame + 1);
  std::filesystem::path name = options.output;
  name.replace_filename(name.stem().string() + number + name.extension().string());
  return name.string();
}

// Where the frames go: files of their own, or one animation.
class Output {
 public:
  explicit Output(const RenderOptions& options) : options_(options) {
    for (int32_t i = 0; i < options.frames; ++i) check_output(frame_name(options, i));
    if (!is_animation(options)) return;
    animation_.emplace(static_cast<uint32_t>(options.frames),
                       about("--rate", [&] { return frame_delay(options.frames_per_s); }));
  }

  void add(int32_t frame, const Raster& raster) {
    if (!animation_) return write_file(frame_name(options_, frame), encode_png(raster));
    animation_->add(raster);
    if (frame + 1 == options_.frames) write_file(options_.output, animation_->finish());
  }

 private:
  const RenderOptions& options_;
  std::optional<Apng> animation_;
};

[[nodiscard]] int64_t since_ns(std::chrono::steady_clock::time_point start) {
  return std::chrono::nanoseconds(std::chrono::steady_clock::now() - start).count();
}

struct Frame {
  Bitmap picture;
  scene::Drawing drawing;
  int64_t compose_ns = 0, draw_ns = 0;
};

[[nodiscard]] Frame draw_frame(const scene::Scene& scene, double time_s, const Size& size,
                               const scene::Wish& wish, scene::Hidden hidden) {
  Frame frame;
  const auto start = std::chrono::steady_clock::now();
  frame.drawing = compose(scene, time_s, {size.width_px, size.height_px}, wish, hidden);
  frame.compose_ns = since_ns(start);
  frame.picture = to_bitmap(filled(size.width_px, size.height_px, {}), SELVAGE_RGBA8888);
  const selvage_image target = frame.picture.image();
  clear(scene, target);
  const auto drawing = std::chrono::steady_clock::now();
  const selvage_status status = draw_pieces(scene, frame.drawing, target);
  frame.draw_ns = since_ns(drawing);
  if (status != SELVAGE_OK) throw UserError(selvage_status_text(status));
  return frame;
}

}  // namespace

int run_render(const RenderOptions& options, const Console& console) {
  check(options);
  const Size size = about("--size", [&] { return parse_picture_size(options.size); });
  const scene::Hidden hidden = about("--hidden", [&] { return parse_hidden(options.hidden); });
  scene::Wish wish;
  wish.filter = about("--filter", [&] { return parse_wished_filter(options.filter); });
  const SceneFiles files = about("--texture", [&] { return parse_textures(options.textures); });
  Output output(options);
  const scene::Scene scene = read_scene(options.scene, files);
  wish.tolerance_texel = scene.tolerance_texel;
  if (!options.tolerance.empty()) {
    wish.tolerance_texel = about("--tolerance", [&] { return parse_tolerance(options.tolerance); });
  }
  StatusLine status(console);
  RenderStats stats;
  RoundingWarning rounding(wish.tolerance_texel);
  nlohmann::ordered_json told;
  for (int32_t i = 0; i < options.frames; ++i) {
    status.count("drawing frame", static_cast<uint64_t>(i), static_cast<uint64_t>(options.frames));
    Frame frame = draw_frame(scene, options.start_s + i / options.frames_per_s, size, wish, hidden);
    rounding.add(scene, frame.drawing);
    if (options.explain && i == 0) {
      told["faces"] = explanation(scene, frame.drawing, wish.tolerance_texel, frame.picture);
    }
    if (options.stats) {
      RenderStats one = stats_of(scene, frame.drawing, frame.picture);
      one.compose_ns = frame.compose_ns;
      one.draw_ns = frame.draw_ns;
      stats.add(one);
    }
    output.add(i, to_raster(std::move(frame.picture)));
  }
  status.show("");
  console.err << rounding.line();
  if (options.stats) told["stats"] = stats_json(stats, options.frames);
  if (options.json) {
    console.out << told.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
  } else {
    if (options.explain) console.out << explanation_text(told["faces"]);
    if (options.stats) console.out << stats_text(stats, options.frames);
  }
  return kExitFine;
}

}  // namespace selvage::cli
