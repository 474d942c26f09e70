// Bytes -> a polygon file -> the mapper's vertices. What is accepted must be inside their ranges.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "cli/error.h"
#include "cli/polygon_json.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace selvage::cli;
  try {
    const Job job = parse_polygon_json("polygon.json", {reinterpret_cast<const char*>(data), size});
    if (job.empty()) std::abort();
    for (const JobPolygon& polygon : job) {
      if (polygon.vertices.size() < 3) std::abort();
    }
    for (const std::vector<selvage_vertex>& polygon : snap(job)) {
      for (const selvage_vertex& vertex : polygon) {
        if (vertex.x < SELVAGE_X_MIN || vertex.x >= SELVAGE_X_END) std::abort();
        if (vertex.y < SELVAGE_X_MIN || vertex.y >= SELVAGE_X_END) std::abort();
        if (vertex.q < 1 || vertex.q > SELVAGE_Q_MAX) std::abort();
      }
    }
  } catch (const UserError&) {
    // A clear refusal is a right answer; anything else that is thrown ends the program.
  }
  return 0;
}
