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

std::string ratio_cell(const json& of, const json* by) {
  return number_cell(by == nullptr ? "&ndash;" : rounded(median_of(of) / median_of(*by)));
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

std::string time_cell(const json* result) {
  return number_cell(result == nullptr ? "&ndash;" : rounded(median_of(*result)) + " ns");
}

// A peer's time by ours; whoever draws a mesh gives it to us in one call.
std::string peer_cells(const json* peer, const json& exact, const json* in_one_call) {
  if (peer == nullptr)
    return number_cell("&ndash;") + number_cell("&ndash;") + number_cell("&ndash;");
  return number_cell(escaped(peer->at("id").get<std::string>()) + ", " + rounded(median_of(*peer)) +
                     " ns") +
         ratio_cell(*peer, &exact) + ratio_cell(*peer, in_one_call);
}

std::string item_row(const json& bench, const json& work) {
  const json* exact = result_of(work, "exact");
  if (exact == nullptr) return {};
  const json* in_one_call = result_of(work, "exact-many");
  std::string cells = element("th", escaped(work.at("id").get<std::string>()), "scope=row") +
                      time_cell(exact) + time_cell(in_one_call);
  for (const char* limit : {"fill", "inexact"}) cells += ratio_cell(*exact, result_of(work, limit));
  return element("tr", cells + peer_cells(fastest_peer(bench, work), *exact, in_one_call));
}

}  // namespace

std::string standing_part(const json& bench) {
  std::string rows;
  for (const json& work : bench.at("workloads")) {
    if (!is_adversarial(bench, work)) rows += item_row(bench, work);
  }
  if (rows.empty()) return {};
  return element("h3", "What exactness costs") +
         element("p",
                 "The exact mapper, in a call a polygon and in one call for all of them, on one "
                 "thread; by a solid fill of the same pixels, and by a vector loop of its own kind "
                 "that takes roundings as they come; and the fastest mapper of another project, "
                 "errors and all, by the exact one.") +
         element("div",
                 element("table",
                         "<tr><th>item<th class=n>exact<th class=n>in one call"
                         "<th class=n>&divide; fill<th class=n>&divide; inexact"
                         "<th class=n>fastest peer<th class=n>peer &divide; exact"
                         "<th class=n>&divide; one call</tr>\n" +
                             rows),
                 "class=wide");
}

}  // namespace selvage::reports
