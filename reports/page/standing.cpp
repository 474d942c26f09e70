// Where the exact mapper stands on each work item: by the limits, and by the fastest of the others.
#include <algorithm>
#include <vector>

#include "reports/page/html.h"
#include "reports/page/measurements.h"
#include "reports/page/plots.h"

namespace selvage::reports {

namespace {

using json = nlohmann::ordered_json;

double median_of(const json& result) { return result.at("ns_per_px").at("median").get<double>(); }

std::string cell(const std::string& html) { return element("td", html, "class=n"); }

std::string ratio_cell(const json& exact, const json* limit) {
  return cell(limit == nullptr ? "&ndash;" : rounded(median_of(exact) / median_of(*limit)));
}

// Of the mappers of other projects that draw the item; null where none does.
const json* fastest_peer(const json& bench, const json& work) {
  const json* fastest = nullptr;
  for (const json& subject : bench.at("subjects")) {
    if (subject.at("group") != "peers") continue;
    const json* result = result_of(work, subject.at("id").get<std::string>());
    if (result != nullptr && (fastest == nullptr || median_of(*result) < median_of(*fastest)))
      fastest = result;
  }
  return fastest;
}

std::string row(const json& bench, const json& work) {
  const json* exact = result_of(work, "exact");
  if (exact == nullptr) return {};
  std::string cells = element("th", escaped(work.at("id").get<std::string>()), "scope=row") +
                      cell(rounded(median_of(*exact)) + " ns");
  for (const char* limit : {"fill", "inexact"}) cells += ratio_cell(*exact, result_of(work, limit));
  const json* peer = fastest_peer(bench, work);
  if (peer == nullptr) return element("tr", cells + cell("&ndash;") + cell("&ndash;"));
  return element("tr", cells +
                           cell(escaped(peer->at("id").get<std::string>()) + ", " +
                                rounded(median_of(*peer)) + " ns") +
                           cell(rounded(median_of(*peer) / median_of(*exact))));
}

}  // namespace

std::string standing_part(const json& bench) {
  std::string rows;
  for (const json& work : bench.at("workloads")) {
    if (!is_adversarial(bench, work)) rows += row(bench, work);
  }
  if (rows.empty()) return {};
  return element("h3", "What exactness costs") +
         element("p",
                 "The exact mapper by a solid fill of the same pixels, and by a vector loop of its "
                 "own kind that takes roundings as they come; and the fastest mapper of another "
                 "project, errors and all, by the exact one.") +
         element("div",
                 element("table",
                         "<tr><th>item<th class=n>exact<th class=n>&divide; fill"
                         "<th class=n>&divide; inexact<th class=n>fastest peer"
                         "<th class=n>peer &divide; exact</tr>\n" +
                             rows),
                 "class=wide");
}

}  // namespace selvage::reports
