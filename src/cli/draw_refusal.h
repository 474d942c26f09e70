// What the mapper refuses to draw, in the words of the command line.
#pragma once

#include <cstddef>
#include <vector>

#include "cli/error.h"
#include "cli/job.h"

namespace selvage::cli {

// Of polygon `polygon` of the job, whose vertices on the grid are given: which vertex it is about,
// if that can be told, the library's sentence, and the options that would be right.
[[nodiscard]] UserError draw_refusal(const Job& job, size_t polygon,
                                     const std::vector<selvage_vertex>& vertices,
                                     selvage_status status);
// Of all polygons.
[[nodiscard]] UserError draw_refusal(selvage_status status);

}  // namespace selvage::cli
