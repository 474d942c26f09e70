// What `selvage draw` is asked to draw: polygons as people write them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "selvage.h"

namespace selvage::cli {

struct JobVertex {
  double x_px = 0, y_px = 0;
  double u_texel = 0, v_texel = 0;
  double w = 1;  // distance along the view axis
  friend bool operator==(const JobVertex&, const JobVertex&) = default;
};

struct JobPolygon {
  std::vector<JobVertex> vertices;
  std::optional<selvage_rect> clip;
  selvage_options options{};
};

using Job = std::vector<JobPolygon>;

// "exact", "abrash56", "abrash57", "dkit"; "clamp", "wrap"; "nearest",
// "four", "bilinear", "area".
[[nodiscard]] selvage_profile parse_profile(std::string_view name);
[[nodiscard]] selvage_address parse_address(std::string_view name);
[[nodiscard]] selvage_filter parse_filter(std::string_view name);
// A tolerance that is given, in texels, whether as text or as a number; else a UserError.
[[nodiscard]] double parse_tolerance(std::string_view texels);
[[nodiscard]] double checked_tolerance(double texels);
[[nodiscard]] std::string_view filter_name(selvage_filter filter);  // as parse_filter takes it
// "exact perspective", "subdivided", ...
[[nodiscard]] std::string_view method_name(selvage_method method);
// "fastest", "scalar", "sse4", ...
[[nodiscard]] std::string_view kernel_name(selvage_kernel kernel);

// "polygon 2, vertex 1 (x 10, y 20, ...)", as errors begin; of a job of one polygon without it.
[[nodiscard]] std::string describe_vertex(const Job& job, size_t polygon, size_t vertex);

// Each polygon's vertices on the mapper's grid. The least w of the whole job is the near one, so
// that polygons that share an edge agree on it. Errors name the polygon and the vertex.
[[nodiscard]] std::vector<std::vector<selvage_vertex>> snap(const Job& job);

}  // namespace selvage::cli
