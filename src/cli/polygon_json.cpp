#include "cli/polygon_json.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/error.h"
#include "cli/located_json.h"

namespace selvage::cli {
namespace {

using nlohmann::json;

[[nodiscard]] JobVertex vertex_of_array(const JsonNode& node) {
  const std::vector<JsonNode> parts = node.elements("number");
  if (parts.size() != 4 && parts.size() != 5) {
    node.fail(excerpt(node.value()) + " has " + std::to_string(parts.size()) +
              " numbers; a vertex is [x, y, u, v] or [x, y, u, v, w]");
  }
  const double w = parts.size() == 5 ? parts[4].number() : 1;
  return {parts[0].number(), parts[1].number(), parts[2].number(), parts[3].number(), w};
}

[[nodiscard]] JobVertex vertex_of_object(const JsonNode& node) {
  node.expect_keys({"x", "y", "u", "v", "w"});
  const double w = node.has("w") ? node.at("w").number() : 1;
  return {node.at("x").number(), node.at("y").number(), node.at("u").number(),
          node.at("v").number(), w};
}

[[nodiscard]] JobVertex vertex_of(const JsonNode& node) {
  if (node.value().is_array()) return vertex_of_array(node);
  if (node.value().is_object()) return vertex_of_object(node);
  node.fail_for("[x, y, u, v] or an object");
}

[[nodiscard]] std::vector<JobVertex> vertices_of(const JsonNode& node) {
  std::vector<JobVertex> vertices;
  for (const JsonNode& vertex : node.elements("vertex")) vertices.push_back(vertex_of(vertex));
  if (vertices.size() < 3) {
    node.fail("a polygon needs at least 3 vertices; this one has " +
              std::to_string(vertices.size()));
  }
  return vertices;
}

[[nodiscard]] selvage_rect clip_of(const JsonNode& node) {
  const json& value = node.value();
  const auto is_side = [](const json& side) {
    return side.is_number_integer() && side.get<double>() >= INT32_MIN &&
           side.get<double>() <= INT32_MAX;
  };
  if (!value.is_array() || value.size() != 4 || !std::all_of(value.begin(), value.end(), is_side)) {
    node.fail_for("[left, top, right, bottom] in whole pixels");
  }
  return {value[0].get<int32_t>(), value[1].get<int32_t>(), value[2].get<int32_t>(),
          value[3].get<int32_t>()};
}

// The name at a key, if there is one, as `parse` has it.
template <typename Parse, typename Value>
void set_name(const JsonNode& node, const char* key, Parse parse, Value& value) {
  if (!node.has(key)) return;
  const JsonNode name = node.at(key);
  const std::string& text = name.text();
  value = name.about([&] { return parse(text); });
}

// Everything but the vertices; what the node does not name stays as it is.
void read_settings(const JsonNode& node, JobPolygon& polygon) {
  if (node.has("clip")) polygon.clip = clip_of(node.at("clip"));
  set_name(node, "profile", parse_profile, polygon.options.profile);
  set_name(node, "address", parse_address, polygon.options.address);
  set_name(node, "filter", parse_filter, polygon.options.filter);
}

[[nodiscard]] JobPolygon polygon_of(const JsonNode& node, JobPolygon defaults) {
  node.expect_keys({"vertices", "clip", "address", "filter", "profile"});
  read_settings(node, defaults);
  defaults.vertices = vertices_of(node.at("vertices"));
  return defaults;
}

[[nodiscard]] Job polygons_of(const JsonNode& node) {
  node.expect_keys({"polygons", "clip", "address", "filter", "profile"});
  JobPolygon defaults;
  read_settings(node, defaults);
  const JsonNode polygons = node.at("polygons");
  if (!polygons.value().is_array() || polygons.value().empty()) {
    polygons.fail_for("an array of at least one polygon");
  }
  Job job;
  for (const JsonNode& polygon : polygons.elements("polygon")) {
    job.push_back(polygon_of(polygon, defaults));
  }
  return job;
}

}  // namespace

Job parse_polygon_json(std::string file, std::string_view text) {
  const LocatedJson located = parse_located(std::move(file), text);
  const JsonNode root(located);
  if (root.has("polygons")) return polygons_of(root);
  if (located.value.is_object() && !root.has("vertices")) {
    root.fail("'vertices' is missing (or 'polygons', for several)");
  }
  return {polygon_of(root, {})};
}

}  // namespace selvage::cli
