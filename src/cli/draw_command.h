// `selvage draw`: a picture onto polygons over a background, to PNG.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/bitmap.h"
#include "cli/console.h"
#include "cli/job.h"

namespace selvage::cli {

struct DrawOptions {
  std::string texture;                // PNG or JPEG
  std::vector<std::string> polygons;  // each as for parse_polygon_text
  std::string polygon_file;           // JSON; either this or `polygons`
  std::string size;                   // empty: the size of the background picture
  std::string background = "#000000";
  std::string clip, address, filter, profile, tolerance;  // empty: what the polygon file says
  std::string format = "rgba8888";
  std::string output;
  int32_t threads = 0;  // at most; 0: all that there are
  bool json = false;
};

// Draws every polygon of the job, in order, and returns the time that it took.
int64_t draw_job_ns(const Job& job, const Bitmap& texture, Bitmap& target, int32_t threads);

// The pixels of a picture of this size that at least one polygon covers.
[[nodiscard]] int64_t covered_px(const Job& job, int32_t width_px, int32_t height_px);

int run_draw(const DrawOptions& options, const Console& console);

}  // namespace selvage::cli
