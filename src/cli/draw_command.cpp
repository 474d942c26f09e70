#include "cli/draw_command.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <system_error>
#include <utility>

#include "cli/draw_refusal.h"
#include "cli/error.h"
#include "cli/file.h"
#include "cli/json_text.h"
#include "cli/picture_file.h"
#include "cli/picture_output.h"
#include "cli/png.h"
#include "cli/polygon_json.h"
#include "cli/polygon_text.h"
#include "cli/status_line.h"

namespace selvage::cli {
namespace {

[[nodiscard]] Job read_polygons(const DrawOptions& options) {
  if (options.polygons.empty() == options.polygon_file.empty()) {
    throw UserError("exactly one of --polygon and --polygon-file is needed");
  }
  if (!options.polygon_file.empty()) {
    return parse_polygon_json(options.polygon_file, read_text_file(options.polygon_file));
  }
  Job job;
  for (const std::string& text : options.polygons) {
    const std::string which =
        options.polygons.size() > 1 ? " " + std::to_string(job.size() + 1) : "";
    job.emplace_back().vertices =
        about("--polygon" + which, [&] { return parse_polygon_text(text); });
  }
  return job;
}

// The command line wins over the polygon file.
[[nodiscard]] Job read_job(const DrawOptions& options) {
  Job job = read_polygons(options);
  for (JobPolygon& polygon : job) {
    if (!options.clip.empty()) {
      polygon.clip = about("--clip", [&] { return parse_clip_text(options.clip); });
    }
    if (!options.profile.empty()) {
      polygon.options.profile = about("--profile", [&] { return parse_profile(options.profile); });
    }
    if (!options.address.empty()) {
      polygon.options.address = about("--address", [&] { return parse_address(options.address); });
    }
    if (!options.tolerance.empty()) {
      constexpr double kUnits = SELVAGE_SUBTEXELS;
      const double texels =
          about("--tolerance", [&] { return parse_tolerance(options.tolerance); });
      polygon.options.tolerance = static_cast<int32_t>(texels * kUnits);
    }
    if (!options.filter.empty()) {
      polygon.options.filter = about("--filter", [&] { return parse_filter(options.filter); });
    }
  }
  return job;
}

[[nodiscard]] Raster read_background(const DrawOptions& options) {
  std::optional<Size> size;
  if (!options.size.empty()) {
    size = about("--size", [&] { return parse_size_text(options.size); });
  }
  if (options.background.empty()) throw UserError("--background: a colour or a file is needed");
  if (options.background.front() == '#') {
    const Colour colour = about("--background", [&] { return parse_colour(options.background); });
    if (!size) throw UserError("--size is needed, for the background is not a picture");
    return filled(size->width_px, size->height_px, colour);
  }
  std::error_code unreadable;
  if (!std::filesystem::exists(options.background, unreadable) || unreadable) {
    throw UserError("--background: '" + options.background +
                    "' is neither a colour (#rgb, #rrggbb or #rrggbbaa) nor a file");
  }
  Raster picture = read_picture(options.background);
  if (size && (size->width_px != picture.width_px || size->height_px != picture.height_px)) {
    throw UserError("--size " + options.size + " is not the size of the background '" +
                    options.background + "', " + std::to_string(picture.width_px) + "x" +
                    std::to_string(picture.height_px) + "; leave --size out");
  }
  return picture;
}

// Polygons that follow one another and can be drawn in one call.
[[nodiscard]] size_t end_of_call(const Job& job, size_t first) {
  const auto differs = [&](const JobPolygon& polygon) {
    const std::optional<selvage_rect>&clip = polygon.clip, &common = job[first].clip;
    const bool same_clip = clip.has_value() == common.has_value() &&
                           (!clip || std::memcmp(&*clip, &*common, sizeof *clip) == 0);
    return !same_clip ||
           std::memcmp(&polygon.options, &job[first].options, sizeof polygon.options) != 0;
  };
  const auto from = job.begin() + static_cast<ptrdiff_t>(first);
  return static_cast<size_t>(std::find_if(from, job.end(), differs) - job.begin());
}

void draw_call(const Job& job, size_t first, std::span<const selvage_polygon> polygons,
               const std::vector<std::vector<selvage_vertex>>& vertices, const selvage_image& image,
               int32_t threads) {
  std::vector<std::byte> scratch(selvage_draw_many_bytes(polygons.size()));
  size_t failed = polygons.size();
  const std::optional<selvage_rect>& clip = job[first].clip;
  const selvage_status status =
      selvage_draw_many(&image, clip ? &*clip : nullptr, polygons.data(), polygons.size(),
                        &job[first].options, threads, scratch.data(), scratch.size(), &failed);
  if (status == SELVAGE_OK) return;
  if (failed == polygons.size()) throw draw_refusal(status);
  throw draw_refusal(job, first + failed, vertices[first + failed], status);
}

void draw_all(const Job& job, const std::vector<std::vector<selvage_vertex>>& vertices,
              const Bitmap& texture, Bitmap& target, int32_t threads) {
  const selvage_image image = target.image();
  const selvage_texture source = texture.texture();
  std::vector<selvage_polygon> polygons;
  for (const auto& outline : vertices)
    polygons.push_back({outline.data(), outline.size(), &source});
  for (size_t first = 0, end; first < job.size(); first = end) {
    end = end_of_call(job, first);
    draw_call(job, first, std::span(polygons).subspan(first, end - first), vertices, image,
              threads);
  }
}

// What each polygon is drawn by, as a whole and how many of its rows by what.
[[nodiscard]] nlohmann::ordered_json methods(const Job& job, const Bitmap& texture,
                                             Bitmap& target) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  const std::vector<std::vector<selvage_vertex>> vertices = snap(job);
  const selvage_image image = target.image();
  const selvage_texture source = texture.texture();
  for (size_t i = 0; i < job.size(); ++i) {
    const auto choice_within = [&](const selvage_rect& clip) {
      selvage_choice choice{};
      const selvage_status status = selvage_choose(
          &image, &clip, vertices[i].data(), vertices[i].size(), &source, &job[i].options, &choice);
      if (status != SELVAGE_OK) throw draw_refusal(job, i, vertices[i], status);
      return choice;
    };
    const selvage_rect clip = job[i].clip.value_or(selvage_rect{0, 0, image.width, image.height});
    const selvage_choice choice = choice_within(clip);
    nlohmann::ordered_json rows = nlohmann::ordered_json::object();
    for (int32_t y = std::max(clip.top, 0); y < std::min(clip.bottom, image.height); ++y) {
      const selvage_method of_row = choice_within({clip.left, y, clip.right, y + 1}).method;
      if (of_row == SELVAGE_METHOD_NONE) continue;
      nlohmann::ordered_json& count = rows[method_name(of_row)];
      count = count.is_null() ? 1 : count.get<int32_t>() + 1;
    }
    all.push_back({{"method", method_name(choice.method)},
                   {"segment_px", choice.segment_px},
                   {"bound_texel", choice.bound / double{SELVAGE_SUBTEXELS}},
                   {"rows", std::move(rows)}});
  }
  return all;
}

void report(const DrawOptions& options, const Job& job, const Raster& picture, int64_t covered,
            int64_t time_ns, nlohmann::ordered_json methods, const Console& console) {
  const nlohmann::ordered_json values = {
      {"output", options.output},
      {"width_px", picture.width_px},
      {"height_px", picture.height_px},
      {"format", format_name(parse_format(options.format))},
      {"polygons", job.size()},
      {"covered_px", covered},
      {"draw_ns", time_ns},
      {"methods", std::move(methods)},
  };
  console.out << json_text(values);
}

}  // namespace

int64_t draw_job_ns(const Job& job, const Bitmap& texture, Bitmap& target, int32_t threads) {
  const std::vector<std::vector<selvage_vertex>> vertices = snap(job);
  const auto start = std::chrono::steady_clock::now();
  draw_all(job, vertices, texture, target, threads);
  return std::chrono::nanoseconds(std::chrono::steady_clock::now() - start).count();
}

int64_t covered_px(const Job& job, int32_t width_px, int32_t height_px) {
  const size_t area = static_cast<size_t>(width_px) * static_cast<size_t>(height_px);
  const Bitmap ones{SELVAGE_INDEX8, 1, 1, {1}};
  Bitmap mask{SELVAGE_INDEX8, width_px, height_px, std::vector<uint8_t>(area)};
  Job plain = job;  // which pixels are covered depends on no filter, and INDEX8 takes none
  for (JobPolygon& polygon : plain) polygon.options.filter = SELVAGE_FILTER_NEAREST;
  draw_all(plain, snap(plain), ones, mask, /*threads=*/0);
  return std::count(mask.bytes.begin(), mask.bytes.end(), uint8_t{1});
}

int run_draw(const DrawOptions& options, const Console& console) {
  if (options.threads < 0) {
    throw UserError("--threads: " + std::to_string(options.threads) +
                    " is no number of threads; give 1 or more, or 0 for all that there are");
  }
  check_picture(options.output, PictureKinds::kFilesOrOutput, console, options.json);
  const selvage_format format = about("--format", [&] { return parse_format(options.format); });
  const Job job = read_job(options);
  StatusLine status(console);
  status.show("reading the pictures");
  Bitmap target = to_bitmap(read_background(options), format);
  const Bitmap texture = to_bitmap(read_picture(options.texture), format);
  status.show("drawing");
  const int64_t time_ns = draw_job_ns(job, texture, target, options.threads);
  nlohmann::ordered_json drawn_by = methods(job, texture, target);
  status.show("writing " + options.output);
  const Raster picture = to_raster(std::move(target));
  write_picture(options.output, encode_png(picture), console);
  const int64_t covered = covered_px(job, picture.width_px, picture.height_px);
  if (covered == 0) {
    console.err << "selvage: nothing was drawn: no polygon covers a visible pixel's sample point"
                << (job.front().options.profile == SELVAGE_PROFILE_EXACT
                        ? ""
                        : ", or it runs counter-clockwise, which this profile does not draw")
                << '\n';
  }
  if (options.json) report(options, job, picture, covered, time_ns, std::move(drawn_by), console);
  return kExitFine;
}

}  // namespace selvage::cli
