// Each work item: what is drawn, its table, its plot.
#include <algorithm>

#include "reports/page/html.h"
#include "reports/page/measurements.h"
#include "reports/page/plots.h"

namespace selvage::reports {

namespace {

using json = nlohmann::ordered_json;

constexpr int kColumns = 11;

std::string ratio_cell(const json& result, const char* key) {
  return number_cell(result.at(key).is_null() ? "&ndash;" : rounded(result[key].get<double>()));
}

std::string count_cell(const json& result, const char* key) {
  return number_cell(result.at(key).is_null() ? "&ndash;" : grouped(result[key].get<uint64_t>()));
}

std::string subject_row(const json& result, bool filtered) {
  const std::string name = element("th", escaped(result.at("id").get<std::string>()), "scope=row");
  if (result.contains("refusal")) {
    return element(
        "tr", name + element("td", "not measured: " + escaped(result["refusal"].get<std::string>()),
                             "colspan=" + std::to_string(kColumns - 1)));
  }
  const json& time = result.at("ns_per_px");
  std::string cells = number_cell(rounded(time.at("median").get<double>())) +
                      number_cell(rounded(time.at("lower_quartile").get<double>()) + " to " +
                                  rounded(time.at("upper_quartile").get<double>()));
  for (const char* key : {"ratio_to_fill", "ratio_to_exact"}) cells += ratio_cell(result, key);
  for (const char* key : {filtered ? "wrong_colours" : "wrong_texels", "missing_px", "extra_px",
                          "double_px", filtered ? "largest_level" : "largest_texel"})
    cells += count_cell(result, key);
  const json& mean = result.at(filtered ? "mean_level" : "mean_texel");
  cells += number_cell(mean.is_null() ? "&ndash;"
                       : mean == 0.0  ? "0"
                                      : rounded(mean.get<double>()));
  return element("tr", name + cells);
}

std::string work_table(const json& work) {
  const bool filtered = work.at("filter") != "nearest";
  const std::string unit = filtered ? ", levels" : ", texels";
  std::string rows =
      "<tr><th>subject<th class=n>ns/px<th class=n>quartiles<th class=n>&divide; fill"
      "<th class=n>&divide; exact<th class=n>" +
      std::string(filtered ? "wrong colours" : "wrong texels") +
      "<th class=n>missing<th class=n>extra<th class=n>double<th class=n>largest" + unit +
      "<th class=n>mean" + unit + "</tr>\n";
  for (const json& result : work.at("results")) rows += subject_row(result, filtered);
  return element("div", element("table", rows), "class=wide");
}

std::string sample(const json& work) {
  for (const json& result : work.at("results")) {
    if (result.contains("refusal") || result.at("judged_px").is_null()) continue;
    return " Errors are counted on the " + grouped(result["judged_px"].get<uint64_t>()) +
           " pixels of the sampled rows, of which " +
           grouped(result["covered_px"].get<uint64_t>()) + " are covered.";
  }
  return {};
}

std::string work_item(const json& work) {
  const auto id = work.at("id").get<std::string>();
  const std::string text = "Drawn: " + escaped(work.at("description").get<std::string>()) +
                           ". It covers " + grouped(work.at("covered_px").get<uint64_t>()) +
                           " pixels of a target of " +
                           escaped(work.at("target_px").get<std::string>()) + "." + sample(work);
  return element("h3", escaped(id) + ": " + escaped(work.at("title").get<std::string>())) +
         element("p", text) + work_table(work);
}

std::string plane(const json& work) {
  const auto& results = work.at("results");
  if (!std::any_of(results.begin(), results.end(), has_errors)) return {};
  const auto id = work.at("id").get<std::string>();
  return plot_figure(
      id + ".svg", id + ", time against errors", 420,
      element("strong", escaped(id)) + ": " + escaped(work.at("title").get<std::string>()));
}

}  // namespace

std::string work_items_part(const json& bench) {
  std::string planes, tables;
  for (const json& work : bench.at("workloads")) {
    if (is_adversarial(bench, work)) continue;
    planes += plane(work);
    tables += work_item(work);
  }
  if (tables.empty()) return {};
  return element("h3", "The plane of speed and error") +
         element("p",
                 "The bars are the quartiles, the dashed grey lines the limits; the stepped line "
                 "is the Pareto front: below and left of it is nothing that was measured. Points "
                 "without errors stand side by side at the left.") +
         element("div", planes, "class=plots") +
         element("p",
                 "And as tables. Largest and mean are the distance of a drawn texel from the right "
                 "one, in whole texels; of a filtered colour that of its worst channel, in levels "
                 "of 255, and only colours that are off by more than one level count as wrong: "
                 "other mappers weigh texels by other formulas. Double are pixels that two "
                 "polygons draw, found by drawing polygons that are near each other one after the "
                 "other on empty targets.") +
         tables;
}

}  // namespace selvage::reports
