// The stability table: hard families x arithmetics, and the worst cases as pictures.
#include <cmath>
#include <optional>

#include "reports/page/html.h"
#include "reports/page/sections.h"
#include "reports/page/worst_cases.h"

namespace selvage::reports {

namespace {

using json = nlohmann::ordered_json;

std::string arithmetic_name(const json& arithmetic) {
  return arithmetic.at("arithmetic").get<std::string>();
}

std::string share(const json& cell) {
  const double percent = 100 * cell.at("wrong_share").get<double>();
  if (percent == 0) return "0";
  if (percent < 0.001) return "&lt; 0.001&nbsp;%";
  if (percent < 100 && percent > 99.95) return "&gt; 99.9&nbsp;%";
  return rounded(percent) + "&nbsp;%";
}

// What a cell holds beside its share of wrong texels, a line each; nothing where nothing is wrong.
std::string details(const json& cell) {
  std::string lines;
  const auto add = [&](const std::string& line) { lines += "<br>" + line; };
  if (cell.at("wrong_texels") != 0) {
    add("max " + grouped(cell.at("largest_texel").get<uint64_t>()));
    const double mean = cell.at("mean_texel").get<double>();
    add("mean " + (mean < 0.001 ? std::string("&lt; 0.001") : rounded(mean)));
  }
  if (cell.at("missing_px") != 0) add(grouped(cell["missing_px"].get<uint64_t>()) + " missing");
  if (cell.at("extra_px") != 0) add(grouped(cell["extra_px"].get<uint64_t>()) + " extra");
  if (cell.at("missing_px") != 0 || cell.at("extra_px") != 0) {
    const double off_px = cell.at("largest_outline_px").get<double>();
    add("outline off " + (off_px < 0.001 ? std::string("&lt; 0.001") : rounded(off_px)) + " px");
  }
  if (cell.contains("refused_cases")) add(cell["refused_cases"].dump() + " refused");
  if (cell.contains("memory_fault")) add(escaped(cell["memory_fault"].get<std::string>()));
  return lines.empty() ? lines : element("small", lines);
}

std::string bound(const json& cell) {
  if (!cell.contains("part_of_bound")) return {};
  const json& part = cell["part_of_bound"];
  const bool within = part.is_number() && part.get<double>() <= 1;
  char text[32] = "above 1";
  if (within) std::snprintf(text, sizeof text, "%.3f", part.get<double>());
  return "<br>" +
         element("small", std::string(text) + " of bound", within ? "class=good" : "class=bad");
}

std::string table_cell(const json& cell) {
  std::string attributes = "class=n";
  if (cell.contains("worst")) {
    attributes +=
        " title=\"worst: " + escaped(cell["worst"].at("command").get<std::string>()) + "\"";
  }
  const bool flawless =
      cell.at("wrong_texels") == 0 && cell.at("missing_px") == 0 && cell.at("extra_px") == 0;
  const char* colour = !cell.at("kept").get<bool>() ? "class=bad" : flawless ? "class=good" : "";
  return element("td", element("strong", share(cell), colour) + details(cell) + bound(cell),
                 attributes);
}

std::string command_of(const json& run, const json& family) {
  return "build/selvage stability --family " + family.at("family").get<std::string>() + " --seed " +
         run.at("seed").dump() + " --cases " + run.at("cases").dump();
}

std::string family_row(const json& run, const json& family) {
  std::string row =
      element("th",
              escaped(family.at("family").get<std::string>()) + "<br>" +
                  element("small", escaped(family.at("reason").get<std::string>()) + "<br>" +
                                       grouped(family.at("covered_px").get<uint64_t>()) +
                                       " pixels covered.<br>" +
                                       element("code", escaped(command_of(run, family)))),
              "scope=row class=reason");
  for (const json& cell : family.at("cells")) row += table_cell(cell);
  return element("tr", row);
}

std::string stability_table(const json& run) {
  std::string head = "<tr><th>family";
  for (const json& arithmetic : run.at("arithmetics"))
    head += "<th class=n>" + escaped(arithmetic_name(arithmetic));
  std::string rows = head + "</tr>\n";
  for (const json& family : run.at("families")) rows += family_row(run, family);
  return element("div", element("table", rows, "class=stability"), "class=wide");
}

std::string arithmetics(const json& run) {
  std::string list;
  for (const json& arithmetic : run.at("arithmetics")) {
    list += element("li", element("strong", escaped(arithmetic_name(arithmetic))) + ": " +
                              escaped(arithmetic.at("statement").get<std::string>()) + ".");
  }
  return element("ul", list);
}

std::string how_wrong(uint64_t largest_texel) {
  if (largest_texel == 0) return "pixels missing or extra";
  return "off by " + grouped(largest_texel) + (largest_texel == 1 ? " texel" : " texels");
}

std::string pictures(const json& run) {
  std::string html;
  for (const WorstCase& worst : worst_cases(run)) {
    const std::string caption = escaped(worst.family + " by " + worst.arithmetic) + ": " +
                                how_wrong(worst.largest_texel) + ".<br>" +
                                element("code", escaped(worst.command));
    html += element("figure", "<img loading=lazy src=\"" + escaped(worst.picture) + "\" alt=\"" +
                                  escaped(worst.family + " by " + worst.arithmetic) +
                                  ": drawn, exact, difference\">" + element("figcaption", caption));
  }
  if (html.empty()) return html;
  return element("h3", "Worst cases") +
         element("p",
                 "Of each family the scene with the largest texel error of any arithmetic that can "
                 "draw it as it is, without rounding it to whole pixels or dropping q: drawn, "
                 "exact, difference, about the worst pixel, which is framed. Where "
                 "texels differ they are the brighter the further off they are, in the logarithm, "
                 "from dark red for one texel; blue is missing, green is extra.") +
         element("div", html, "class=worst");
}

}  // namespace

std::string stability_section(const Results& results) {
  const json& run = results.stability;
  return element("h2", "Stability", "id=stability") +
         element("p",
                 "What is left of the exact picture where numbers are hard: families of scenes, "
                 "each hard for one reason, drawn by each arithmetic; " +
                     run.at("cases").dump() + " scenes of a family, from seed " +
                     run.at("seed").dump() +
                     " on. A cell holds the share of wrong texels among the pixels that both draw, "
                     "the largest and the mean error in texels, the missing and the extra pixels, "
                     "and, where a bound on the error is derived, how much of it was used. The "
                     "line in a family measures it again; the worst scene is in the cell's "
                     "tooltip.") +
         element("p", escaped(run.at("notes").get<std::string>())) + arithmetics(run) +
         stability_table(run) + pictures(run);
}

}  // namespace selvage::reports
