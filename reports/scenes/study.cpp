#include "reports/scenes/study.h"

#include <algorithm>
#include <cstdlib>
#include <set>

#include "cli/file.h"
#include "cli/png.h"
#include "reports/scenes/animation.h"
#include "reports/scenes/overlay.h"

namespace selvage::reports {
namespace {

[[nodiscard]] std::string short_name(double tolerance_texel) {
  std::string name = tolerance_name(tolerance_texel);
  std::replace(name.begin(), name.end(), '/', '-');
  return name;
}

void compare(const cli::Raster& picture, const cli::Raster& exact, Trial& trial) {
  for (size_t i = 0; i < picture.rgba.size(); i += 4) {
    int32_t level = 0;
    for (size_t channel = i; channel < i + 4; ++channel)
      level = std::max(level, std::abs(picture.rgba[channel] - exact.rgba[channel]));
    trial.different_px += level > 0;
    trial.largest_level = std::max(trial.largest_level, level);
  }
}

[[nodiscard]] std::array<size_t, kChoices> faces_by_choice(const ExactView& exact,
                                                           const RowChoices& choices) {
  std::array<std::set<size_t>, kChoices> faces;
  for (int32_t y_px = 0; y_px < exact.size.height_px; ++y_px) {
    for (int32_t x_px = 0; x_px < exact.size.width_px; ++x_px) {
      const std::optional<size_t> face = exact.pixel(x_px, y_px).face;
      if (face) faces[static_cast<size_t>(choices.at(*face, y_px).choice)].insert(*face);
    }
  }
  std::array<size_t, kChoices> counts{};
  for (size_t i = 0; i < kChoices; ++i) counts[i] = faces[i].size();
  return counts;
}

void write_picture(const std::filesystem::path& path, const cli::Raster& picture) {
  cli::write_file(path, cli::encode_png(picture));
}

// The trials of one filter; the exact one comes first, and the others are compared with it.
void add_trials(Study& study, const std::string& name, std::optional<selvage_filter> filter,
                const ExactView& exact, const std::filesystem::path& output,
                const std::function<void()>& tick) {
  cli::Raster exact_picture;
  for (const double tolerance_texel : kTolerances_texel) {
    tick();
    const scene::Drawing drawing =
        compose(study.what, 0, study.size, {tolerance_texel, filter}, scene::Hidden::kScanLine);
    const RowChoices choices(study.what, drawing, study.size);
    const Drawn drawn = draw_both(study.what, drawing, study.size);
    if (tolerance_texel == 0) exact_picture = drawn.picture;
    Trial trial;
    trial.filter = name;
    trial.tolerance_texel = tolerance_texel;
    trial.overlay_file =
        std::string(study.shipped->id) + "-" + name + "-" + short_name(tolerance_texel) + ".png";
    trial.verdict = judge(study.what, drawing, exact, choices, drawn, tolerance_texel);
    trial.choice_faces = faces_by_choice(exact, choices);
    trial.calls = std::make_unique<Calls>(study.what, drawing);
    compare(drawn.picture, exact_picture, trial);
    write_picture(output / trial.overlay_file, overlay(drawn.picture, exact, choices));
    study.trials.push_back(std::move(trial));
  }
}

}  // namespace

std::unique_ptr<Study> study(const Shipped& shipped, const std::filesystem::path& folder,
                             const scene::Size& size, const std::filesystem::path& output,
                             const std::function<void()>& tick) {
  auto study = std::make_unique<Study>(
      Study{&shipped, read_shipped(folder, shipped), size, {}, 0, 0, 0, {}});
  tick();
  study->tolerance_texel = study->what.tolerance_texel;
  const scene::View view = look(study->what, 0, size);
  study->counts = view.counts;
  const ExactView exact = exact_view(view, size);
  std::set<size_t> shown;
  for (const ExactPixel& pixel : exact.pixels) {
    study->shown_px += pixel.face.has_value();
    if (pixel.face) shown.insert(*pixel.face);
  }
  study->faces_shown = shown.size();
  write_picture(output / (std::string(shipped.id) + ".png"),
                picture(study->what, shipped.filter, 0, size));
  add_trials(*study, "auto", std::nullopt, exact, output, tick);
  add_trials(*study, "nearest", SELVAGE_FILTER_NEAREST, exact, output, tick);
  return study;
}

std::vector<std::string> breaches(const std::vector<std::unique_ptr<Study>>& studies) {
  std::vector<std::string> lines;
  for (const auto& study : studies) {
    for (const Trial& trial : study->trials) {
      if (trial.verdict.breaches == 0) continue;
      lines.push_back(std::string(study->shipped->id) + ", filter " + trial.filter +
                      ", tolerance " + tolerance_name(trial.tolerance_texel) + ": " +
                      trial.verdict.first_breach + "; " + std::to_string(trial.verdict.breaches) +
                      " such pixels");
    }
  }
  return lines;
}

std::string tolerance_name(double tolerance_texel) {
  return tolerance_texel > 0 && tolerance_texel < 1
             ? "1/" + std::to_string(static_cast<int>(1 / tolerance_texel))
             : std::to_string(static_cast<int>(tolerance_texel));
}

}  // namespace selvage::reports
