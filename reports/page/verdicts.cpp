// The table of laws.
#include <filesystem>

#include "reports/page/html.h"
#include "reports/page/sections.h"

namespace selvage::reports {

namespace {

using json = nlohmann::ordered_json;

std::string class_of(const std::string& verdict) {
  if (verdict == "holds") return "class=good";
  return verdict == "not judged" ? "class=quiet" : "class=bad";
}

// What was seen, under the row of a law that does not hold.
std::string violation_row(const json& violation) {
  const auto text = [&](const char* key) { return escaped(violation.value(key, std::string())); };
  std::string seen = text("what");
  if (!seen.empty() && seen.back() != '.') seen += '.';
  if (violation.contains("pixel_px")) {
    seen += " Pixel (" + violation["pixel_px"][0].dump() + ", " + violation["pixel_px"][1].dump() +
            "), u = " + text("u_texel") + ", v = " + text("v_texel") + ".";
  }
  seen += " Allowed: " + text("allowed") + "; drawn: " + text("drawn") + ".";
  return element(
      "tr", element("td", seen + "<br>" + element("code", text("replay")), "colspan=5 class=seen"));
}

}  // namespace

std::string statement_of(const json& laws, const std::string& name) {
  for (const json& law : laws) {
    if (law.at("law") == name) return law.at("statement").get<std::string>();
  }
  return {};
}

std::string verdict_section(const Results& results) {
  std::string rows =
      "<tr><th>law<th>verdict<th>what it demands<th class=n>cases<th class=n>pixels judged</tr>\n";
  for (const json& law : results.verify.at("laws")) {
    const auto name = law.at("law").get<std::string>();
    const auto verdict = law.at("verdict").get<std::string>();
    rows +=
        element("tr", element("th", escaped(name), "scope=row") +
                          element("td", escaped(verdict), class_of(verdict)) +
                          element("td", escaped(statement_of(results.laws, name))) +
                          element("td", grouped(law.at("cases").get<uint64_t>()), "class=n") +
                          element("td", grouped(law.at("judged_px").get<uint64_t>()), "class=n"));
    if (law.contains("violation")) rows += violation_row(law["violation"]);
  }
  std::string missing;
  if (statement_of(results.laws, "ORACLE").empty()) {
    missing = element("p", "The law ORACLE is missing: the build found no OpenCV to compare with.",
                      "class=bad");
  }
  return element("h2", "The laws", "id=laws") +
         element("p",
                 "Each law was checked on cases made from the seeds from " +
                     results.verify.at("seed").dump() +
                     " on, biased to ties, slivers, degenerates and the ends of every "
                     "range. The counts are of single pixels (for TOTAL: of calls too) on which "
                     "the law had its say. The tolerance is zero. A law that fails stops at its "
                     "first violation and shows the shrunk case.") +
         element("div", element("table", rows), "class=wide") + missing;
}

}  // namespace selvage::reports
