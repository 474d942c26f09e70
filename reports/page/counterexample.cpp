// The page of one violation.
#include "reports/page/html.h"
#include "reports/page/matrix.h"
#include "reports/page/sections.h"
#include "spec/case.h"

namespace selvage::reports {

namespace {

using json = nlohmann::ordered_json;

std::string line(const char* what, const std::string& html) {
  return html.empty() ? "" : element("tr", element("th", what, "scope=row") + element("td", html));
}

std::string statement_of(const json& matrix, const json& cell) {
  for (const json& law : matrix.at("laws")) {
    if (law.at("law") == cell.at("law")) return escaped(law.at("statement").get<std::string>());
  }
  return {};
}

// The drawing in which it was seen, in pixels and texels.
std::string drawing_of(const json& violation) {
  const std::optional<spec::Case> shown =
      spec::from_hex(violation.at("shown_case").get<std::string>());
  return shown ? element("pre", escaped(spec::print(*shown))) : "";
}

std::string found_by(const json& violation) {
  const auto by = violation.value("found_by", "random");
  if (by == "corpus") return "known before, and tried first";
  return (by == "hunt" ? "in hunted case " : "in case ") + violation.at("case_number").dump() +
         " from the seed on, then shrunk";
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
  return element("table", line("law", statement_of(matrix, cell)) + line("what", text("what")) +
                              line("pixel", pixel) + line("sample", text("sample")) +
                              line("exact u", text("u_texel")) + line("exact v", text("v_texel")) +
                              line("allowed", text("allowed")) + line("drawn", text("drawn")) +
                              line("found", found_by(violation)) + notes);
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
  if (finding.contains("source"))
    text += " " + element("small", escaped(finding["source"].get<std::string>()));
  return element("p", text);
}

}  // namespace

std::string counterexample_page(const json& matrix, const json& subject, const json& cell) {
  const json& violation = cell.at("violation");
  const auto name = subject.at("subject").get<std::string>();
  const std::string title = escaped(name + ": " + cell.at("law").get<std::string>());
  std::string picture = element("p", "No picture: it takes several drawings to see this.");
  if (violation.contains("picture")) {
    const std::string file = escaped(violation["picture"].get<std::string>());
    picture = element("figure", "<img class=enlarged src=\"" + file +
                                    "\" alt=\"drawn, expected, difference\">" +
                                    element("figcaption", "drawn | expected | difference"));
  }
  std::string body = element("p", element("a", "the matrix", "href=\"../index.html#matrix\"")) +
                     element("h2", title) + finding_of(cell) + facts(matrix, cell) + picture +
                     element("h3", "The drawing") + drawing_of(violation) +
                     element("h3", "To see it again") +
                     element("pre", escaped(violation.at("replay").get<std::string>()));
  if (subject.contains("convention"))
    body += element("h3", "What " + escaped(name) + " follows") +
            element("p", escaped(subject["convention"].get<std::string>()));
  return document(title, body);
}

}  // namespace selvage::reports
