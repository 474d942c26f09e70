#include <cstdio>
#include <nlohmann/json.hpp>

#include "cli/bench_report.h"
#include "cli/job.h"
#include "cli/json_text.h"

namespace selvage::cli {
namespace {

using nlohmann::ordered_json;
using reports::ErrorCount;
using reports::ItemResult;

constexpr int kIndent = 1;  // as in reports/baseline.json

template <typename Number>
[[nodiscard]] ordered_json maybe(const std::optional<Number>& number) {
  return number ? ordered_json(*number) : ordered_json();
}

// Of what a picture is judged by, in the order of the file; null where there is nothing to judge.
void add_errors(ordered_json& values, const std::optional<ErrorCount>& judged, bool textures,
                bool filtered) {
  const ErrorCount errors = judged.value_or(ErrorCount{});
  const auto add = [&](const char* key, bool known, const ordered_json& value) {
    values[key] = known ? value : ordered_json();
  };
  const bool any = judged.has_value(), texels = any && textures && !filtered,
             colours = any && textures && filtered;
  add("judged_px", any, errors.judged_px);
  add("covered_px", any, errors.covered_px);
  add("wrong_texels", texels, errors.wrong_texels);
  add("wrong_colours", colours, errors.wrong_colours);
  add("unequal_colours", colours, errors.unequal_colours);
  add("missing_px", any, errors.missing_px);
  add("extra_px", any, errors.extra_px);
  add("extra_in_padding_px", any, errors.extra_in_padding_px);
  add("double_px", any, maybe(errors.double_px));
  add("largest_texel", texels, errors.largest_texel);
  add("mean_texel", texels, errors.mean_texel());
  add("largest_coordinate_texel", texels, errors.largest_coordinate_texel);
  add("largest_level", colours, errors.largest_level);
  add("mean_level", colours, errors.mean_level());
}

[[nodiscard]] ordered_json cell_json(const ItemResult& item, const reports::Cell& cell,
                                     const ItemResult* ordinary) {
  ordered_json values{{"id", cell.subject->id}};
  if (!cell.refusal.empty()) {
    values["refusal"] = cell.refusal;
    return values;
  }
  values["ns_per_px"] = {{"median", cell.ns_per_px.median},
                         {"lower_quartile", cell.ns_per_px.lower_quartile},
                         {"upper_quartile", cell.ns_per_px.upper_quartile}};
  values["ratio_to_fill"] = maybe(reports::ratio(&cell, item.measured("fill")));
  values["ratio_to_exact"] = maybe(reports::ratio(&cell, item.measured("exact")));
  if (ordinary != nullptr)
    values["ratio_to_ordinary"] =
        maybe(reports::ratio(&cell, ordinary->measured(cell.subject->id)));
  add_errors(values, cell.errors, cell.subject->textures,
             item.load->filter != SELVAGE_FILTER_NEAREST);
  return values;
}

[[nodiscard]] ordered_json cells_json(const BenchReport& report, const ItemResult& item) {
  const ItemResult* ordinary = nullptr;
  for (const ItemResult& other : report.results) {
    if (!item.load->ordinary_id.empty() && other.load->id == item.load->ordinary_id)
      ordinary = &other;
  }
  ordered_json cells = ordered_json::array();
  for (const reports::Cell& cell : item.cells) cells.push_back(cell_json(item, cell, ordinary));
  return cells;
}

[[nodiscard]] ordered_json workload_json(const BenchReport& report, const ItemResult& item) {
  const reports::Workload& load = *item.load;
  const std::string side = std::to_string(load.target_side_px);
  return {{"id", load.id},
          {"title", load.title},
          {"description", load.description},
          {"ordinary", load.ordinary_id.empty() ? ordered_json() : ordered_json(load.ordinary_id)},
          {"filter", filter_name(load.filter)},
          {"polygons", load.polygons.size()},
          {"target_px", side + " x " + side},
          {"covered_px", item.covered_px},
          {"results", cells_json(report, item)}};
}

[[nodiscard]] ordered_json curve_json(const BenchReport& report,
                                      const reports::PlannedCurve& planned) {
  ordered_json points = ordered_json::array();
  for (size_t i = 0; i < planned.xs.size(); ++i) {
    const ItemResult& item = report.results[planned.items[i]];
    points.push_back({{"x", planned.xs[i]},
                      {"id", item.load->id},
                      {"polygons", item.load->polygons.size()},
                      {"covered_px", item.covered_px},
                      {"results", cells_json(report, item)}});
  }
  return {{"id", planned.curve.id},
          {"title", planned.curve.title},
          {"description", planned.curve.description},
          {"axis", planned.curve.axis},
          {"points", std::move(points)}};
}

[[nodiscard]] ordered_json comparison_json(const TimeComparison& comparison) {
  ordered_json times = ordered_json::array();
  for (const ComparedTime& time : comparison.times) {
    times.push_back({{"item", time.item},
                     {"subject", time.subject},
                     {"now_ns", time.now_ns},
                     {"then_ns", time.then_ns},
                     {"ratio", time.ratio()}});
  }
  return {{"baseline", comparison.baseline.source},
          {"date", comparison.baseline.date},
          {"cpu", comparison.baseline.conditions.cpu},
          {"padding_px", comparison.baseline.conditions.padding_px},
          {"compiler", comparison.baseline.compiler},
          {"new", comparison.only_now},
          {"times", std::move(times)}};
}

[[nodiscard]] ordered_json heading(const BenchReport& report) {
  ordered_json machine;
  for (const auto& [key, value] : report.machine) machine[key] = value;
  return {{"machine", std::move(machine)},
          {"seed", report.settings.seed},
          {"rows", report.settings.rows},
          {"repetitions", report.settings.timing.repetitions},
          {"min_time_s", report.settings.timing.min_time_s},
          {"padding_px", report.settings.padding_px}};
}

}  // namespace

std::string bench_json(const BenchReport& report) {
  ordered_json document = heading(report);
  document["fastest_kernels"] = ordered_json::object();
  for (const reports::FastestKernel& one : report.fastest_kernels)
    document["fastest_kernels"][one.filter][one.work] = reports::kernel_name(one.kernel);
  document["filter"] = report.filter.empty() ? ordered_json() : ordered_json(report.filter);
  for (const char* key : {"subjects", "workloads", "curves"}) document[key] = ordered_json::array();
  for (const reports::Subject& subject : report.plan->subjects) {
    document["subjects"].push_back({{"id", subject.id},
                                    {"title", subject.title},
                                    {"group", subject.group},
                                    {"configuration", subject.configuration}});
  }
  for (size_t i = 0; i < report.plan->work_items; ++i)
    document["workloads"].push_back(workload_json(report, report.results[i]));
  for (const reports::PlannedCurve& planned : report.plan->curves)
    document["curves"].push_back(curve_json(report, planned));
  document["unavailable"] = report.plan->unavailable;
  document["build_information"] = report.plan->build_information;
  document["comparison"] = report.comparison ? comparison_json(*report.comparison) : ordered_json();
  return json_text(document, kIndent);
}

// One line an item: a file that a person can read, and a change of which shows what changed.
std::string bench_brief_json(const BenchReport& report) {
  std::string text = json_text(heading(report), kIndent);
  text.erase(text.rfind("\n}"));
  text += ",\n \"medians_ns_per_px\": {";
  for (size_t i = 0; i < report.plan->work_items; ++i) {
    const ItemResult& item = report.results[i];
    text += std::string(i == 0 ? "" : ",") + "\n  " + ordered_json(item.load->id).dump() + ": {";
    std::string separator;
    for (const reports::Cell& cell : item.cells) {
      if (!cell.refusal.empty()) continue;
      char median[32];
      std::snprintf(median, sizeof median, "%.4g", cell.ns_per_px.median);
      text += separator + ordered_json(cell.subject->id).dump() + ": " + median;
      separator = ", ";
    }
    text += "}";
  }
  return text + "\n }\n}\n";
}

}  // namespace selvage::cli
