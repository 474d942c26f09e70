// Speed against error.
#include "reports/page/measurements.h"

#include "reports/page/html.h"
#include "reports/page/plots.h"
#include "reports/page/sections.h"

namespace selvage::reports {

namespace {

using json = nlohmann::ordered_json;

// Why the work item was not measured.
std::string refusal_of(const json& work, const std::string& subject) {
  for (const json& result : work.at("results")) {
    if (result.at("id") == subject) return result.value("refusal", "");
  }
  return {};
}

std::string overview_cell(const json& work, const std::string& subject) {
  const json* result = result_of(work, subject);
  if (result == nullptr) {
    return element("td", "&ndash;", "class=n title=\"" + escaped(refusal_of(work, subject)) + "\"");
  }
  const std::string time = rounded(result->at("ns_per_px").at("median").get<double>()) + " ns";
  if (!has_errors(*result)) return element("td", time, "class=n");
  const double errors = errors_per_million(*result);
  return element("td",
                 time + "<br>" +
                     element("small", errors == 0 ? "no errors" : error_share(*result),
                             errors == 0 ? "class=good" : ""),
                 "class=n");
}

// A row a subject, a column a work item: time, and errors per million pixels.
std::string overview(const json& bench) {
  std::string head = "<tr><th>subject";
  for (const json& work : bench.at("workloads")) {
    if (!is_adversarial(bench, work))
      head += "<th class=n title=\"" + escaped(work.at("title").get<std::string>()) + "\">" +
              escaped(work.at("id").get<std::string>());
  }
  std::string rows = head + "</tr>\n";
  for (const json& subject : bench.at("subjects")) {
    const auto id = subject.at("id").get<std::string>();
    std::string row = element("th", escaped(id), "scope=row");
    for (const json& work : bench.at("workloads")) {
      if (!is_adversarial(bench, work)) row += overview_cell(work, id);
    }
    rows += element("tr", row);
  }
  return element("div", element("table", rows), "class=wide");
}

std::string subjects(const json& bench) {
  std::string list;
  for (const json& subject : bench.at("subjects")) {
    list += element("li", element("strong", escaped(subject.at("id").get<std::string>())) + " (" +
                              escaped(subject.at("title").get<std::string>()) + "): " +
                              escaped(subject.at("configuration").get<std::string>()) + ".");
  }
  for (const json& sentence : bench.at("unavailable"))
    list += element("li", "Not there: " + escaped(sentence.get<std::string>()) + ".", "class=bad");
  return element(
      "details",
      element("summary", "What was measured, and how each is configured") + element("ul", list),
      "open");
}

std::string speed_introduction(const json& bench) {
  return element(
      "p",
      "Nanoseconds per covered pixel, the median of " + bench.at("repetitions").dump() +
          " interleaved repetitions in one run, with the quartiles: processor time on one thread, "
          "which "
          "other programs do not change by taking turns. Errors are counted against the "
          "exact model on " +
          bench.at("rows").dump() +
          " rows of each target, one in each equal band, placed by the seed: wrong texels (where "
          "they are filtered, colours off by more than a "
          "level of 255), and pixels missing, extra, or drawn by two polygons; % and ppm "
          "(millionths) are all of "
          "these by the covered pixels. Had the exact mapper differed from the model in one pixel "
          "of them, or "
          "one with a tolerance by more than that (of nearest: filtered, it is exact too), nothing "
          "would have been timed. All mappers read "
          "the same RGBA texture, its rows padded by 16 texels, and draw into the same memory; "
          "behind each of its rows are " +
          bench.at("padding_px").dump() +
          " px of padding, where every pixel drawn counts as extra. The "
          "limits are a solid fill of the same pixels, alone or with one load from each cache line "
          "of the texture that they need, and a memcpy of as many "
          "bytes. Where there is a dash, the item's table tells why.");
}

}  // namespace

std::string plot_figure(const std::string& svg, const std::string& alt, int height_px,
                        const std::string& caption) {
  return element("figure", "<img class=plot src=\"" + escaped(svg) + "\" width=660 height=" +
                               std::to_string(height_px) + " alt=\"" + escaped(alt) + "\">" +
                               (caption.empty() ? "" : element("figcaption", caption)));
}

std::string measurement_section(const Results& results) {
  std::string html = element("h2", "Speed against error", "id=speed");
  if (results.bench.is_null())
    return html + element("p", "Not measured: " + escaped(results.unmeasured), "class=bad");
  const json& bench = results.bench;
  return html + speed_introduction(bench) + overview(bench) + standing_part(bench) +
         subjects(bench) + comparison_part(bench) + work_items_part(bench) + curves_part(bench) +
         adversarial_part(bench);
}

}  // namespace selvage::reports
