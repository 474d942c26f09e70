#include "reports/page/plots.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>

#include "reports/page/html.h"
#include "reports/page/measurements.h"

namespace selvage::reports {

namespace {

using json = nlohmann::ordered_json;

constexpr double kPlaceWithoutErrors = -0.95, kHalfSpread = 0.55;
constexpr double kRightEnd = 6.1, kFarAbove = 1000;  // of the plane; times the topmost of the front

struct Point {
  std::string name;
  double place, ns, lower_ns, upper_ns;
  int group, number;
  bool flawless;
};

// The colours of plane.gp, from 1.
int group_number(const std::string& group) {
  constexpr std::array<const char*, 4> groups{"ours", "historic", "usual", "peers"};
  const auto found = std::find(groups.begin(), groups.end(), group);
  return static_cast<int>(found - groups.begin()) % 4 + 1;
}

// Colour and shape of each subject: the same in all plots of a run.
std::map<std::string, std::pair<int, int>> styles(const json& bench) {
  std::map<std::string, std::pair<int, int>> styles;
  std::map<int, int> count;
  for (const json& subject : bench.at("subjects")) {
    const int group = group_number(subject.at("group").get<std::string>());
    styles[subject.at("id").get<std::string>()] = {group, ++count[group]};
  }
  return styles;
}

// Those without errors side by side: they would hide each other.
void spread_flawless(std::vector<Point>& points) {
  const auto count = std::ranges::count_if(points, &Point::flawless);
  double index = 0;
  for (Point& point : points) {
    if (!point.flawless) continue;
    const double share = count < 2 ? 0.5 : index++ / static_cast<double>(count - 1);
    point.place = kPlaceWithoutErrors + kHalfSpread * (2 * share - 1);
  }
}

std::vector<Point> points_of(const json& work, const json& bench) {
  const auto style = styles(bench);
  std::vector<Point> points;
  for (const json& result : work.at("results")) {
    if (!has_errors(result)) continue;
    const auto id = result.at("id").get<std::string>();
    const json& time = result.at("ns_per_px");
    const double errors = errors_per_million(result);
    const auto [group, number] = style.at(id);
    points.push_back({id, errors > 0 ? std::max(std::log10(errors), 0.0) : 0,
                      time.at("median").get<double>(), time.at("lower_quartile").get<double>(),
                      time.at("upper_quartile").get<double>(), group, number, errors == 0});
  }
  spread_flawless(points);
  return points;
}

// Those that no other beats in both, from the fewest errors on; a point without errors counts as
// left of all with some.
std::vector<Point> front_of(std::vector<Point> points) {
  std::ranges::sort(points, [](const Point& a, const Point& b) {
    if (a.flawless != b.flawless) return a.flawless;
    if (a.flawless || a.place == b.place) return a.ns < b.ns;
    return a.place < b.place;
  });
  std::vector<Point> front;
  for (const Point& point : points) {
    if (front.empty() || point.ns < front.back().ns) front.push_back(point);
  }
  return front;
}

std::string line(const std::vector<std::string>& cells) {
  std::string text;
  for (const std::string& cell : cells) text += (text.empty() ? "" : "\t") + cell;
  return text + "\n";
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

std::string plane(const json& work, const json& bench) {
  const std::vector<Point> points = points_of(work, bench);
  std::string text;
  for (const Point& p : points) {
    text += line({p.name, number(p.place), number(p.ns), number(p.lower_ns), number(p.upper_ns),
                  std::to_string(p.group), std::to_string(p.number)});
  }
  text += "\n\n";
  const std::vector<Point> front = front_of(points);
  text += line({number(front.front().place), number(front.front().ns * kFarAbove)});
  for (const Point& p : front) text += line({number(p.place), number(p.ns)});
  text += line({number(kRightEnd), number(front.back().ns)});
  text += "\n\n";
  for (const auto& [id, name] : {std::pair("fill", "solid fill"), std::pair("memcpy", "memcpy"),
                                 std::pair("touch", "needed lines and a fill")}) {
    const json* result = result_of(work, id);
    if (result != nullptr)
      text += line({name, number(result->at("ns_per_px").at("median").get<double>())});
  }
  return text;
}

// "1/16", "0.5" as "1/2", "256", "4 Ki", "1 Mi".
std::string tic(double x) {
  constexpr double kibi = 1024, mebi = kibi * kibi;
  if (x < 1) return "1/" + number(1 / x);
  if (x >= mebi && std::fmod(x, mebi) == 0) return number(x / mebi) + " Mi";
  if (x >= kibi && std::fmod(x, kibi) == 0) return number(x / kibi) + " Ki";
  return number(x);
}

// On the axis: quantities by their ratios, so each by its logarithm; directions have no ratios, and
// crowd at 90 degrees, so they stand side by side.
double place_of(const json& curve, size_t index) {
  const double x = curve.at("points")[index].at("x").get<double>();
  return curve.at("id") == "direction" ? static_cast<double>(index) : std::log2(x);
}

std::string curve(const json& curve) {
  std::vector<std::string> ids, head{curve.at("axis").get<std::string>(), ""};
  for (const json& result : curve.at("points").front().at("results"))
    ids.push_back(result.at("id").get<std::string>());
  for (const std::string& id : ids) head.insert(head.end(), {id, "", ""});
  std::string text = line(head);
  for (size_t i = 0; i < curve.at("points").size(); ++i) {
    const json& point = curve["points"][i];
    std::vector<std::string> cells{tic(point.at("x").get<double>()), number(place_of(curve, i))};
    for (const std::string& id : ids) {
      const json* result = result_of(point, id);
      for (const char* key : {"median", "lower_quartile", "upper_quartile"})
        cells.push_back(result == nullptr ? "NaN"
                                          : number(result->at("ns_per_px").at(key).get<double>()));
    }
    text += line(cells);
  }
  return text;
}

}  // namespace

const json* result_of(const json& item, const std::string& subject) {
  for (const json& result : item.at("results")) {
    if (result.at("id") == subject && !result.contains("refusal")) return &result;
  }
  return nullptr;
}

bool has_errors(const json& result) {
  return !result.contains("refusal") &&
         !(result.at("wrong_texels").is_null() && result.at("wrong_colours").is_null());
}

double errors_per_million(const json& result) {
  double errors = 0;
  for (const char* key : {"wrong_texels", "wrong_colours", "missing_px", "extra_px", "double_px"}) {
    if (!result.at(key).is_null()) errors += result[key].get<double>();
  }
  return errors * 1e6 / result.at("covered_px").get<double>();
}

std::string error_share(const json& result) {
  constexpr double percent = 10000;  // millionths
  const double errors = errors_per_million(result);
  return errors < percent ? rounded(errors) + " ppm" : rounded(errors / percent) + " %";
}

std::vector<PlotFile> plot_files(const json& bench) {
  std::vector<PlotFile> files;
  for (const json& work : bench.at("workloads")) {
    const auto& results = work.at("results");
    if (!is_adversarial(bench, work) && std::any_of(results.begin(), results.end(), has_errors))
      files.push_back({work.at("id").get<std::string>() + ".plane.dat", plane(work, bench)});
  }
  for (const json& one : bench.at("curves"))
    files.push_back({one.at("id").get<std::string>() + ".curve.dat", curve(one)});
  return files;
}

}  // namespace selvage::reports
