#include "cli/polygon_json.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "cli/error.h"

namespace selvage::cli {
namespace {

using nlohmann::json;

constexpr int kMaxDepth = 8;  // {"polygons": [{"vertices": [[x, ... is 5 deep

// Refuses, while the text is read, what a json value no longer shows or should never hold.
class Strictness {
 public:
  bool operator()(int depth, json::parse_event_t event, const json& parsed) {
    if (depth > kMaxDepth) throw UserError("nested deeper than any polygon is");
    if (event == json::parse_event_t::object_start) keys_.emplace_back();
    if (event == json::parse_event_t::object_end) keys_.pop_back();
    if (event == json::parse_event_t::key) {
      const std::string& key = parsed.get_ref<const std::string&>();
      if (!keys_.back().insert(key).second) throw UserError("the key '" + key + "' stands twice");
    }
    return true;
  }

 private:
  std::vector<std::set<std::string>> keys_;
};

[[nodiscard]] json parse_text(std::string_view text) {
  Strictness strictness;
  try {
    return json::parse(text.begin(), text.end(), std::ref(strictness));
  } catch (const json::exception& error) {
    const std::string what = error.what();  // "[json.exception.name.id] explanation"
    const size_t bracket = what.find("] ");
    throw UserError("not JSON: " + what.substr(bracket == std::string::npos ? 0 : bracket + 2));
  }
}

// Error texts may quote what was given, but not megabytes of it.
[[nodiscard]] std::string excerpt(const json& value) {
  const std::string text = value.dump(-1, ' ', true, json::error_handler_t::replace);
  return text.size() <= 60 ? text : text.substr(0, 57) + "...";
}

void require_object(const json& value, const std::vector<std::string>& known) {
  if (!value.is_object()) throw UserError("an object is needed, not " + excerpt(value));
  std::string list;
  for (const std::string& key : known) list += (list.empty() ? "" : ", ") + key;
  for (const auto& item : value.items()) {
    if (std::find(known.begin(), known.end(), item.key()) == known.end()) {
      throw UserError("unknown key " + excerpt(json(item.key())) + "; known here: " + list);
    }
  }
}

[[nodiscard]] double number(const json& value) {
  if (!value.is_number()) throw UserError("a number is needed, not " + excerpt(value));
  return value.get<double>();
}

[[nodiscard]] JobVertex vertex_of_array(const json& value) {
  if (value.size() != 4 && value.size() != 5) {
    throw UserError(excerpt(value) + " has " + std::to_string(value.size()) +
                    " numbers; a vertex is [x, y, u, v] or [x, y, u, v, w]");
  }
  const double w = value.size() == 5 ? number(value[4]) : 1;
  return {number(value[0]), number(value[1]), number(value[2]), number(value[3]), w};
}

[[nodiscard]] JobVertex vertex_of_object(const json& value) {
  require_object(value, {"x", "y", "u", "v", "w"});
  const auto field = [&](const char* key) {
    if (!value.contains(key)) throw UserError("'" + std::string(key) + "' is missing");
    return about(key, [&] { return number(value[key]); });
  };
  const double w = value.contains("w") ? field("w") : 1;
  return {field("x"), field("y"), field("u"), field("v"), w};
}

[[nodiscard]] JobVertex vertex_of(const json& value) {
  if (value.is_array()) return vertex_of_array(value);
  if (value.is_object()) return vertex_of_object(value);
  throw UserError("[x, y, u, v] or an object is needed, not " + excerpt(value));
}

[[nodiscard]] std::vector<JobVertex> vertices_of(const json& value) {
  if (!value.is_array()) throw UserError("an array is needed, not " + excerpt(value));
  std::vector<JobVertex> vertices;
  for (const json& vertex : value) {
    vertices.push_back(
        about("vertex " + std::to_string(vertices.size() + 1), [&] { return vertex_of(vertex); }));
  }
  if (vertices.size() < 3) {
    throw UserError("a polygon needs at least 3 vertices; this one has " +
                    std::to_string(vertices.size()));
  }
  return vertices;
}

[[nodiscard]] selvage_rect clip_of(const json& value) {
  const auto is_side = [](const json& side) {
    return side.is_number_integer() && side.get<double>() >= INT32_MIN &&
           side.get<double>() <= INT32_MAX;
  };
  if (!value.is_array() || value.size() != 4 || !std::all_of(value.begin(), value.end(), is_side)) {
    throw UserError("[left, top, right, bottom] in whole pixels is needed, not " + excerpt(value));
  }
  return {value[0].get<int32_t>(), value[1].get<int32_t>(), value[2].get<int32_t>(),
          value[3].get<int32_t>()};
}

[[nodiscard]] std::string text_of(const json& value) {
  if (!value.is_string()) throw UserError("a text is needed, not " + excerpt(value));
  return value.get<std::string>();
}

// Everything but the vertices; what `value` does not name stays as it is.
void read_settings(const json& value, JobPolygon& polygon) {
  if (value.contains("clip")) {
    polygon.clip = about("clip", [&] { return clip_of(value["clip"]); });
  }
  if (value.contains("profile")) {
    polygon.options.profile =
        about("profile", [&] { return parse_profile(text_of(value["profile"])); });
  }
  if (value.contains("address")) {
    polygon.options.address =
        about("address", [&] { return parse_address(text_of(value["address"])); });
  }
  if (value.contains("filter")) {
    polygon.options.filter =
        about("filter", [&] { return parse_filter(text_of(value["filter"])); });
  }
}

[[nodiscard]] JobPolygon polygon_of(const json& value, JobPolygon defaults) {
  require_object(value, {"vertices", "clip", "address", "filter", "profile"});
  if (!value.contains("vertices")) throw UserError("'vertices' is missing");
  read_settings(value, defaults);
  defaults.vertices = about("vertices", [&] { return vertices_of(value["vertices"]); });
  return defaults;
}

[[nodiscard]] Job polygons_of(const json& value) {
  require_object(value, {"polygons", "clip", "address", "filter", "profile"});
  JobPolygon defaults;
  read_settings(value, defaults);
  const json& polygons = value["polygons"];
  if (!polygons.is_array() || polygons.empty()) {
    throw UserError("polygons: an array of at least one polygon is needed, not " +
                    excerpt(polygons));
  }
  Job job;
  for (const json& polygon : polygons) {
    job.push_back(about("polygon " + std::to_string(job.size() + 1),
                        [&] { return polygon_of(polygon, defaults); }));
  }
  return job;
}

}  // namespace

Job parse_polygon_json(std::string_view text) {
  const json value = parse_text(text);
  if (value.is_object() && value.contains("polygons")) return polygons_of(value);
  if (value.is_object() && !value.contains("vertices")) {
    throw UserError("'vertices' is missing (or 'polygons', for several)");
  }
  return {polygon_of(value, {})};
}

}  // namespace selvage::cli
