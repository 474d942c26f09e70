#include "reports/scenes/study.h"

namespace selvage::reports {
namespace {

using json = nlohmann::ordered_json;

[[nodiscard]] json spread_json(const std::optional<Spread>& spread) {
  if (!spread) return nullptr;
  return {{"median", spread->median},
          {"lower_quartile", spread->lower_quartile},
          {"upper_quartile", spread->upper_quartile}};
}

[[nodiscard]] json trial_json(const Trial& trial) {
  const Verdict& verdict = trial.verdict;
  json choices = json::array();
  for (size_t i = 0; i < kChoices; ++i) {
    if (verdict.choice_px[i] == 0) continue;
    choices.push_back({{"id", style_of(choice_number(i)).id},
                       {"px", verdict.choice_px[i]},
                       {"faces", trial.choice_faces[i]}});
  }
  return {{"filter", trial.filter},
          {"tolerance_texel", trial.tolerance_texel},
          {"tolerance", tolerance_name(trial.tolerance_texel)},
          {"overlay", trial.overlay_file},
          {"choices", choices},
          {"textured_px", verdict.textured_px},
          {"largest_error_texel", verdict.largest_texel},
          {"mean_error_texel", verdict.mean_texel()},
          {"bound_texel", verdict.bound_texel},
          {"wrong_texels", verdict.wrong_texels},
          {"different_px", trial.different_px},
          {"largest_level", trial.largest_level},
          {"breaches", verdict.breaches},
          {"first_breach", verdict.first_breach},
          {"ns_per_px", spread_json(trial.ns_per_px)},
          {"textured_ns_per_px", spread_json(trial.textured_ns_per_px)}};
}

}  // namespace

json json_of(const Study& study) {
  const std::string id(study.shipped->id);
  json trials = json::array();
  for (const Trial& trial : study.trials) trials.push_back(trial_json(trial));
  return {{"id", id},
          {"title", study.shipped->title},
          {"sentence", study.shipped->sentence},
          {"width_px", study.size.width_px},
          {"height_px", study.size.height_px},
          {"picture", id + ".png"},
          {"picture_filter", study.shipped->filter ? "bilinear" : "auto"},
          {"tolerance", tolerance_name(study.tolerance_texel)},
          {"faces", study.counts.faces},
          {"faces_from_behind", study.counts.backs},
          {"faces_edge_on", study.counts.edge_on},
          {"faces_seen", study.counts.seen},
          {"faces_shown", study.faces_shown},
          {"shown_px", study.shown_px},
          {"trials", trials}};
}

}  // namespace selvage::reports
