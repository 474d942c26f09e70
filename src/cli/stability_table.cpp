#include "cli/stability_table.h"

#include <algorithm>
#include <cstdio>
#include <string_view>

#include "cli/text_columns.h"

namespace selvage::cli {
namespace {

using stability::Cell;
using stability::FamilyRow;
using stability::Promise;

[[nodiscard]] std::string arithmetic_row(const std::vector<std::string>& fields) {
  constexpr int widths[] = {-14, 13, 8, 9, 9, 8, 8, 9};
  std::string line = columns(std::span(fields).first(std::size(widths)), widths);
  line.pop_back();
  return line + "  " + fields.back() + "\n";
}

[[nodiscard]] std::string percent(double share) {
  if (share == 0) return "0";
  return share < 1 && share > 0.9995 ? ">99.9 %" : short_number(100 * share) + " %";
}

[[nodiscard]] std::string outline_text(const stability::Errors& errors) {
  if (errors.missing_px + errors.extra_px == 0) return "-";
  char text[32];
  std::snprintf(text, sizeof text, "%.2g", errors.largest_outline_px);
  return text;
}

[[nodiscard]] std::string part_text(const stability::Errors& errors) {
  if (!errors.part_of_bound) return "-";
  if (errors.own_coverage_px > 0) return "COVERAGE";
  char text[32];
  std::snprintf(text, sizeof text, "%.3f", *errors.part_of_bound);
  return *errors.part_of_bound > 1 ? "ABOVE 1" : text;
}

[[nodiscard]] bool kept(const Cell& cell) { return cell.errors.keeps(cell.contender->promise); }

// Why a cell's promise does not hold, as a sentence's end.
[[nodiscard]] std::string breach(const Cell& cell) {
  const stability::Errors& errors = cell.errors;
  if (errors.hung) return errors.memory_fault + "; no more was asked of it";
  if (!errors.memory_fault.empty()) return errors.memory_fault;
  if (errors.refused_cases > 0) return std::to_string(errors.refused_cases) + " scenes refused";
  if (cell.contender->promise == Promise::kBound) {
    if (errors.part_of_bound <= 1.0) return "a pixel is missing or too much";
    return cell.contender->profile == SELVAGE_PROFILE_EXACT
               ? "a texel is beyond the claimed accuracy"
               : "a texel is beyond the derived bound";
  }
  return "a pixel differs from the exact model";
}

}  // namespace

std::string_view stability_notes() {
  return "Errors are those of the picture against the exact model of the scene as it is given; "
         "wrong, largest and mean are of the texels of those pixels that both draw; 'off px' is "
         "how far from the outline a missing or extra pixel's centre is at most, in x or in y. "
         "abrash56, abrash57 and dkit take whole pixels and no perspective: they draw the scene "
         "moved to where they sample, with its vertices rounded to whole pixels and q dropped, and "
         "their errors include that. 'of bound' does not: it is the largest distance between a "
         "texel they drew and the coordinates that the rounded scene has by their own conventions, "
         "in parts of what their arithmetic is proved to stay within. "
         "fixed1616 drops q. "
         "float32-plane draws n-gons as fans of triangles, which is another map wherever outline "
         "and texture polygon are not related by one. "
         "A library of such a profile, or that takes no perspective, draws rounded and dropped, "
         "too; 'of bound' of one that claims an accuracy is in parts of that.";
}

bool passed(const StabilityRun& run) {
  return std::all_of(run.families.begin(), run.families.end(), [](const FamilyRow& family) {
    return std::all_of(family.cells.begin(), family.cells.end(), kept);
  });
}

std::string worst_line(const StabilityRun& run, const FamilyRow& family, const Cell& cell) {
  return "selvage stability " + run.arguments + (run.arguments.empty() ? "" : " ") + "--family " +
         std::string(family.family->name) + " --arithmetic " + std::string(cell.contender->name) +
         " --seed " + std::to_string(cell.worst->seed) + " --cases 1";
}

std::string stability_block(const FamilyRow& family) {
  std::string text =
      wrapped(std::string(family.family->name) + ": " + std::string(family.family->reason)) +
      std::to_string(family.covered_px) + " pixels covered\n" +
      arithmetic_row({"arithmetic", "wrong texels", "largest", "mean", "missing", "extra", "off px",
                      "of bound", "worst seed"});
  for (const Cell& cell : family.cells) {
    const stability::Errors& errors = cell.errors;
    if (errors.judged_cases == 0) {
      text += arithmetic_row(
          {std::string(cell.contender->name), "not claimed", "-", "-", "-", "-", "-", "-", "-"});
      continue;
    }
    text += arithmetic_row({std::string(cell.contender->name), percent(errors.wrong_share()),
                            std::to_string(errors.largest_texel), short_number(errors.mean_texel()),
                            std::to_string(errors.missing_px), std::to_string(errors.extra_px),
                            outline_text(errors), part_text(errors),
                            cell.worst ? std::to_string(cell.worst->seed) : "-"});
  }
  return text + "\n";
}

std::string stability_summary(const StabilityRun& run) {
  std::string text = wrapped(stability_notes());
  for (const FamilyRow& family : run.families) {
    for (const Cell& cell : family.cells) {
      if (cell.errors.judged_cases < run.cases && !cell.errors.hung) {
        text += "not claimed: " + std::string(cell.contender->name) + " on " +
                std::string(family.family->name) + ": " +
                std::to_string(run.cases - cell.errors.judged_cases) + " of " +
                std::to_string(run.cases) + " scenes\n";
      }
      if (kept(cell)) continue;
      text += "BROKEN: " + std::string(cell.contender->name) + " on " +
              std::string(family.family->name) + ": " + breach(cell) +
              "; again: " + worst_line(run, family, cell) + "\n";
    }
  }
  return text;
}

std::string stability_list(std::span<const stability::Contender> contenders) {
  std::string text = "Hard families:\n";
  for (const spec::HardFamily& family : spec::hard_families())
    text += list_entry("  " + std::string(family.name), family.reason);
  text += "\nArithmetics:\n";
  for (const stability::Contender& contender : contenders)
    text += list_entry("  " + std::string(contender.name), contender.statement);
  return text;
}

}  // namespace selvage::cli
