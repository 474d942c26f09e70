// selvage_scenes: the shipped scenes drawn, judged against the exact model, timed, told in JSON.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>

#include "cli/error.h"
#include "cli/file.h"
#include "cli/job.h"
#include "cli/polygon_text.h"
#include "cli/status_line.h"
#include "reports/bench/timing.h"
#include "reports/scenes/animation.h"
#include "reports/scenes/plot_data.h"
#include "reports/scenes/study.h"

namespace {

using namespace selvage;
using namespace selvage::reports;
using Json = nlohmann::ordered_json;
using Studies = std::vector<std::unique_ptr<Study>>;
namespace fs = std::filesystem;

struct Options {
  std::string shipped, output, size = "640x480";
  uint32_t frames = 96;
  TimingOptions timing{15, 0.02};
};

[[nodiscard]] scene::Size parse_size(const std::string& text) {
  const cli::Size size = cli::about("--size", [&] { return cli::parse_size_text(text); });
  if (size.width_px > 4096 || size.height_px > 4096)
    throw cli::UserError("--size: every pixel is judged; sides of at most 4096 px are possible");
  return {size.width_px, size.height_px};
}

[[nodiscard]] Studies draw_and_judge(const Options& options, cli::StatusLine& line) {
  const scene::Size size = parse_size(options.size);
  const uint64_t steps = kShipped.size() * (1 + 2 * kTolerances_texel.size());
  uint64_t done = 0;
  Studies studies;
  for (const Shipped& shipped : kShipped) {
    studies.push_back(study(shipped, options.shipped, size, options.output,
                            [&] { line.count("scenes: drawing and judging,", ++done, steps); }));
  }
  return studies;
}

// All drawings of all scenes, interleaved.
void measure(const Studies& studies, const TimingOptions& options, cli::StatusLine& line) {
  const scene::Size& size = studies.front()->size;
  cli::Raster raster = cli::filled(size.width_px, size.height_px, {});
  const selvage_image image{raster.rgba.data(), size.width_px, size.height_px,
                            static_cast<ptrdiff_t>(size.width_px) * 4, SELVAGE_RGBA8888};
  struct Goal {
    std::optional<Spread>* spread;
    double px;
  };
  std::vector<Timed> timed;
  std::vector<Goal> goals;
  for (const auto& study : studies) {
    for (Trial& trial : study->trials) {
      for (const bool textured : {false, true}) {
        timed.push_back({std::string(study->shipped->id) + "/" + trial.overlay_file +
                             (textured ? "/textured" : "/all"),
                         [&trial, &image, textured] { trial.calls->draw(image, textured); }});
        goals.push_back(
            {textured ? &trial.textured_ns_per_px : &trial.ns_per_px,
             static_cast<double>(textured ? trial.verdict.textured_px : study->shown_px)});
      }
    }
  }
  uint64_t runs = 0;
  const auto times_ns = measure_ns(
      timed, options, [&] { line.show("scenes: timing, run " + std::to_string(++runs)); });
  for (size_t i = 0; i < timed.size(); ++i) {
    if (goals[i].px == 0) continue;
    std::vector<double> per_px = times_ns[i];
    for (double& ns : per_px) ns /= goals[i].px;
    *goals[i].spread = spread_of(per_px);
  }
}

void animate(const Options& options, const Study& study, cli::StatusLine& line) {
  uint64_t frame = 0;
  const auto bytes = animation(study.what, *study.shipped, study.size, options.frames, [&] {
    line.count("scenes: animation, frame", ++frame, options.frames);
  });
  cli::write_file(fs::path(options.output) / (std::string(study.shipped->id) + ".apng"), bytes);
}

[[nodiscard]] Json document(const Studies& studies, const Options& options) {
  Json choices = Json::array(), scenes = Json::array();
  for (size_t i = 0; i < kChoices; ++i) {
    const ChoiceStyle& style = style_of(choice_number(i));
    char colour[8];
    std::snprintf(colour, sizeof colour, "#%02x%02x%02x", style.colour.red, style.colour.green,
                  style.colour.blue);
    choices.push_back({{"id", style.id}, {"title", style.title}, {"colour", colour}});
  }
  for (const auto& study : studies) {
    Json one = json_of(*study);
    one["animation"] = std::string(study->shipped->id) + ".apng";
    one["frames"] = options.frames;
    one["turn_s"] = study->shipped->turn_s;
    scenes.push_back(one);
  }
  return {{"selvage", selvage_version()},
          {"repetitions", options.timing.repetitions},
          {"choices", choices},
          {"scenes", scenes}};
}

[[nodiscard]] std::string text_of(const std::optional<Spread>& ns) {
  if (!ns) return "not timed";
  char text[64];
  std::snprintf(text, sizeof text, "%.2f %.2f-%.2f", ns->median, ns->lower_quartile,
                ns->upper_quartile);
  return text;
}

void print_table(const Studies& studies) {
  std::printf("%-8s %-8s %9s %10s %10s %10s %9s %9s %18s\n", "scene", "filter", "tolerance",
              "largest", "mean", "bound", "texels", "pixels", "ns/px of textured");
  for (const auto& study : studies) {
    for (const Trial& trial : study->trials) {
      std::printf("%-8s %-8s %9s %10.6f %10.6f %10.6f %9ju %9ju %18s\n",
                  std::string(study->shipped->id).c_str(), trial.filter.c_str(),
                  tolerance_name(trial.tolerance_texel).c_str(), trial.verdict.largest_texel,
                  trial.verdict.mean_texel(), trial.verdict.bound_texel,
                  uintmax_t{trial.verdict.wrong_texels}, uintmax_t{trial.different_px},
                  text_of(trial.textured_ns_per_px).c_str());
    }
  }
}

// Checked first, then timed: what breaks a promise is not.
[[nodiscard]] int run(const Options& options) {
  const cli::Console console{std::cout, std::cerr, isatty(STDERR_FILENO) != 0};
  cli::check_output(fs::path(options.output) / "scenes.json");
  Studies studies;
  std::vector<std::string> broken;
  {
    cli::StatusLine line(console);
    studies = draw_and_judge(options, line);
    broken = breaches(studies);
    for (const auto& study : studies) animate(options, *study, line);
    if (broken.empty()) measure(studies, options.timing, line);
  }
  const Json all = document(studies, options);
  cli::write_text_file(fs::path(options.output) / "scenes.json", all.dump(1) + "\n");
  for (const auto& [name, text] : plot_data(all))
    cli::write_text_file(fs::path(options.output) / name, text);
  print_table(studies);
  for (const std::string& one : broken)
    std::fprintf(stderr, "selvage_scenes: BROKEN: %s\n", one.c_str());
  return broken.empty() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Draws the scenes that come with selvage within tolerances of 0, 1/16, 1/4, 1 and 4 texels, "
      "holds every pixel against the exact model (measured error <= derived bound <= tolerance), "
      "then times the drawings, interleaved. Writes pictures, animations, overlays of the "
      "planner's "
      "choices, the data of the plots and scenes.json.");
  app.footer(
      "Example:\n"
      "  selvage_scenes --shipped src/scene/shipped --output out\n\n"
      "Exit codes: 0 all promises are kept, 1 one is broken (nothing is timed then), 2 wrong use "
      "or "
      "a bad file.");
  Options options;
  app.add_option("--shipped", options.shipped, "folder of the scenes")->required();
  app.add_option("--output", options.output, "existing folder for all that is written")->required();
  app.add_option("--size", options.size, "of the pictures and animations")->capture_default_str();
  app.add_option("--frames", options.frames, "of each animation, over one turn")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  app.add_option("--repetitions", options.timing.repetitions, "of each timing")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  app.add_option("--min-time", options.timing.min_time_s, "of one repetition, s")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  try {
    app.parse(argc, argv);
    return run(options);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const cli::UserError& error) {
    std::fprintf(stderr, "selvage_scenes: %s\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "selvage_scenes: %s\n", error.what());
    return 1;
  }
}
