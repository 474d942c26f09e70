#include "cli/render_command.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>

#include "cli/apng.h"
#include "cli/error.h"
#include "cli/job.h"
#include "cli/json_text.h"
#include "cli/picture_output.h"
#include "cli/png.h"
#include "cli/polygon_text.h"
#include "cli/render_report.h"
#include "cli/render_stats.h"
#include "cli/scene_file.h"
#include "cli/status_line.h"
#include "scene/clip.h"

namespace selvage::cli {
namespace {

inline constexpr int32_t kMostFrames = 99999;
inline constexpr double kMostFrameTime_s = 1e9;

[[nodiscard]] scene::Hidden parse_hidden(const std::string& name) {
  if (name == "scan-line") return scene::Hidden::kScanLine;
  if (name == "painter") return scene::Hidden::kPainter;
  throw UserError("'" + name + "' is no way to hide surfaces; these are: scan-line, painter");
}

[[nodiscard]] std::optional<selvage_filter> parse_wished_filter(const std::string& name) {
  if (name == "auto") return std::nullopt;
  try {
    return parse_filter(name);
  } catch (const UserError&) {
    throw UserError("'" + name + "' is no filter; auto, nearest, four, bilinear and area are");
  }
}

[[nodiscard]] Size parse_picture_size(const std::string& text) {
  SizeLimits limits;
  limits.side_px = scene::kMostSide_px;
  return parse_size_text(text, limits);
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
  if (!(options.frames_per_s > 0) || !std::isfinite(options.frames_per_s)) {
    throw UserError("--rate: a number of frames a second, above 0, is needed");
  }
  const double last_s = options.start_s + (options.frames - 1) / options.frames_per_s;
  if (!(std::abs(options.start_s) <= kMostFrameTime_s && std::abs(last_s) <= kMostFrameTime_s)) {
    throw UserError("--time: all frames must lie within 1000000000 s of 0");
  }
  check_picture_name(options.output, PictureKinds::kAnimationsToo);
  if (options.output == kStandardOutput && options.frames > 1) {
    throw UserError("the standard output takes one picture; --frames 1 is right with -o -");
  }
  if (options.json && !options.explain && !options.stats) {
    throw UserError("--json: it prints what --explain and --stats tell; give one of them too");
  }
}

// Of one frame, and of an animation, the name as it is; of several "name-00001.png" and so on.
[[nodiscard]] std::string frame_name(const RenderOptions& options, int32_t frame) {
  if (options.frames == 1 || is_animation_name(options.output)) return options.output;
  char number[16];
  std::snprintf(number, sizeof number, "-%05d", frame + 1);
  std::filesystem::path name = options.output;
  name.replace_filename(name.stem().string() + number + name.extension().string());
  return name.string();
}

// Where the frames go: files of their own, or one animation.
class Output {
 public:
  Output(const RenderOptions& options, const Console& console)
      : options_(options), console_(console) {
    for (int32_t i = 0; i < options.frames; ++i) {
      check_picture(frame_name(options, i), PictureKinds::kAnimationsToo, console,
                    /*is_taken=*/options.explain || options.stats);
    }
    if (!is_animation_name(options.output)) return;
    animation_.emplace(static_cast<uint32_t>(options.frames),
                       about("--rate", [&] { return frame_delay(options.frames_per_s); }));
  }

  void add(int32_t frame, const Raster& raster) {
    if (!animation_) {
      return write_picture(frame_name(options_, frame), encode_png(raster), console_);
    }
    animation_->add(raster);
    if (frame + 1 == options_.frames) {
      write_picture(options_.output, animation_->finish(), console_);
    }
  }

 private:
  const RenderOptions& options_;
  const Console& console_;
  std::optional<Apng> animation_;
};

[[nodiscard]] int64_t now_ns() {
  return std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count();
}

struct Frame {
  Bitmap picture;
  scene::Drawing drawing;
  int64_t compose_ns = 0, light_ns = 0, sums_ns = 0, draw_ns = 0;
};

[[nodiscard]] Frame draw_frame(const scene::Scene& scene, double time_s, const Size& size,
                               const scene::Wish& wish, scene::Hidden hidden,
                               scene::Paints& paints) {
  Frame frame;
  const int64_t start_ns = now_ns();
  frame.drawing = compose(scene, time_s, {size.width_px, size.height_px}, wish, hidden);
  frame.compose_ns = now_ns() - start_ns;
  frame.picture = to_bitmap(filled(size.width_px, size.height_px, {}), SELVAGE_RGBA8888);
  const selvage_image target = frame.picture.image();
  clear(scene, target);
  const int64_t lit_before_ns = paints.light_ns(), sums_before_ns = paints.sums().ns();
  const int64_t drawing_ns = now_ns();
  const selvage_status status = draw_pieces(scene, frame.drawing, target, paints);
  frame.draw_ns = now_ns() - drawing_ns;
  frame.light_ns = paints.light_ns() - lit_before_ns;
  frame.sums_ns = paints.sums().ns() - sums_before_ns;
  frame.draw_ns -= frame.light_ns + frame.sums_ns;
  if (status != SELVAGE_OK) throw UserError(selvage_status_text(status));
  return frame;
}

[[nodiscard]] scene::Wish wish_of(const RenderOptions& options, const scene::Scene& scene) {
  scene::Wish wish;
  wish.filter = about("--filter", [&] { return parse_wished_filter(options.filter); });
  wish.tolerance_texel = scene.tolerance_texel;
  if (!options.tolerance.empty()) {
    wish.tolerance_texel = about("--tolerance", [&] { return parse_tolerance(options.tolerance); });
  }
  return wish;
}

// What --explain and --stats tell, gathered from the frames.
class Told {
 public:
  explicit Told(const RenderOptions& options) : options_(options) {}

  void add(const scene::Scene& scene, Frame& frame, double tolerance_texel) {
    if (options_.explain && faces_.is_null()) {  // of the first frame
      faces_ = explanation(scene, frame.drawing, tolerance_texel, frame.picture);
    }
    if (!options_.stats) return;
    RenderStats one = stats_of(scene, frame.drawing, frame.picture);
    one.compose_ns = frame.compose_ns;
    one.light_ns = frame.light_ns;
    one.sums_ns = frame.sums_ns;
    one.draw_ns = frame.draw_ns;
    stats_.add(one);
  }

  void print(std::ostream& out) const {
    if (!options_.json) {
      if (options_.explain) out << explanation_text(faces_);
      if (options_.stats) out << stats_text(stats_, options_.frames);
      return;
    }
    nlohmann::ordered_json told;
    if (options_.explain) told["faces"] = faces_;
    if (options_.stats) told["stats"] = stats_json(stats_, options_.frames);
    out << json_text(told);
  }

 private:
  const RenderOptions& options_;
  nlohmann::ordered_json faces_;
  RenderStats stats_;
};

}  // namespace

int run_render(const RenderOptions& options, const Console& console) {
  check(options);
  const Size size = about("--size", [&] { return parse_picture_size(options.size); });
  const scene::Hidden hidden = about("--hidden", [&] { return parse_hidden(options.hidden); });
  static_cast<void>(wish_of(options, {}));  // before any file is read
  const SceneFiles files = about("--texture", [&] { return parse_textures(options.textures); });
  Output output(options, console);
  const scene::Scene scene = read_scene(options.scene, files);
  const scene::Wish wish = wish_of(options, scene);
  StatusLine status(console);
  RoundingWarning rounding(wish.tolerance_texel);
  Told told(options);
  scene::Paints paints(scene, scene::kLitBytes, now_ns);
  for (int32_t i = 0; i < options.frames; ++i) {
    status.count("drawing frame", static_cast<uint64_t>(i), static_cast<uint64_t>(options.frames));
    const double time_s = options.start_s + i / options.frames_per_s;
    Frame frame = draw_frame(scene, time_s, size, wish, hidden, paints);
    rounding.add(scene, frame.drawing);
    told.add(scene, frame, wish.tolerance_texel);
    output.add(i, to_raster(std::move(frame.picture)));
  }
  status.show("");
  console.err << rounding.line();
  told.print(console.out);
  return kExitFine;
}

}  // namespace selvage::cli
