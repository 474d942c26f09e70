// Near-ties, curves, and the comparison with the baseline.
#include <algorithm>
#include <map>

#include "reports/page/html.h"
#include "reports/page/measurements.h"
#include "reports/page/plots.h"

namespace selvage::reports {

namespace {

using json = nlohmann::ordered_json;

constexpr int kMostForNearTies = 6;  // times the ordinary cost: what the exact mapper may take

std::string coloured_cell(const std::string& html, const std::string& colour = "") {
  return element("td", html, "class=\"n" + (colour.empty() ? "" : " " + colour) + "\"");
}

std::vector<std::string> ids_of(const json& bench) {
  std::vector<std::string> ids;
  for (const json& subject : bench.at("subjects"))
    ids.push_back(subject.at("id").get<std::string>());
  return ids;
}

std::string near_tie_cell(const json* result, bool ours) {
  if (result == nullptr || result->at("ratio_to_ordinary").is_null())
    return coloured_cell("&ndash;");
  const double ratio = result->at("ratio_to_ordinary").get<double>();
  const bool errs = has_errors(*result) && errors_per_million(*result) > 0;
  const std::string wrong =
      errs ? "<br>" + element("small", error_share(*result) + " wrong") : std::string();
  const char* colour = !ours ? "" : ratio <= kMostForNearTies ? "good" : "bad";
  return coloured_cell(rounded(ratio) + wrong, colour);
}

std::map<std::string, std::map<std::string, double>> ratios_of(const json& comparison) {
  std::map<std::string, std::map<std::string, double>> ratios;
  for (const json& time : comparison.at("times")) {
    ratios[time.at("subject").get<std::string>()][time.at("item").get<std::string>()] =
        time.at("ratio").get<double>();
  }
  return ratios;
}

std::string other_padding(const json& then_px, const json& now_px) {
  if (then_px == now_px) return {};
  return " The rows of its targets were padded by " + then_px.dump() + " px, now by " +
         now_px.dump() + " px, which changes times.";
}

}  // namespace

bool is_adversarial(const json& bench, const json& work) {
  if (!work.at("ordinary").is_null()) return true;
  const json& all = bench.at("workloads");
  return std::any_of(all.begin(), all.end(),
                     [&](const json& other) { return other.at("ordinary") == work.at("id"); });
}

std::string adversarial_part(const json& bench) {
  std::vector<const json*> items;
  std::string list, head = "<tr><th>subject";
  for (const json& work : bench.at("workloads")) {
    if (work.at("ordinary").is_null()) continue;
    items.push_back(&work);
    const std::string id = escaped(work.at("id").get<std::string>());
    head += "<th class=n>" + id;
    list += element("li", id + ", " + escaped(work.at("title").get<std::string>()) + ": " +
                              escaped(work.at("description").get<std::string>()) + ".");
  }
  if (items.empty()) return {};
  std::string rows = head + "</tr>\n";
  for (const json& subject : bench.at("subjects")) {
    const auto id = subject.at("id").get<std::string>();
    std::string cells;
    bool measured = false;
    for (const json* work : items) {
      const json* result = result_of(*work, id);
      measured = measured || result != nullptr;
      cells += near_tie_cell(result, subject.at("group") == "ours");
    }
    if (measured) rows += element("tr", element("th", escaped(id), "scope=row") + cells);
  }
  return element("h3", "Near-ties everywhere") +
         element("p",
                 "Polygons made to be doubtful at every pixel, and what they cost: times the same "
                 "shape and slopes with its samples off the texels' boundaries. A mapper that "
                 "decides near-ties exactly must not become an attack: it may take " +
                     std::to_string(kMostForNearTies) + " times as long.") +
         element("ul", list) + element("div", element("table", rows), "class=wide");
}

std::string curves_part(const json& bench) {
  std::string figures;
  for (const json& curve : bench.at("curves")) {
    const auto id = curve.at("id").get<std::string>();
    const auto title = curve.at("title").get<std::string>();
    figures += plot_figure(id + ".svg", title, 400,
                           element("strong", escaped(title)) + ": " +
                               escaped(curve.at("description").get<std::string>()) + ".");
  }
  if (figures.empty()) return {};
  return element("h3", "Cost against one quantity") +
         element("p", "Median and quartiles; each point was held against the model too.") +
         element("div", figures, "class=plots");
}

std::string comparison_part(const json& bench) {
  const json& comparison = bench.at("comparison");
  if (comparison.is_null() || comparison.at("times").empty()) return {};
  auto ratios = ratios_of(comparison);
  std::vector<std::string> items;
  std::string head = "<tr><th>subject";
  for (const json& work : bench.at("workloads")) {
    items.push_back(work.at("id").get<std::string>());
    head += "<th class=n>" + escaped(items.back());
  }
  std::string rows = head + "</tr>\n";
  for (const std::string& id : ids_of(bench)) {
    if (ratios[id].empty()) continue;
    std::string cells;
    for (const std::string& item : items)
      cells += coloured_cell(ratios[id].contains(item) ? rounded(ratios[id][item]) : "&ndash;");
    rows += element("tr", element("th", escaped(id), "scope=row") + cells);
  }
  const std::string about = "Times of this run over those of " +
                            escaped(comparison.at("baseline").get<std::string>()) + " (" +
                            escaped(comparison.at("date").get<std::string>()) + ", " +
                            escaped(comparison.at("cpu").get<std::string>()) + ", " +
                            escaped(comparison.at("compiler").get<std::string>()) +
                            "): below 1 is faster now. On another machine they compare machines." +
                            other_padding(comparison.at("padding_px"), bench.at("padding_px"));
  return element("details", element("summary", "Against the recorded baseline") +
                                element("p", about) +
                                element("div", element("table", rows), "class=wide"));
}

}  // namespace selvage::reports
