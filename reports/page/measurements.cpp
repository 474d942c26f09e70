// Speed against error.
#include "reports/page/measurements.h"
#include "reports/page/html.h"
#include "reports/page/sections.h"

namespace selvage::reports {

namespace {

using json = nlohmann::ordered_json;

std::string cell(const std::string& html) { return element("td", html, "class=n"); }

std::string time_cells(const json& result) {
  const json& time = result.at("ns_per_px");
  return cell(rounded(time.at("median").get<double>())) +
         cell(rounded(time.at("lower_quartile").get<double>()) + " to " +
              rounded(time.at("upper_quartile").get<double>())) +
         cell(rounded(result.at("ratio_to_fill").get<double>()));
}

std::string row(const json& result) {
  const std::string name = element("th", escaped(result.at("id").get<std::string>()), "scope=row");
  if (result.contains("refusal")) {
    return element(
        "tr", name + element("td", "not measured: " + escaped(result["refusal"].get<std::string>()),
                             "colspan=6"));
  }
  const auto count = [&](const char* key) {
    return cell(result.at(key).is_null() ? "none drawn" : grouped(result[key].get<uint64_t>()));
  };
  return element("tr", name + time_cells(result) + count("wrong_texels") + count("missing_px") +
                           count("extra_px"));
}

std::string overview_cell(const json& result) {
  if (result.contains("refusal")) return cell("&ndash;");
  const std::string time = rounded(result.at("ns_per_px").at("median").get<double>()) + " ns";
  if (result.at("wrong_texels").is_null()) return cell(time);
  const double errors = errors_per_million(result);
  return cell(time + "<br>" +
              element("small", errors == 0 ? "exact" : rounded(errors) + " errors per million",
                      errors == 0 ? "class=good" : ""));
}

std::string work_item(const json& work) {
  std::string rows =
      "<tr><th>mapper<th class=n>ns per covered pixel<th class=n>quartiles<th class=n>times fill"
      "<th class=n>wrong texels<th class=n>missing<th class=n>extra</tr>\n";
  uint64_t judged = 0, covered = 0;
  for (const json& result : work.at("results")) {
    rows += row(result);
    judged = result.value("judged_px", judged);
    covered = result.value("covered_px", covered);
  }
  const auto id = work.at("id").get<std::string>();
  return element("h3", escaped(id) + ": " + escaped(work.at("title").get<std::string>())) +
         element("p", "Drawn: " + escaped(work.at("description").get<std::string>()) +
                          ". It covers " + grouped(work.at("covered_px").get<uint64_t>()) +
                          " pixels of a target of " +
                          escaped(work.at("target_px").get<std::string>()) +
                          ". Errors are counted on the " + grouped(judged) +
                          " pixels of the sampled rows, of which " + grouped(covered) +
                          " are covered.") +
         element("div",
                 element("div", element("table", rows), "class=wide") + "<img class=plot src=\"" +
                     escaped(id) + ".svg\" width=460 height=330 alt=\"" + escaped(id) +
                     ", time against errors\">",
                 "class=work");
}

// A row a work item, a column a mapper: time, and errors per million pixels.
std::string overview(const json& bench) {
  std::string head = "<tr><th>work item";
  for (const json& subject : bench.at("subjects"))
    head += "<th class=n>" + escaped(subject.at("id").get<std::string>());
  std::string rows = head + "</tr>\n";
  for (const json& work : bench.at("workloads")) {
    std::string row = element("th",
                              escaped(work.at("id").get<std::string>()) + ": " +
                                  escaped(work.at("title").get<std::string>()),
                              "scope=row");
    for (const json& result : work.at("results")) row += overview_cell(result);
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
  for (const json& absent : bench.at("absent_peers"))
    list += element("li", "Missing: " + escaped(absent.get<std::string>()) + ".", "class=bad");
  return element("ul", list);
}

}  // namespace

double errors_per_million(const json& result) {
  double errors = 0;
  for (const char* key : {"wrong_texels", "missing_px", "extra_px"}) {
    if (!result.at(key).is_null()) errors += result[key].get<double>();
  }
  return errors * 1e6 / result.at("covered_px").get<double>();
}

std::string plot_data(const json& work) {
  std::string fill, others;
  int place = 0;
  for (const json& result : work.at("results")) {
    ++place;
    if (result.contains("refusal")) continue;
    const json& time = result.at("ns_per_px");
    std::string line =
        result.at("id").get<std::string>() + "\t" + std::to_string(errors_per_million(result));
    for (const char* key : {"median", "lower_quartile", "upper_quartile"})
      line += "\t" + std::to_string(time.at(key).get<double>());
    line += "\t" + std::to_string(place);
    (result.at("wrong_texels").is_null() ? fill : others) += line + "\n";
  }
  return fill + others;
}

std::string measurement_section(const Results& results) {
  std::string html = element("h2", "Speed against error", "id=speed");
  if (results.bench.is_null())
    return html + element("p", "Not measured: " + escaped(results.unmeasured), "class=bad");
  const json& bench = results.bench;
  html += element(
      "p",
      "Nanoseconds per covered pixel, the median of " + bench.at("repetitions").dump() +
          " interleaved repetitions in one run, with the quartiles; the ratio is to a solid "
          "fill of the same pixels. Errors are counted against the exact model on " +
          bench.at("rows").dump() +
          " rows of each target, one in each equal band, placed by the seed. Had Selvage "
          "differed from the model in one pixel of them, nothing would have been timed. All "
          "mappers read the same RGBA texture, its rows padded by 16 texels, and draw into the "
          "same memory.");
  html += overview(bench) + subjects(bench);
  for (const json& work : bench.at("workloads")) html += work_item(work);
  return html;
}

}  // namespace selvage::reports
