// The page of one violation.
#include <cstdio>
#include <string>

#include "reports/page/html.h"
#include "reports/page/matrix.h"
#include "reports/page/sections.h"
#include "spec/case.h"
#include "spec/fan.h"

namespace selvage::reports {

namespace {

using json = nlohmann::ordered_json;

std::string line(const char* what, const std::string& html) {
  return html.empty() ? "" : element("tr", element("th", what, "scope=row") + element("td", html));
}

// The drawing in which it was seen.
struct Drawing {
  std::string text;       // in pixels and texels
  bool is_a_fan = false;  // drawn in tiles
};

std::string print(const selvage_vertex& centre) {
  const auto px = [](int32_t fx8) {
    if (fx8 % SELVAGE_SUBPIXELS == 0) return std::to_string(fx8 / SELVAGE_SUBPIXELS);
    return json(fx8 / static_cast<double>(SELVAGE_SUBPIXELS)).dump();
  };
  return "(" + px(centre.x) + ", " + px(centre.y) + ")";
}

Drawing drawing_of(const json& cell) {
  const json& violation = cell.at("violation");
  const std::optional<spec::Case> shown =
      spec::from_hex(violation.at("shown_case").get<std::string>());
  if (!shown) return {};
  Drawing drawing{.text = spec::print(*shown)};
  const json pixel = violation.value("pixel_px", json::array({-1, -1}));
  const auto centre = spec::fan_centre(cell.at("law").get<std::string>(), *shown,
                                       pixel[0].get<int32_t>(), pixel[1].get<int32_t>());
  if (!centre) return drawing;
  drawing.text += "\ndrawn in tiles: triangles from " + print(*centre) + " px to each side";
  drawing.is_a_fan = true;
  return drawing;
}

std::string picture_of(const json& violation, const Drawing& drawing) {
  if (!violation.contains("picture"))
    return element("p", "No picture: none would show what is wrong.");
  const std::string file = escaped(violation["picture"].get<std::string>());
  const std::string counts =
      "; blue is drawn by one tile, yellow by two, white by more, grey by none";
  return element("figure",
                 "<img class=enlarged src=\"" + file + "\" alt=\"drawn, expected, difference\">" +
                     element("figcaption",
                             "drawn | expected | difference" + (drawing.is_a_fan ? counts : "")));
}

std::string found_by(const json& violation) {
  const auto by = violation.value("found_by", "random");
  if (by == "corpus") return "known before, and tried first";
  return (by == "hunt" ? "in hunted case " : "in case ") + violation.at("case_number").dump() +
         " from the seed on, then shrunk";
}

// "0.25 texel in u, 0 in v", or how far the outline is.
std::string off_by(const json& violation) {
  const auto digits = [](const json& number) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", number.get<double>());
    return std::string(text);
  };
  if (violation.contains("off_by_px")) return digits(violation["off_by_px"]) + " px, the outline";
  if (!violation.contains("off_by_texel")) return {};
  const json& texels = violation["off_by_texel"];
  return digits(texels.at("u")) + " texel in u, " + digits(texels.at("v")) + " in v";
}

std::string facts(const json& matrix, const json& cell) {
  const json& violation = cell.at("violation");
  const auto text = [&](const char* key) { return escaped(violation.value(key, std::string())); };
  std::string pixel;
  if (violation.contains("pixel_px"))
    pixel = "(" + violation["pixel_px"][0].dump() + ", " + violation["pixel_px"][1].dump() + ")";
  std::string notes;
  for (const json& note : violation.value("notes", json::array()))
    notes += line("note", escaped(note.get<std::string>()));
  return element(
      "table",
      line("law", escaped(statement_of(matrix.at("laws"), cell.at("law").get<std::string>()))) +
          line("what", text("what")) + line("pixel", pixel) + line("sample", text("sample")) +
          line("exact u", text("u_texel")) + line("exact v", text("v_texel")) +
          line("off by", off_by(violation)) + line("allowed", text("allowed")) +
          line("drawn", text("drawn")) + line("found", found_by(violation)) + notes);
}

std::string replay_of(const json& cell) {
  const std::string line =
      element("pre", escaped(cell.at("violation").at("replay").get<std::string>()), "class=replay");
  if (!cell.contains("finding") || !cell["finding"].value("varies", false)) return line;
  return line + element("p",
                        "What it shows is memory of others, which may look right: by itself the "
                        "case can hold.");
}

std::string finding_of(const json& cell) {
  if (!cell.contains("finding")) {
    return element("p",
                   "Nobody has examined this violation yet. It may be a convention of the mapper's "
                   "own, or a defect.");
  }
  const json& finding = cell["finding"];
  std::string text = element("strong", escaped(finding.at("kind").get<std::string>())) + ": " +
                     escaped(finding.at("text").get<std::string>());
  if (!finding.contains("source")) return element("p", text);
  return element("p", text) +
         element("p", element("small", "Source: " + escaped(finding["source"].get<std::string>())));
}

}  // namespace

std::string counterexample_page(const json& matrix, const json& subject, const json& cell) {
  const json& violation = cell.at("violation");
  const auto name = subject.at("subject").get<std::string>();
  const std::string title = escaped(name + ": " + cell.at("law").get<std::string>());
  const Drawing drawing = drawing_of(cell);
  std::string body = element("p", element("a", "the matrix", "href=\"../index.html#matrix\"")) +
                     element("h2", title) + finding_of(cell) + facts(matrix, cell) +
                     picture_of(violation, drawing) + element("h3", "The drawing") +
                     element("pre", escaped(drawing.text)) +
                     element("h3", "To see it again, from the checkout") + replay_of(cell);
  if (subject.contains("convention"))
    body += element("h3", "What " + escaped(name) + " follows") +
            element("p", escaped(subject["convention"].get<std::string>()));
  return document(title, body);
}

}  // namespace selvage::reports
