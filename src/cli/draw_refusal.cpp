#include "cli/draw_refusal.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>

namespace selvage::cli {
namespace {

[[nodiscard]] bool lies_between_pixels(const selvage_vertex& vertex) {
  const auto is_between = [](int32_t at_fx8) { return at_fx8 % SELVAGE_SUBPIXELS != 0; };
  return is_between(vertex.x) || is_between(vertex.y);
}

// The first vertex that the status is about.
[[nodiscard]] std::optional<size_t> blamed(const std::vector<selvage_vertex>& vertices,
                                           selvage_status status) {
  const auto is_blamed = [&](const selvage_vertex& vertex) {
    return status == SELVAGE_ERROR_VERTEX_FRACTION
               ? lies_between_pixels(vertex)
               : status == SELVAGE_ERROR_VERTEX_Q_DIFFERS && vertex.q != vertices.front().q;
  };
  const auto found = std::find_if(vertices.begin(), vertices.end(), is_blamed);
  if (found == vertices.end()) return std::nullopt;
  return static_cast<size_t>(found - vertices.begin());
}

// The status text has the names of selvage.h.
[[nodiscard]] std::string in_options(selvage_status status) {
  switch (status) {
    case SELVAGE_ERROR_FILTER_FORMAT:
      return " (--filter nearest, or --format rgba8888)";
    case SELVAGE_ERROR_FILTER_PROFILE:
      return " (--filter nearest, or --profile exact)";
    case SELVAGE_ERROR_NOT_MONOTONE:
      return " (cut it into convex pieces: those that share an edge leave no gap)";
    case SELVAGE_ERROR_VERTEX_Q_DIFFERS:
      return " (q is 1/w: leave w out, or --profile exact)";
    default:
      return "";
  }
}

}  // namespace

UserError draw_refusal(selvage_status status) {
  return UserError(selvage_status_text(status) + in_options(status));
}

UserError draw_refusal(const Job& job, size_t polygon, const std::vector<selvage_vertex>& vertices,
                       selvage_status status) {
  const std::optional<size_t> vertex = blamed(vertices, status);
  const std::string where = vertex           ? describe_vertex(job, polygon, *vertex) + ": "
                            : job.size() > 1 ? "polygon " + std::to_string(polygon + 1) + ": "
                                             : "";
  return UserError(where + draw_refusal(status).what());
}

}  // namespace selvage::cli
