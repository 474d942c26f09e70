#include "cli/job.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "cli/error.h"
#include "cli/number.h"
#include "scene/tolerance.h"
#include "spec/profiles.h"

namespace selvage::cli {
namespace {

[[nodiscard]] double least_w(const Job& job) {
  double least = 0;
  for (size_t p = 0; p < job.size(); ++p) {
    for (size_t i = 0; i < job[p].vertices.size(); ++i) {
      const double w = job[p].vertices[i].w;
      if (!(w > 0))
        throw UserError(describe_vertex(job, p, i) + ": w is a distance, greater than 0");
      least = least == 0 ? w : std::min(least, w);
    }
  }
  return least;
}

[[nodiscard]] UserError no_tolerance(const std::string& given) {
  return UserError("'" + given + "' is no tolerance; 0 to " + show(scene::kMostTolerance_texel) +
                   " texels are");
}

}  // namespace

selvage_profile parse_profile(std::string_view name) {
  if (const spec::Profile* profile = spec::find_profile(name)) return profile->id;
  std::string known;
  for (const spec::Profile& profile : spec::profiles()) known += " " + std::string(profile.name);
  throw UserError("'" + std::string(name) + "' is no profile; the profiles are" + known);
}

selvage_address parse_address(std::string_view name) {
  if (name == "clamp") return SELVAGE_ADDRESS_CLAMP;
  if (name == "wrap") return SELVAGE_ADDRESS_WRAP;
  throw UserError("'" + std::string(name) + "' is no address mode; clamp and wrap are");
}

selvage_filter parse_filter(std::string_view name) {
  if (name == "nearest") return SELVAGE_FILTER_NEAREST;
  if (name == "four") return SELVAGE_FILTER_FOUR;
  if (name == "bilinear") return SELVAGE_FILTER_BILINEAR;
  if (name == "area") return SELVAGE_FILTER_AREA;
  throw UserError("'" + std::string(name) + "' is no filter; nearest, four, bilinear and area are");
}

double checked_tolerance(double texels) {
  if (texels >= 0 && texels <= scene::kMostTolerance_texel) return texels;
  throw no_tolerance(show(texels));
}

double parse_tolerance(std::string_view texels) {
  if (const std::optional<double> value = parse_double(texels)) return checked_tolerance(*value);
  throw no_tolerance(std::string(texels));
}

std::string_view filter_name(selvage_filter filter) {
  constexpr std::array<std::string_view, SELVAGE_FILTER_AREA + 1> kNames = {"nearest", "four",
                                                                            "bilinear", "area"};
  return kNames[static_cast<size_t>(filter)];
}

std::string_view method_name(selvage_method method) {
  constexpr std::array<std::string_view, SELVAGE_METHOD_HISTORIC + 1> kNames = {
      "nothing drawn", "copy",         "affine for perspective",
      "subdivided",    "exact affine", "exact perspective",
      "filter",        "historic"};
  return kNames[static_cast<size_t>(method)];
}

std::string_view kernel_name(selvage_kernel kernel) {
  constexpr std::array<std::string_view, SELVAGE_KERNEL_NEON + 1> kNames = {
      "fastest", "scalar", "sse4", "avx2", "avx512", "neon"};
  return kNames[static_cast<size_t>(kernel)];
}

std::string describe_vertex(const Job& job, size_t polygon, size_t vertex) {
  const JobVertex& at = job[polygon].vertices[vertex];
  const std::string which = job.size() > 1 ? "polygon " + std::to_string(polygon + 1) + ", " : "";
  return which + "vertex " + std::to_string(vertex + 1) + " (x " + show(at.x_px) + ", y " +
         show(at.y_px) + ", u " + show(at.u_texel) + ", v " + show(at.v_texel) + ", w " +
         show(at.w) + ")";
}

std::vector<std::vector<selvage_vertex>> snap(const Job& job) {
  const double w_near = least_w(job);
  std::vector<std::vector<selvage_vertex>> polygons(job.size());
  for (size_t p = 0; p < job.size(); ++p) {
    for (size_t i = 0; i < job[p].vertices.size(); ++i) {
      const JobVertex& at = job[p].vertices[i];
      selvage_vertex& vertex = polygons[p].emplace_back();
      const selvage_status status =
          selvage_snap(at.x_px, at.y_px, at.u_texel, at.v_texel, at.w, w_near, &vertex);
      if (status != SELVAGE_OK) {
        throw UserError(
            describe_vertex(job, p, i) + ": " +
            (status == SELVAGE_ERROR_SNAP_W
                 ? "w must be above 0, and at most 2^25 times the least w of all vertices"
                 : selvage_status_text(status)));
      }
    }
  }
  return polygons;
}

}  // namespace selvage::cli
