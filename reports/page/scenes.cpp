// The shipped scenes: pictures, what the planner chose, cost and error against tolerance.
#include "reports/page/scenes.h"

#include <stdexcept>

#include "reports/page/html.h"
#include "reports/page/measurements.h"
#include "reports/page/sections.h"

namespace selvage::reports {

namespace {

using json = nlohmann::ordered_json;

std::string size_of(const json& scene, int part) {
  return "width=" + std::to_string(scene.at("width_px").get<int>() / part) +
         " height=" + std::to_string(scene.at("height_px").get<int>() / part);
}

// The animation, or its still picture for those who want no motion.
std::string moving(const json& scene) {
  const std::string still = "<source media=\"(prefers-reduced-motion: reduce)\" srcset=\"" +
                            text_of(scene, "picture") + "\">";
  const std::string film = "<img src=\"" + text_of(scene, "animation") + "\" " + size_of(scene, 1) +
                           " alt=\"" + text_of(scene, "title") + ", turning\">";
  return element("figure",
                 element("picture", still + film) +
                     element("figcaption", "One turn, " + scene.at("frames").dump() +
                                               " frames: an animated PNG, exact, filter " +
                                               text_of(scene, "picture_filter")));
}

const json& style_of(const json& scenes, const json& choice) {
  for (const json& style : scenes.at("choices")) {
    if (style.at("id") == choice.at("id")) return style;
  }
  throw std::runtime_error("scenes.json: a choice without a style");
}

std::string swatch(const json& style) {
  return element("span", "", "class=swatch style=\"background:" + text_of(style, "colour") + "\"");
}

// In words and numbers, the most pixels first as they come.
std::string legend(const json& scenes, const json& trial) {
  std::string items;
  for (const json& choice : trial.at("choices")) {
    const json& style = style_of(scenes, choice);
    const auto faces = choice.at("faces").get<uint64_t>();
    items += element("li", swatch(style) + text_of(style, "title") + ": " +
                               grouped(choice.at("px").get<uint64_t>()) + " pixels of " +
                               grouped(faces) + (faces == 1 ? " face" : " faces"));
  }
  return element("ul", items, "class=legend");
}

// The one in which the planner has its way, within the scene's own tolerance.
const json& own_trial(const json& scene) {
  for (const json& trial : scene.at("trials")) {
    if (trial.at("filter") == "auto" && trial.at("tolerance") == scene.at("tolerance"))
      return trial;
  }
  return scene.at("trials").front();
}

std::string large_overlay(const json& scenes, const json& scene) {
  const json& trial = own_trial(scene);
  const std::string caption = "What each row of each face was drawn by within " +
                              text_of(trial, "tolerance") +
                              " texel, the filter left to the planner (auto)";
  return element("figure", "<img src=\"" + text_of(trial, "overlay") + "\" " + size_of(scene, 1) +
                               " alt=\"" + text_of(scene, "title") + ", in false colours\">" +
                               element("figcaption", caption + legend(scenes, trial)));
}

std::string small_overlays(const json& scenes, const json& scene, const std::string& filter) {
  std::string figures;
  for (const json& trial : scene.at("trials")) {
    if (trial.at("filter") != filter) continue;
    figures += element(
        "figure",
        "<img src=\"" + text_of(trial, "overlay") + "\" " + size_of(scene, 2) + " alt=\"" +
            text_of(scene, "title") + " within " + text_of(trial, "tolerance") +
            " texels, in false colours\">" +
            element("figcaption", "within " + element("strong", text_of(trial, "tolerance")) +
                                      " texels, " + escaped(filter) + legend(scenes, trial)));
  }
  return element("div", figures, "class=five");
}

std::string counts(const json& scene) {
  const auto number = [&](const char* key) { return grouped(scene.at(key).get<uint64_t>()); };
  const std::string shown =
      scene.at("faces_shown") == scene.at("faces_seen")
          ? "all show, at "
          : "the nearer ones leave " + number("faces_shown") + " to show, at ";
  return "Of " + number("faces") + " faces " + number("faces_from_behind") +
         " are turned away, and are neither drawn nor in the overlay; of the " +
         number("faces_seen") + " that face the eye " + shown + number("shown_px") + " pixels.";
}

std::string scene_part(const json& scenes, const json& scene) {
  const std::string small =
      element("h4", "The filter left to the planner") + small_overlays(scenes, scene, "auto") +
      element("h4", "All faces by filter nearest") + small_overlays(scenes, scene, "nearest");
  return element("h3", text_of(scene, "title")) +
         element("p", text_of(scene, "sentence") + " " + counts(scene)) +
         element("div", moving(scene) + large_overlay(scenes, scene), "class=two") +
         tolerance_remarks(scene) + tolerance_table(scene) +
         element("details",
                 element("summary", "The planner's choices within each tolerance") + small);
}

std::string scenes_introduction(const json& scenes) {
  return element(
      "p",
      "Scenes that come with Selvage: objects in motion, in perspective, hidden surfaces by scan "
      "lines. A planner draws each face by the cheapest mapping that it can prove to be within the "
      "scene&rsquo;s tolerance: affine for the whole face, or what the mapper chooses row by row "
      "(straight along the row, straight between divisions, or a division a pixel). Here each is "
      "drawn within five tolerances, twice: with the filter left to the planner (nearest where a "
      "face is magnified, area where it is minified), and with nearest for all. "
      "Every pixel is held against the exact model, hidden surfaces included, and must keep "
      "<em>measured &le; bound &le; tolerance</em>; only then are the drawings timed, " +
          scenes.at("repetitions").dump() +
          " repetitions of all of them interleaved at random. The time is that of the calls of "
          "<code>selvage_draw</code>: faces, light and what hides what are ready before.");
}

std::string plots(const json& scenes) {
  std::string figures;
  if (all_timed(scenes)) {
    figures += plot_figure("scenes-cost.svg", "Cost against tolerance", 400,
                           "Cost of the textured pixels: median and quartiles. Above with the area "
                           "filter where faces are minified, below all nearest.");
  }
  figures += plot_figure("scenes-error.svg", "Error against tolerance", 400,
                         "Error of the textured pixels: the largest, and the mean of all. The grey "
                         "bars are the tolerances.");
  return element("div", figures, "class=plots");
}

}  // namespace

std::string text_of(const json& values, const char* key) {
  return escaped(values.at(key).get<std::string>());
}

std::string scenes_head(const json& scenes) {
  if (scenes.is_null()) return {};
  std::string figures;
  for (const json& scene : scenes.at("scenes")) {
    figures += element("figure", "<img src=\"" + text_of(scene, "picture") + "\" " +
                                     size_of(scene, 1) + " alt=\"" + text_of(scene, "sentence") +
                                     "\">" + element("figcaption", text_of(scene, "title")));
  }
  return element("div", figures, "class=two");
}

std::string scenes_section(const json& scenes) {
  const std::string title = element("h2", "Scenes", "id=scenes");
  if (scenes.is_null()) {
    return title + element("p",
                           "Not drawn: the build found no Google Benchmark, or not the libraries "
                           "that scenes need (Eigen, tinyobjloader).",
                           "class=bad");
  }
  std::string html = title + scenes_introduction(scenes) + broken_promises(scenes) + plots(scenes);
  for (const json& scene : scenes.at("scenes")) html += scene_part(scenes, scene);
  return html + element("p", "All of this as a file: <a href=scenes.json>scenes.json</a>.");
}

}  // namespace selvage::reports
