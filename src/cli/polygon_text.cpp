#include "cli/polygon_text.h"

#include <array>
#include <string>

#include "cli/error.h"
#include "cli/number.h"

namespace selvage::cli {
namespace {

constexpr std::string_view kVertexSeparators = " \t\r\n";

[[nodiscard]] std::string in_quotes(std::string_view text) { return "'" + std::string(text) + "'"; }

[[nodiscard]] JobVertex parse_vertex(std::string_view text) {
  const std::vector<std::string_view> fields = split(text, ',');
  if (fields.size() != 4 && fields.size() != 5) {
    throw UserError(in_quotes(text) + " has " + std::to_string(fields.size()) +
                    (fields.size() == 1 ? " number" : " numbers") +
                    "; a vertex is x,y,u,v or x,y,u,v,w without blanks");
  }
  std::array<double, 5> values{0, 0, 0, 0, 1};
  for (size_t i = 0; i < fields.size(); ++i) {
    const std::optional<double> value = parse_double(fields[i]);
    if (!value) {
      throw UserError(in_quotes(fields[i]) + " in " + in_quotes(text) +
                      " is no number; 12, -0.5 and 1e3 are");
    }
    values[i] = *value;
  }
  return {values[0], values[1], values[2], values[3], values[4]};
}

}  // namespace

std::vector<JobVertex> parse_polygon_text(std::string_view text) {
  std::vector<JobVertex> vertices;
  for (;;) {
    const size_t start = text.find_first_not_of(kVertexSeparators);
    if (start == std::string_view::npos) break;
    text.remove_prefix(start);
    const std::string_view vertex = text.substr(0, text.find_first_of(kVertexSeparators));
    text.remove_prefix(vertex.size());
    vertices.push_back(about("vertex " + std::to_string(vertices.size() + 1),
                             [&] { return parse_vertex(vertex); }));
  }
  if (vertices.size() < 3) {
    throw UserError("a polygon needs at least 3 vertices; this one has " +
                    std::to_string(vertices.size()));
  }
  return vertices;
}

selvage_rect parse_clip_text(std::string_view text) {
  const std::vector<std::string_view> fields = split(text, ',');
  std::array<int32_t, 4> sides{};
  bool good = fields.size() == sides.size();
  for (size_t i = 0; good && i < sides.size(); ++i) {
    const std::optional<int32_t> side = parse_integer<int32_t>(fields[i]);
    good = side.has_value();
    sides[i] = side.value_or(0);
  }
  if (!good) {
    throw UserError(in_quotes(text) + " is no clip; left,top,right,bottom in whole pixels is");
  }
  return {sides[0], sides[1], sides[2], sides[3]};
}

Size parse_size_text(std::string_view text, const SizeLimits& limits) {
  const std::vector<std::string_view> fields = split(text, 'x');
  std::optional<int32_t> width;
  std::optional<int32_t> height;
  if (fields.size() == 2) {
    width = parse_integer<int32_t>(fields[0]);
    height = parse_integer<int32_t>(fields[1]);
  }
  if (!width || !height) {
    throw UserError(in_quotes(text) + " is no size; WIDTHxHEIGHT in pixels is, as in 256x192");
  }
  check_size(*width, *height, limits);
  return {*width, *height};
}

}  // namespace selvage::cli
