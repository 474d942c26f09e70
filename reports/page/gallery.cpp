// The pictures beside the model's.
#include "reports/page/html.h"
#include "reports/page/sections.h"

namespace selvage::reports {

namespace {

using json = nlohmann::ordered_json;

std::string picture(const json& scene, const std::string& kind, const std::string& caption) {
  const auto id = scene.at("id").get<std::string>();
  const std::string size =
      "width=" + scene.at("width_px").dump() + " height=" + scene.at("height_px").dump();
  const std::string alt = escaped(scene.at("title").get<std::string>()) + ", " + caption;
  return element("figure", "<img src=\"" + escaped(id) + "-" + kind + ".png\" " + size + " alt=\"" +
                               alt + "\">" + element("figcaption", caption));
}

std::string verdict(const json& scene) {
  const auto differing = scene.at("differing_px").get<uint64_t>();
  const std::string counts = grouped(scene.at("covered_px").get<uint64_t>()) +
                             " pixels covered by " + grouped(scene.at("polygons").get<uint64_t>()) +
                             (scene.at("polygons") == 1 ? " polygon" : " polygons");
  const auto twice = scene.at("covered_twice_px").get<uint64_t>();
  const std::string overlap =
      twice == 0 ? ", none of them twice" : ", " + grouped(twice) + " of them twice";
  return counts + overlap + "; " +
         element("strong", grouped(differing) + " differ from the model",
                 differing == 0 ? "class=good" : "class=bad");
}

}  // namespace

std::string gallery_section(const Results& results) {
  std::string html =
      element("h2", "The gallery", "id=gallery") +
      element(
          "p",
          "Pictures of the Debian package <code>xplanet-images</code> (a map of the Earth, "
          "spacecraft) and a made checker, drawn by the mapper through its public call; beside "
          "each the same drawing by the exact model, which computes every pixel on its own in "
          "rational numbers; then where they differ: grey is drawn and equal, dark is not drawn "
          "by either, red is different.");
  for (const json& scene : results.gallery) {
    html += element("h3", escaped(scene.at("title").get<std::string>()));
    html +=
        element("p", escaped(scene.at("sentence").get<std::string>()) + " " + verdict(scene) + ".");
    html += element("div",
                    picture(scene, "drawn", "drawn by Selvage") +
                        picture(scene, "model", "the exact model") +
                        picture(scene, "difference", "difference"),
                    "class=three");
  }
  return html;
}

}  // namespace selvage::reports
