#include <algorithm>
#include <cmath>
#include <cstdio>
#include <span>

#include "cli/bench_report.h"
#include "cli/text_columns.h"

namespace selvage::cli {
namespace {

using reports::ErrorCount;
using reports::ItemResult;

template <typename Number>
[[nodiscard]] std::string shown(const std::optional<Number>& number) {
  if (!number) return "-";
  if constexpr (std::is_floating_point_v<Number>)
    return short_number(*number);
  else
    return std::to_string(*number);
}

[[nodiscard]] std::string subject_row(const std::vector<std::string>& fields) {
  constexpr int widths[] = {-13, 7, 18, 7, 8, 8, 8, 7, 7, 8, 9};
  return columns(fields, widths);
}

[[nodiscard]] std::string subject_row(const ItemResult& item, const reports::Cell& cell) {
  const std::string& id = cell.subject->id;
  if (!cell.refusal.empty()) return list_entry(id, "not measured: " + cell.refusal, 13);
  const reports::Spread& ns = cell.ns_per_px;
  std::vector<std::string> fields{
      id, short_number(ns.median),
      short_number(ns.lower_quartile) + " .. " + short_number(ns.upper_quartile),
      shown(reports::ratio(&cell, item.measured("fill"))),
      shown(reports::ratio(&cell, item.measured("exact")))};
  const auto add = [&](bool known, const std::string& text) {
    fields.push_back(known ? text : "-");
  };
  const bool filtered = item.load->filter != SELVAGE_FILTER_NEAREST;
  const ErrorCount errors = cell.errors.value_or(ErrorCount{});
  const bool judged = cell.errors.has_value(), textures = judged && cell.subject->textures;
  add(textures, std::to_string(filtered ? errors.wrong_colours : errors.wrong_texels));
  add(judged, std::to_string(errors.missing_px));
  add(judged, std::to_string(errors.extra_px));
  fields.push_back(shown(errors.double_px));
  add(textures, std::to_string(filtered ? errors.largest_level : errors.largest_texel));
  add(textures, short_number(filtered ? errors.mean_level() : errors.mean_texel()));
  return subject_row(fields);
}

[[nodiscard]] std::string unit_of_errors(const reports::Workload& load) {
  if (load.filter == SELVAGE_FILTER_NEAREST) return {};
  return ". Filtered: wrong is a colour whose worst channel is off by more than " +
         std::to_string(reports::kRounding_level) +
         " level of 255; largest and mean are of that channel, in levels";
}

[[nodiscard]] std::string block(const ItemResult& item, uint64_t judged_px) {
  const reports::Workload& load = *item.load;
  const std::string polygons =
      std::to_string(load.polygons.size()) + (load.polygons.size() == 1 ? " polygon" : " polygons");
  std::string text = wrapped(load.id + ": " + load.title + ". " + polygons + ", " +
                             std::to_string(item.covered_px) + " pixels covered, " +
                             std::to_string(judged_px) + " pixels judged" + unit_of_errors(load)) +
                     subject_row({"subject", "ns/px", "quartiles", "/ fill", "/ exact", "wrong",
                                  "missing", "extra", "double", "largest", "mean"});
  for (const reports::Cell& cell : item.cells) text += subject_row(item, cell);
  return text + "\n";
}

[[nodiscard]] uint64_t judged_px_of(const ItemResult& item) {
  for (const reports::Cell& cell : item.cells) {
    if (cell.errors) return cell.errors->judged_px;
  }
  return 0;
}

// What being a near-tie everywhere costs: each adversarial item against its ordinary twin.
[[nodiscard]] std::string adversarial(const BenchReport& report) {
  std::string text;
  for (const ItemResult& item : report.results) {
    if (item.load->ordinary_id.empty()) continue;
    const auto twin = std::ranges::find_if(report.results, [&](const ItemResult& other) {
      return other.load->id == item.load->ordinary_id;
    });
    if (twin == report.results.end()) continue;
    for (const reports::Cell& cell : item.cells) {
      const auto times =
          reports::ratio(item.measured(cell.subject->id), twin->measured(cell.subject->id));
      if (times && cell.subject->group == "ours")
        text += "  " + item.load->id + " " + cell.subject->id + ": " + short_number(*times) +
                " times " + twin->load->id + "\n";
    }
  }
  return text.empty() ? text
                      : "Near-ties, by the time of the same shape without them:\n" + text + "\n";
}

[[nodiscard]] std::string curve_block(const BenchReport& report,
                                      const reports::PlannedCurve& planned) {
  constexpr int first_width = 14, width = 12;
  std::vector<std::string> ids;
  for (const reports::Series& series : planned.curve.series) ids.push_back(series.id);
  std::vector<int> widths{first_width};
  std::vector<std::string> head{"x"};
  for (const std::string& id : ids) {
    widths.push_back(width);
    head.push_back(id);
  }
  std::string text = wrapped(planned.curve.title + ": " + planned.curve.description +
                             ". x: " + planned.curve.axis + "; ns per covered pixel") +
                     columns(head, widths);
  for (size_t i = 0; i < planned.xs.size(); ++i) {
    const ItemResult& item = report.results[planned.items[i]];
    std::vector<std::string> fields{short_number(planned.xs[i])};
    for (const std::string& id : ids) {
      const reports::Cell* cell = item.measured(id);
      fields.push_back(cell == nullptr ? "-" : short_number(cell->ns_per_px.median));
    }
    text += columns(fields, widths);
  }
  return text + "\n";
}

// Which kernels there are, and what selvage_fastest_kernel says of them.
[[nodiscard]] std::string kernel_notes(const BenchReport& report) {
  std::string text = "Fastest kernels, RGBA8888:", last_filter;
  for (const reports::FastestKernel& one : report.fastest_kernels) {
    text +=
        one.filter == last_filter ? ", " : (last_filter.empty() ? " " : "; ") + one.filter + " ";
    text += one.work + " " + reports::kernel_name(one.kernel);
    last_filter = one.filter;
  }
  text += ".";
  for (const selvage_kernel kernel : reports::kernels_elsewhere())
    text += " Not on this machine: " + reports::kernel_name(kernel) + ".";
  return wrapped(text);
}

constexpr const char* kNotes =
    "ns/px: median time by covered pixel, with quartiles. / fill and / exact: ratios to the solid "
    "fill of the same pixels and to 'exact' (memcpy moves as many bytes). Errors are counted on "
    "the "
    "pixels judged: wrong texels, pixels missing, extra and drawn by two polygons, the largest and "
    "the mean distance of a texel from the right one in whole texels. abrash56, abrash57 and dkit "
    "draw the item with its vertices rounded to whole pixels, and their errors include that.";

[[nodiscard]] std::string padding_note(int32_t padding_px) {
  return wrapped("Behind each row of a target: " + std::to_string(padding_px) +
                 " px of padding (--padding); what is drawn there counts as extra.");
}

}  // namespace

std::string bench_table(const BenchReport& report) {
  std::string text;
  for (size_t i = 0; i < report.plan->work_items; ++i)
    text += block(report.results[i], judged_px_of(report.results[i]));
  text += adversarial(report);
  for (const reports::PlannedCurve& planned : report.plan->curves)
    text += curve_block(report, planned);
  text += wrapped(kNotes) + padding_note(report.settings.padding_px) + kernel_notes(report);
  for (const std::string& sentence : report.plan->unavailable)
    text += wrapped("Not there: " + sentence + ".", 2);
  return text;
}

std::string bench_list(const reports::Plan& plan) {
  std::string text = "Items:\n";
  for (const reports::Item& item : std::span(plan.items).first(plan.work_items))
    text += list_entry("  " + item.load.id, item.load.title + ": " + item.load.description);
  for (const reports::PlannedCurve& planned : plan.curves)
    text += list_entry("  " + planned.curve.id + "=X", planned.curve.description);
  text += "\nSubjects:\n";
  for (const reports::Subject& subject : plan.subjects)
    text += list_entry("  " + subject.id, subject.title + ": " + subject.configuration);
  for (const std::string& sentence : plan.unavailable)
    text += wrapped("\nNot there: " + sentence + ".", 2);
  return text;
}

}  // namespace selvage::cli
