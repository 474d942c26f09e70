#include "cli/stability_table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string_view>

#include "cli/number.h"

namespace selvage::cli {
namespace {

using stability::Cell;
using stability::FamilyRow;
using stability::Promise;

constexpr size_t kColumns = 100;

[[nodiscard]] std::string row(const std::vector<std::string>& fields) {
  constexpr int widths[] = {-14, 13, 8, 9, 10, 10, 9};
  std::string line;
  for (size_t i = 0; i < std::size(widths); ++i) {
    char field[64];
    std::snprintf(field, sizeof field, "%*s", widths[i], fields[i].c_str());
    line += field;
  }
  return line + "  " + fields.back() + "\n";
}

// Three significant digits, and 0 for nothing but 0.
[[nodiscard]] std::string short_number(double value) {
  char text[32];
  const int digits = value > 0 ? 2 - static_cast<int>(std::floor(std::log10(value))) : 0;
  std::snprintf(text, sizeof text, "%.*f", std::clamp(digits, 0, 6), value);
  return value > 0 && value < 1e-6 ? show(value) : text;
}

[[nodiscard]] std::string percent(double share) {
  if (share == 0) return "0";
  return share < 1 && share > 0.9995 ? ">99.9 %" : short_number(100 * share) + " %";
}

[[nodiscard]] std::string part_text(const stability::Errors& errors) {
  if (!errors.part_of_bound) return "-";
  if (errors.own_coverage_px > 0) return "COVERAGE";
  char text[32];
  std::snprintf(text, sizeof text, "%.3f", *errors.part_of_bound);
  return *errors.part_of_bound > 1 ? "ABOVE 1" : text;
}

// Whole words on lines of kColumns, all but the first indented.
[[nodiscard]] std::string wrapped(std::string_view text, size_t indent = 0) {
  std::string lines;
  size_t room = kColumns;
  while (text.size() > room) {
    const size_t space = text.rfind(' ', room);
    const size_t end = space == std::string_view::npos ? room : space;
    lines += std::string(text.substr(0, end)) + "\n" + std::string(indent, ' ');
    text.remove_prefix(std::min(end + 1, text.size()));
    room = kColumns - indent;
  }
  return lines + std::string(text) + "\n";
}

[[nodiscard]] std::string list_entry(std::string_view name, std::string_view text) {
  constexpr size_t indent = 24;
  std::string entry = "  " + std::string(name);
  entry += std::string(entry.size() < indent ? indent - entry.size() : 1, ' ');
  return wrapped(entry + std::string(text), indent);
}

[[nodiscard]] bool kept(const Cell& cell) { return cell.errors.keeps(cell.contender->promise); }

// Why a cell's promise does not hold, as a sentence's end.
[[nodiscard]] std::string breach(const Cell& cell) {
  const stability::Errors& errors = cell.errors;
  if (!errors.memory_fault.empty()) return errors.memory_fault;
  if (errors.refused_cases > 0) return std::to_string(errors.refused_cases) + " scenes refused";
  if (cell.contender->promise == Promise::kBound) return "a texel is beyond the derived bound";
  return "a pixel differs from the exact model";
}

}  // namespace

std::string_view stability_notes() {
  return "Errors are those of the picture against the exact model of the scene as it is given; "
         "wrong, largest and mean are of the texels of those pixels that both draw. "
         "abrash56, abrash57 and dkit take whole pixels and no perspective: they draw the scene "
         "moved to where they sample, with its vertices rounded to whole pixels and q dropped, and "
         "their errors include that. 'of bound' does not: it is the largest distance between a "
         "texel they drew and the coordinates that the rounded scene has by their own conventions, "
         "in parts of what their arithmetic is proved to stay within. "
         "fixed1616 drops q. "
         "float32-plane draws n-gons as fans of triangles, which is another map wherever outline "
         "and texture polygon are not related by one.";
}

bool passed(const StabilityRun& run) {
  return std::all_of(run.families.begin(), run.families.end(), [](const FamilyRow& family) {
    return std::all_of(family.cells.begin(), family.cells.end(), kept);
  });
}

std::string worst_line(const FamilyRow& family, const Cell& cell) {
  return "selvage stability --family " + std::string(family.family->name) + " --arithmetic " +
         std::string(cell.contender->name) + " --seed " + std::to_string(cell.worst->seed) +
         " --cases 1";
}

std::string stability_block(const FamilyRow& family) {
  std::string text =
      wrapped(std::string(family.family->name) + ": " + std::string(family.family->reason)) +
      std::to_string(family.covered_px) + " pixels covered\n" +
      row({"arithmetic", "wrong texels", "largest", "mean", "missing", "extra", "of bound",
           "worst seed"});
  for (const Cell& cell : family.cells) {
    const stability::Errors& errors = cell.errors;
    text += row({std::string(cell.contender->name), percent(errors.wrong_share()),
                 std::to_string(errors.largest_texel), short_number(errors.mean_texel()),
                 std::to_string(errors.missing_px), std::to_string(errors.extra_px),
                 part_text(errors), cell.worst ? std::to_string(cell.worst->seed) : "-"});
  }
  return text + "\n";
}

std::string stability_summary(const StabilityRun& run) {
  std::string text = wrapped(stability_notes());
  for (const FamilyRow& family : run.families) {
    for (const Cell& cell : family.cells) {
      if (kept(cell)) continue;
      text += "BROKEN: " + std::string(cell.contender->name) + " on " +
              std::string(family.family->name) + ": " + breach(cell) +
              "; again: " + worst_line(family, cell) + "\n";
    }
  }
  return text;
}

std::string stability_list(std::span<const stability::Contender> contenders) {
  std::string text = "Hard families:\n";
  for (const spec::HardFamily& family : spec::hard_families())
    text += list_entry(family.name, family.reason);
  text += "\nArithmetics:\n";
  for (const stability::Contender& contender : contenders)
    text += list_entry(contender.name, contender.statement);
  return text;
}

}  // namespace selvage::cli
