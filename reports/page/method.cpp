// The head of the page, and how it was made.
#include <algorithm>

#include "reports/page/html.h"
#include "reports/page/scenes.h"
#include "reports/page/sections.h"

namespace selvage::reports {

namespace {

using json = nlohmann::ordered_json;

struct Tally {
  size_t good = 0, all = 0;
};

Tally laws_of(const Results& results) {
  Tally tally;
  for (const json& law : results.verify.at("laws")) tally.good += law.at("verdict") == "holds";
  tally.all = results.verify.at("laws").size();
  return tally;
}

// Of the cells that promise something: within a derived bound, or exact.
Tally promises_of(const Results& results) {
  Tally tally;
  const json& arithmetics = results.stability.at("arithmetics");
  for (const json& family : results.stability.at("families")) {
    for (size_t i = 0; i < arithmetics.size(); ++i) {
      if (arithmetics[i].at("promise") == "none") continue;
      ++tally.all;
      tally.good += family.at("cells")[i].at("kept").get<bool>();
    }
  }
  return tally;
}

Tally pictures_of(const Results& results) {
  Tally tally;
  for (const json& scene : results.gallery) tally.good += scene.at("differing_px") == 0;
  tally.all = results.gallery.size();
  return tally;
}

std::string tally_item(const std::string& what, const Tally& tally) {
  const std::string count = std::to_string(tally.good) + " of " + std::to_string(tally.all);
  return element(
      "li",
      element("strong", count, tally.good == tally.all ? "class=good" : "class=bad") + " " + what);
}

std::string scenes_item(const json& scenes) {
  const KeptCount count = kept_promises(scenes);
  if (count.all == 0) return "";
  return tally_item(
      "drawings of the <a href=#scenes>scenes</a> are within their tolerance in every pixel",
      {count.kept, count.all});
}

// What other mappers break is no tally of ours: the table says what it means.
std::string matrix_item(const json& matrix) {
  if (matrix.is_null()) return "";
  const auto of_group = [&](const char* group) {
    const json& all = matrix.at("subjects");
    return std::to_string(std::ranges::count_if(
        all, [&](const json& subject) { return subject.at("group") == group; }));
  };
  return element("li", "<a href=#matrix>Subjects against laws</a>: " + of_group("ours") +
                           " mappers of ours and " + of_group("peers") +
                           " of other projects, each held against what it promises");
}

// Of all mutants of the mapper; of a sample, or of none, nothing is said.
std::string mutants_item(const json& score) {
  if (score.is_null() || !score.at("whole").get<bool>()) return "";
  const size_t killed = score.at("killed"), alive = score.at("survivors");
  return tally_item("mutants of the mapper are noticed by the laws and the tests, of " +
                        escaped(score.at("revision").get<std::string>()) + "; " +
                        std::to_string(score.at("equivalent").get<size_t>()) +
                        " more are recorded as equivalent, each with its reason",
                    {killed, killed + alive});
}

std::string machine_table(const json& machine) {
  std::string rows;
  for (const auto& [key, value] : machine.items()) {
    std::string name = key;
    std::replace(name.begin(), name.end(), '_', ' ');
    rows += element("tr", element("th", escaped(name), "scope=row") +
                              element("td", escaped(value.is_string() ? value.get<std::string>()
                                                                      : value.dump())));
  }
  return element("div", element("table", rows), "class=wide");
}

std::string limits() {
  return element(
      "ul",
      element(
          "li",
          "Times are of one run on one machine, which may be shared with other work; the "
          "quartiles show how much they moved. A ratio within the quartiles is no difference.") +
          element(
              "li",
              "Everything runs on one core, but for the curves against threads. The mapper and the "
              "inexact vector loops choose their SIMD code at run time, and so do most of the "
              "peers that are the distribution's libraries. The arithmetics beside them are "
              "compiled for the baseline of the architecture, and so is AGG, which is all "
              "headers.") +
          element(
              "li",
              "pixman and AGG are asked for pixels of 24 bits in 32, the only ones that they copy "
              "without a look at alpha: of their texels t is compared modulo 256, of their "
              "filtered "
              "colours three channels.") +
          element(
              "li",
              "OpenCV warps rectangles: it walks the whole bounding box, and which pixels it "
              "covers follows from texels in and out of the texture, not from edges. Its missing "
              "and extra pixels are those of a use it was not made for; its wrong texels are "
              "pixels it does cover.") +
          element("li",
                  "The historic profiles take whole pixels only: what they draw is the work item "
                  "with its vertices rounded, beforehand, and their errors are mostly that.") +
          element("li",
                  "A pixel that a mapper draws twice for one polygon is not seen: the pictures are "
                  "all that is asked of it.") +
          element("li",
                  "Error counts come from the sampled rows, not from every pixel, and are those of "
                  "one picture each.") +
          element("li", "The laws hold for the cases that were tried, not for all there are."));
}

// Links to what the page was made of.
std::string files_of(const Results& results) {
  const std::pair<const char*, const json*> files[] = {
      {"verify.json", &results.verify},       {"matrix.json", &results.matrix},
      {"scenes.json", &results.scenes},       {"gallery.json", &results.gallery},
      {"stability.json", &results.stability}, {"bench.json", &results.bench}};
  std::string links;
  for (const auto& [name, values] : files) {
    if (values->is_null()) continue;
    const std::string file = name;
    links += (links.empty() ? "<a href=" : ", <a href=") + file + ">" + file + "</a>";
  }
  return links;
}

}  // namespace

std::string summary_line(const Results& results) {
  const Tally laws = laws_of(results), pictures = pictures_of(results);
  const Tally promises = promises_of(results);
  const KeptCount drawings = kept_promises(results.scenes);
  const std::string scenes = drawings.all == 0
                                 ? ""
                                 : ", " + std::to_string(drawings.kept) + " of " +
                                       std::to_string(drawings.all) +
                                       " drawings of scenes are within their tolerance";
  return std::to_string(laws.good) + " of " + std::to_string(laws.all) + " laws hold, " +
         std::to_string(pictures.good) + " of " + std::to_string(pictures.all) +
         " pictures equal the exact model's" + scenes + ", " + std::to_string(promises.good) +
         " of " + std::to_string(promises.all) + " promises of stability are kept";
}

std::string summary_section(const Results& results) {
  return element("h1", "Selvage: what it draws, and what it costs") + scenes_head(results.scenes) +
         element(
             "ul",
             tally_item("<a href=#laws>laws</a> hold for the built-in mapper", laws_of(results)) +
                 tally_item("<a href=#gallery>pictures</a> equal the exact model's in every pixel",
                            pictures_of(results)) +
                 tally_item(
                     "<a href=#stability>cells of the stability table</a> that promise to be "
                     "exact, or within a derived bound, are",
                     promises_of(results)) +
                 scenes_item(results.scenes) + mutants_item(results.mutants) +
                 matrix_item(results.matrix) +
                 element("li",
                         "<a href=#speed>Speed against error</a>, beside the usual arithmetics, "
                         "the mappers of other projects, a solid fill and a memcpy") +
                 element("li", "<a href=#method>How this was made</a>, and what it does not show"));
}

std::string method_section(const Results& results) {
  std::string html = element("h2", "How this was made", "id=method");
  html += element("p", "Source: " + element("code", escaped(results.revision)) +
                           ". The commands that make it again, from a checkout on Debian 12:");
  html += element("pre", escaped(results.command));
  if (!results.bench.is_null()) {
    html += element("h3", "The machine") + machine_table(results.bench.at("machine"));
    for (const auto& [peer, text] : results.bench.at("build_information").items()) {
      html += element("details", element("summary", "Build information of " + escaped(peer)) +
                                     element("pre", escaped(text.get<std::string>())));
    }
  }
  html += element("h3", "What it does not show") + limits();
  html += element("p", "The numbers of this page as files: " + files_of(results) + ".");
  return html;
}

}  // namespace selvage::reports
