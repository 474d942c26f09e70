// Cost and error of the scenes, as tables and sentences.
#include <algorithm>
#include <cstdio>
#include <vector>

#include "reports/page/html.h"
#include "reports/page/scenes.h"

namespace selvage::reports {

namespace {

using json = nlohmann::ordered_json;

std::string texels(double value) {
  if (value == 0) return "0";
  char text[32];
  std::snprintf(text, sizeof text, value < 0.001 ? "%.6f" : "%.4f", value);
  return text;
}

std::string spread_cell(const json& spread) {
  if (spread.is_null()) return number_cell("&ndash;");
  const auto ns = [&](const char* key) { return rounded(spread.at(key).get<double>()); };
  return number_cell(ns("median") + "<br>" +
                     element("small", ns("lower_quartile") + " &ndash; " + ns("upper_quartile")));
}

std::string verdict_cell(const json& trial) {
  const auto number = [&](const char* key) { return trial.at(key).get<double>(); };
  if (trial.at("breaches") != 0) return element("td", "BROKEN", "class=bad");
  return element("td",
                 texels(number("largest_error_texel")) + " &le; " + texels(number("bound_texel")) +
                     " &le; " + text_of(trial, "tolerance"),
                 "class=good");
}

std::string different(const json& trial) {
  const auto px = trial.at("different_px").get<uint64_t>();
  if (px == 0) return "0";
  return grouped(px) + "<br>" +
         element("small", "by up to " + trial.at("largest_level").dump() + " of 255");
}

std::string trial_row(const json& trial) {
  return element("tr", element("th", text_of(trial, "filter"), "scope=row") +
                           number_cell(text_of(trial, "tolerance")) +
                           number_cell(texels(trial.at("mean_error_texel").get<double>())) +
                           verdict_cell(trial) +
                           number_cell(grouped(trial.at("wrong_texels").get<uint64_t>())) +
                           number_cell(different(trial)) +
                           spread_cell(trial.at("textured_ns_per_px")) +
                           spread_cell(trial.at("ns_per_px")));
}

using Trials = std::vector<const json*>;

Trials trials_of(const json& scene, const std::string& filter) {
  Trials trials;
  for (const json& trial : scene.at("trials")) {
    if (trial.at("filter") == filter) trials.push_back(&trial);
  }
  return trials;
}

uint64_t px_of(const json& trial, const std::string& choice) {
  for (const json& one : trial.at("choices")) {
    if (one.at("id") == choice) return one.at("px").get<uint64_t>();
  }
  return 0;
}

// Why a tolerance changes little where the planner picks the filter.
std::string share_of_area(const Trials& trials) {
  const json& exact = *trials.front();
  const auto textured = exact.at("textured_px").get<uint64_t>();
  const uint64_t area = px_of(exact, "exact-area") + px_of(exact, "affine-face-area");
  if (area == 0) return {};
  return (area == textured ? "All of its " + grouped(textured)
                           : grouped(area) + " of its " + grouped(textured)) +
         " textured pixels are on faces that are minified somewhere, which get the area filter. "
         "That filter is exact whatever the tolerance, and costs by far the most; a tolerance "
         "changes such a face only where it admits affine for the whole of it. ";
}

// What a tolerance cannot change at all.
std::string share_of_colours(const Trials& trials) {
  const uint64_t plain = px_of(*trials.front(), "one-colour");
  if (plain == 0) return {};
  return grouped(plain) + " pixels are of one colour, where no map can be wrong. ";
}

std::string first_difference(const Trials& trials) {
  for (const json* trial : trials) {
    if (trial->at("different_px") == 0) continue;
    return "The first picture that differs from the exact one is that within a tolerance of " +
           text_of(*trial, "tolerance") + ", in " +
           grouped(trial->at("different_px").get<uint64_t>()) + " pixels. ";
  }
  return "No pixel differs from the exact picture within any of these tolerances: every row is "
         "drawn exactly, or so that the same texels are met. ";
}

// The tolerances that are no longer used up, for even the cheapest mapping is within less.
std::string unused(const Trials& trials) {
  const json& last = *trials.back();
  for (const json* trial : trials) {
    if (trial == trials.back() || trial->at("choices") != last.at("choices") ||
        trial->at("bound_texel") != last.at("bound_texel"))
      continue;
    return "Beyond a tolerance of " + text_of(*trial, "tolerance") +
           " nothing changes: no bound is above " + texels(last.at("bound_texel").get<double>()) +
           " texel. ";
  }
  return {};
}

// Spreads apart, and medians by more than repetitions of the same calls differ.
inline constexpr double kNotable = 1.03;

double quantile(const json& trial, const char* key) {
  return trial.at("textured_ns_per_px").at(key).get<double>();
}

std::string saving(const Trials& trials) {
  const json& exact = *trials.front();
  if (std::ranges::any_of(trials,
                          [](const json* t) { return t->at("textured_ns_per_px").is_null(); }))
    return {};
  const double ratio = quantile(*trials.back(), "median") / quantile(exact, "median");
  std::string text = "Within " + text_of(*trials.back(), "tolerance") +
                     " texels a textured pixel takes " + rounded(ratio) + " of the exact time. ";
  std::string slower;
  for (const json* trial : trials) {
    if (quantile(*trial, "lower_quartile") > quantile(exact, "upper_quartile") &&
        quantile(*trial, "median") > kNotable * quantile(exact, "median"))
      slower += (slower.empty() ? "" : ", ") + text_of(*trial, "tolerance");
  }
  if (!slower.empty())
    text += "Within " + slower +
            " texel it takes more than the exact one: a tolerance is no gain there.";
  return text;
}

}  // namespace

std::string tolerance_table(const json& scene) {
  std::string rows =
      "<tr><th>filter<th class=n>tolerance,<br>texels<th class=n>mean error,<br>texels"
      "<th>largest error &le; bound &le; tolerance<th class=n>wrong<br>texels<th class=n>pixels of "
      "another<br>colour<th class=n>ns per<br>textured pixel<th class=n>ns per pixel<br>of all "
      "faces</tr>\n";
  for (const json& trial : scene.at("trials")) rows += trial_row(trial);
  return element("div", element("table", rows), "class=wide") +
         element("p",
                 element("small",
                         "Filter nearest: the error is the distance of the exact u or v from the "
                         "texel that was drawn; a wrong texel may be of the same colour. Area: how "
                         "far u or v of the drawn map is from the exact one. Means are over all " +
                             grouped(scene.at("trials").front().at("textured_px").get<uint64_t>()) +
                             " textured pixels."));
}

std::string tolerance_remarks(const json& scene) {
  std::string items;
  for (const std::string filter : {"auto", "nearest"}) {
    const Trials trials = trials_of(scene, filter);
    if (trials.empty()) continue;
    items += element(
        "li", element("strong", filter == "auto" ? "Filter left to the planner" : "All nearest") +
                  ". " +
                  (filter == "auto" ? share_of_colours(trials) + share_of_area(trials) : "") +
                  first_difference(trials) + unused(trials) + saving(trials));
  }
  return element("ul", items);
}

std::string broken_promises(const json& scenes) {
  std::string items;
  for (const json& scene : scenes.at("scenes")) {
    for (const json& trial : scene.at("trials")) {
      if (trial.at("breaches") == 0) continue;
      items += element("li", text_of(scene, "title") + ", filter " + text_of(trial, "filter") +
                                 ", tolerance " + text_of(trial, "tolerance") + ": " +
                                 text_of(trial, "first_breach") + "; " +
                                 grouped(trial.at("breaches").get<uint64_t>()) + " such pixels");
    }
  }
  if (items.empty()) return {};
  return element("p", "Promises are BROKEN, and nothing was timed:", "class=bad") +
         element("ul", items);
}

bool all_timed(const json& scenes) {
  return std::ranges::all_of(scenes.at("scenes"), [](const json& scene) {
    return std::ranges::none_of(scene.at("trials"), [](const json& trial) {
      return trial.at("textured_ns_per_px").is_null();
    });
  });
}

KeptCount kept_promises(const json& scenes) {
  KeptCount count;
  if (scenes.is_null()) return count;
  for (const json& scene : scenes.at("scenes")) {
    for (const json& trial : scene.at("trials")) {
      count.kept += trial.at("breaches") == 0;
      ++count.all;
    }
  }
  return count;
}

}  // namespace selvage::reports
