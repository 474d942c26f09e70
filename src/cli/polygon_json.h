// The polygon file of `selvage draw`.
//
//   {"vertices": [[x, y, u, v], [x, y, u, v, w], {"x": 1, "y": 2, "u": 3, "v": 4, "w": 5}, ...],
//    "clip": [left, top, right, bottom], "address": "clamp" | "wrap", "filter": "nearest"}
//
// or several: {"polygons": [{...}, ...]}. clip, address and filter are optional; beside "polygons"
// they hold for every polygon that does not name its own. A key that is not known, or that stands
// twice in one object, is an error.
#pragma once

#include <string>
#include <string_view>

#include "cli/job.h"

namespace selvage::cli {

// Errors are UserErrors "FILE:LINE: what is wrong".
[[nodiscard]] Job parse_polygon_json(std::string file, std::string_view text);

}  // namespace selvage::cli
