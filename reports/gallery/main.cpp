// selvage_gallery: draws the gallery, holds each picture against the exact model, tells in JSON.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/error.h"
#include "cli/file.h"
#include "cli/png.h"
#include "cli/status_line.h"
#include "reports/gallery/banner.h"
#include "reports/gallery/draw.h"
#include "reports/gallery/scenes.h"

namespace {

using namespace selvage;
using namespace selvage::reports;
using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

// Draws, compares, writes the three pictures of a scene.
Json show(const Scene& scene, const fs::path& output) {
  const cli::Raster drawn = draw_by_mapper(scene);
  const ModelDrawing model = draw_by_model(scene);
  const Difference difference = compare(drawn, model);
  cli::write_file(output / (scene.id + "-drawn.png"), cli::encode_png(drawn));
  cli::write_file(output / (scene.id + "-model.png"), cli::encode_png(model.picture));
  cli::write_file(output / (scene.id + "-difference.png"), cli::encode_png(difference.map));
  return {{"id", scene.id},
          {"title", scene.title},
          {"sentence", scene.sentence},
          {"width_px", scene.width_px},
          {"height_px", scene.height_px},
          {"polygons", scene.polygons.size()},
          {"covered_px", difference.covered_px},
          {"covered_twice_px", difference.covered_twice_px},
          {"differing_px", difference.differing_px}};
}

// Writes gallery.json last. Returns the number of scenes that differ from the model.
int draw_gallery(const Pictures& pictures, const fs::path& output) {
  const cli::Console console{std::cout, std::cerr, isatty(STDERR_FILENO) != 0};
  const std::vector<Scene> all = scenes(pictures);
  int wrong = 0;
  Json document = Json::array();
  {
    cli::StatusLine line(console);
    for (const Scene& scene : all) {
      line.count("drawing and comparing: picture", document.size() + 1, all.size());
      document.push_back(show(scene, output));
      wrong += document.back()["differing_px"] != 0;
    }
  }
  const std::string text = document.dump(1) + "\n";
  cli::write_file(output / "gallery.json",
                  {reinterpret_cast<const uint8_t*>(text.data()), text.size()});
  for (const Json& scene : document) {
    std::printf("%-12s %6zu polygons %7lu px %3lu differ from the model\n",
                scene["id"].get<std::string>().c_str(), scene["polygons"].get<size_t>(),
                scene["covered_px"].get<uint64_t>(), scene["differing_px"].get<uint64_t>());
  }
  return wrong;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Draws the gallery from real pictures and compares each drawing with the exact model.");
  app.footer(
      "Examples:\n"
      "  selvage_gallery --pictures /usr/share/xplanet/images --output out\n"
      "  selvage_gallery --pictures /usr/share/xplanet/images --banner reports/selvage.png\n\n"
      "Exit codes: 0 all pictures equal the model's, 1 one differs, 2 wrong use or a bad file.");
  std::string pictures_path, output_path, banner_path;
  app.add_option("--pictures", pictures_path,
                 "folder of the pictures of the package xplanet-images")
      ->required();
  app.add_option("--output", output_path, "existing folder for the gallery and gallery.json");
  app.add_option("--banner", banner_path, "PNG file for the picture of the front page");
  app.require_option(2, 0);
  try {
    app.parse(argc, argv);
    const Pictures pictures = load_pictures(pictures_path);
    if (!banner_path.empty()) cli::write_file(banner_path, cli::encode_png(draw_banner(pictures)));
    return !output_path.empty() && draw_gallery(pictures, output_path) > 0 ? 1 : 0;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const cli::UserError& error) {
    std::fprintf(stderr, "selvage_gallery: %s\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "selvage_gallery: %s\n", error.what());
    return 1;
  }
}
