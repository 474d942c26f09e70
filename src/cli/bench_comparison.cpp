#include "cli/bench_comparison.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>

#include "cli/error.h"
#include "cli/text_columns.h"
#include "testbed/printable.h"

namespace selvage::cli {
namespace {

using nlohmann::json;

constexpr size_t kNameColumns = 16, kAllColumns = 100;

void add_median(Baseline& baseline, const std::string& item, const std::string& subject,
                const json& ns) {
  if (!ns.is_number() || ns.get<double>() <= 0)
    throw UserError("the median of " + item + "/" + subject + " is no time in ns");
  baseline.ns[item][subject] = ns.get<double>();
}

void read_brief(Baseline& baseline, const json& items) {
  for (const auto& [item, subjects] : items.items()) {
    for (const auto& [subject, ns] : subjects.items()) add_median(baseline, item, subject, ns);
  }
}

void read_results(Baseline& baseline, const json& item) {
  for (const json& result : item.at("results")) {
    if (!result.contains("ns_per_px")) continue;
    add_median(baseline, item.at("id"), result.at("id"), result.at("ns_per_px").at("median"));
  }
}

void read_whole(Baseline& baseline, const json& document) {
  for (const json& item : document.at("workloads")) read_results(baseline, item);
  for (const json& curve : document.value("curves", json::array())) {
    for (const json& point : curve.at("points")) read_results(baseline, point);
  }
}

[[nodiscard]] std::string field(const std::string& text, size_t columns) {
  return std::string(columns - std::min(columns, text.size()), ' ') + text;
}

[[nodiscard]] std::string hundredths(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", value);
  return text;
}

// In order of first appearance.
template <typename Name>
[[nodiscard]] std::vector<std::string> names(const std::vector<ComparedTime>& times, Name name) {
  std::vector<std::string> found;
  for (const ComparedTime& time : times) {
    if (std::ranges::find(found, time.*name) == found.end()) found.push_back(time.*name);
  }
  return found;
}

[[nodiscard]] std::optional<double> ratio_of(const TimeComparison& comparison,
                                             const std::string& item, const std::string& subject) {
  const auto found = std::ranges::find_if(comparison.times, [&](const ComparedTime& time) {
    return time.item == item && time.subject == subject;
  });
  if (found == comparison.times.end()) return std::nullopt;
  return found->ratio();
}

[[nodiscard]] std::string ratios_row(const TimeComparison& comparison, const std::string& subject,
                                     const std::vector<std::string>& items, size_t columns) {
  std::string line = subject + field("", kNameColumns - std::min(kNameColumns, subject.size()));
  for (const std::string& item : items) {
    const auto ratio = ratio_of(comparison, item, subject);
    line += field(ratio ? hundredths(*ratio) : "-", columns);
  }
  return line + "\n";
}

// As many items across as there is room for, then the next.
[[nodiscard]] std::string blocks(const TimeComparison& comparison) {
  const auto items = names(comparison.times, &ComparedTime::item);
  size_t columns = 8;
  for (const std::string& item : items) columns = std::max(columns, item.size() + 2);
  const size_t across = std::max((kAllColumns - kNameColumns) / columns, size_t{1});
  std::string text;
  for (size_t first = 0; first < items.size(); first += across) {
    const std::vector<std::string> some(
        items.begin() + static_cast<ptrdiff_t>(first),
        items.begin() + static_cast<ptrdiff_t>(std::min(first + across, items.size())));
    text += "\n" + field("", kNameColumns);
    for (const std::string& item : some) text += field(item, columns);
    text += "\n";
    for (const std::string& subject : names(comparison.times, &ComparedTime::subject))
      text += ratios_row(comparison, subject, some, columns);
  }
  return text;
}

[[nodiscard]] std::string means(const TimeComparison& comparison) {
  std::string text = "\nGeometric mean of all items:";
  for (const std::string& subject : names(comparison.times, &ComparedTime::subject)) {
    double sum = 0;
    size_t count = 0;
    for (const ComparedTime& time : comparison.times) {
      if (time.subject != subject) continue;
      sum += std::log(time.ratio());
      ++count;
    }
    text += "\n  " + subject + " " + hundredths(std::exp(sum / static_cast<double>(count)));
  }
  return text + "\n";
}

}  // namespace

Baseline parse_baseline(const std::string& source, const std::string& text) {
  return about(source, [&] {
    Baseline baseline;
    baseline.source = source;
    try {
      const json document = json::parse(text);
      const json machine = document.at("machine");
      baseline.conditions.cpu = machine.value("cpu", "unknown");
      baseline.date = machine.value("date", "unknown");
      baseline.compiler = machine.value("compiler", "unknown");
      baseline.conditions.padding_px = document.value("padding_px", 0);
      if (document.contains("medians_ns_per_px"))
        read_brief(baseline, document["medians_ns_per_px"]);
      else
        read_whole(baseline, document);
    } catch (const json::parse_error& error) {
      throw UserError("not JSON: " + testbed::printable(error.what()));
    } catch (const json::exception& error) {
      throw UserError(std::string("not the JSON of `selvage bench`: ") + error.what());
    }
    return baseline;
  });
}

TimeComparison compare(const std::vector<reports::ItemResult>& results,
                       const Conditions& conditions, Baseline baseline) {
  TimeComparison comparison;
  comparison.conditions = conditions;
  for (const reports::ItemResult& result : results) {
    const auto item = baseline.ns.find(result.load->id);
    for (const reports::Cell& cell : result.cells) {
      if (!cell.refusal.empty()) continue;
      const bool known = item != baseline.ns.end() && item->second.contains(cell.subject->id);
      if (!known) {
        ++comparison.only_now;
        continue;
      }
      comparison.times.push_back({result.load->id, cell.subject->id, cell.ns_per_px.median,
                                  item->second.at(cell.subject->id)});
    }
  }
  comparison.baseline = std::move(baseline);
  return comparison;
}

std::string comparison_table(const TimeComparison& comparison) {
  const Baseline& then = comparison.baseline;
  const Conditions& now = comparison.conditions;
  std::string text = wrapped("Against " + then.source + " (" + then.date + ", " + then.compiler +
                             "): time now / time then; below 1 is faster.");
  if (then.conditions.cpu != now.cpu)
    text += wrapped("It was measured on another machine: " + then.conditions.cpu +
                    "; this one is " + now.cpu + ".");
  if (then.conditions.padding_px != now.padding_px)
    text += wrapped("It was measured on targets whose rows were padded by " +
                    std::to_string(then.conditions.padding_px) + " px, this run by " +
                    std::to_string(now.padding_px) + " px, which changes times.");
  if (comparison.only_now > 0)
    text +=
        std::to_string(comparison.only_now) + " measurements are new: it has no time of them.\n";
  if (comparison.times.empty()) return text + "It has no time of what was measured here.\n";
  return text + blocks(comparison) + means(comparison);
}

}  // namespace selvage::cli
