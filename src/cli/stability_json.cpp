#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/json_text.h"
#include "cli/stability_table.h"

namespace selvage::cli {
namespace {

using nlohmann::ordered_json;
using stability::Cell;
using stability::Contender;
using stability::FamilyRow;
using stability::Promise;

[[nodiscard]] std::string_view promise_name(Promise promise) {
  switch (promise) {
    case Promise::kExact:
      return "exact";
    case Promise::kBound:
      return "bound";
    case Promise::kNothing:
      break;
  }
  return "none";
}

[[nodiscard]] ordered_json contenders_json(std::span<const Contender> contenders) {
  ordered_json values = ordered_json::array();
  for (const Contender& contender : contenders) {
    values.push_back({{"arithmetic", contender.name},
                      {"statement", contender.statement},
                      {"promise", promise_name(contender.promise)},
                      {"affine_only", contender.affine_only}});
  }
  return values;
}

// Beyond a bound of 0 there is no part of it to tell: null, with "kept" false.
[[nodiscard]] ordered_json part_json(double part) {
  return std::isfinite(part) ? ordered_json(part) : ordered_json();
}

[[nodiscard]] ordered_json cell_json(const StabilityRun& run, const FamilyRow& family,
                                     const Cell& cell) {
  const stability::Errors& errors = cell.errors;
  ordered_json values = {{"arithmetic", cell.contender->name},
                         {"compared_px", errors.compared_px},
                         {"wrong_texels", errors.wrong_texels},
                         {"wrong_share", errors.wrong_share()},
                         {"largest_texel", errors.largest_texel},
                         {"mean_texel", errors.mean_texel()},
                         {"missing_px", errors.missing_px},
                         {"extra_px", errors.extra_px},
                         {"largest_outline_px", errors.largest_outline_px},
                         {"kept", errors.keeps(cell.contender->promise)}};
  if (errors.part_of_bound) values["part_of_bound"] = part_json(*errors.part_of_bound);
  if (errors.own_coverage_px > 0) values["own_coverage_px"] = errors.own_coverage_px;
  if (errors.hung) values["hung"] = true;
  if (errors.judged_cases < run.cases && !errors.hung) {
    values["not_claimed_cases"] = run.cases - errors.judged_cases;
  }
  if (errors.refused_cases > 0) values["refused_cases"] = errors.refused_cases;
  if (!errors.memory_fault.empty()) values["memory_fault"] = errors.memory_fault;
  if (cell.worst) {
    values["worst"] = {{"seed", cell.worst->seed},
                       {"largest_texel", cell.worst->errors.largest_texel},
                       {"wrong_share", cell.worst->errors.wrong_share()},
                       {"missing_px", cell.worst->errors.missing_px},
                       {"extra_px", cell.worst->errors.extra_px},
                       {"command", worst_line(run, family, cell)}};
  }
  return values;
}

}  // namespace

std::string stability_json(const StabilityRun& run, std::span<const Contender> contenders) {
  ordered_json values = {{"subject", run.subject},
                         {"passed", passed(run)},
                         {"seed", run.seed},
                         {"cases", run.cases},
                         {"notes", stability_notes()},
                         {"arithmetics", contenders_json(contenders)},
                         {"families", ordered_json::array()}};
  for (const FamilyRow& family : run.families) {
    ordered_json cells = ordered_json::array();
    for (const Cell& cell : family.cells) cells.push_back(cell_json(run, family, cell));
    values["families"].push_back({{"family", family.family->name},
                                  {"reason", family.family->reason},
                                  {"covered_px", family.covered_px},
                                  {"perspective", family.perspective},
                                  {"cells", std::move(cells)}});
  }
  return json_text(values);
}

std::string stability_list_json(std::span<const Contender> contenders) {
  ordered_json families = ordered_json::array();
  for (const spec::HardFamily& family : spec::hard_families()) {
    families.push_back({{"family", family.name}, {"reason", family.reason}});
  }
  return json_text(
      {{"families", std::move(families)}, {"arithmetics", contenders_json(contenders)}});
}

}  // namespace selvage::cli
