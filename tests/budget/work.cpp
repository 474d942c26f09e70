#include "work.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <random>
#include <string>
#include <system_error>
#include <utility>

#include "reports/bench/near_tie_maps.h"
#include "reports/bench/workloads.h"

namespace selvage::budget {

namespace {

constexpr uint64_t kSeed = 1;
constexpr std::string_view kOrdinary = "-ordinary";
constexpr int32_t kMostTriangles = 2000;
constexpr int32_t kTargetWidth_px = 1024;
constexpr int32_t kTextureSide_texel = 256;
constexpr int32_t kTexture_fx16 = kTextureSide_texel * SELVAGE_SUBTEXELS;
constexpr int32_t kQ = 1 << 20;
constexpr double kSubpixels = SELVAGE_SUBPIXELS;

enum class Depth { kFlat, kTilted };

// On one tilted plane q changes with x and y alike: from 1 to 2 over the target's diagonal.
int32_t tilted_q(int32_t x_fx8, int32_t y_fx8) {
  return kQ + kQ / (2 * kTargetWidth_px) * ((x_fx8 + y_fx8) / SELVAGE_SUBPIXELS);
}

// The vertices of a grid of square cells over the target, row by row; the inner ones are moved by
// up to 0.3 cells each way, the texture coordinates stay.
std::vector<selvage_vertex> jittered_grid(int32_t cells, int32_t cell_fx8, Depth depth) {
  constexpr int32_t off_fx8 = 83;  // off the pixel grid
  std::mt19937_64 random(kSeed);
  const int32_t reach_fx8 = cell_fx8 * 3 / 10;
  const auto jitter_fx8 = [&](int32_t i) {
    const auto jitter =
        static_cast<int32_t>(random() % static_cast<uint64_t>(2 * reach_fx8 + 1)) - reach_fx8;
    return i > 0 && i < cells ? jitter : 0;
  };
  std::vector<selvage_vertex> grid;
  for (int32_t j = 0; j <= cells; ++j) {
    for (int32_t i = 0; i <= cells; ++i) {
      selvage_vertex vertex{off_fx8 + i * cell_fx8 + jitter_fx8(i),
                            off_fx8 + j * cell_fx8 + jitter_fx8(j), kTexture_fx16 / cells * i,
                            kTexture_fx16 / cells * j, 1};
      if (depth == Depth::kTilted) vertex.q = tilted_q(vertex.x, vertex.y);
      grid.push_back(vertex);
    }
  }
  return grid;
}

// Two triangles a cell, from the top, as many as there are but 2000 at most.
Work mesh(double area_px, Depth depth) {
  const auto cell_fx8 = static_cast<int32_t>(std::lround(std::sqrt(2 * area_px) * kSubpixels));
  const int32_t cells = (kTargetWidth_px - 1) * SELVAGE_SUBPIXELS / cell_fx8;
  const std::vector<selvage_vertex> grid = jittered_grid(cells, cell_fx8, depth);
  Work work{
      "triangle", {}, kTargetWidth_px, kTargetWidth_px, kTextureSide_texel, SELVAGE_FILTER_NEAREST};
  for (int32_t cell = 0; cell < cells * cells && 2 * cell < kMostTriangles; ++cell) {
    const auto at = static_cast<size_t>(cell / cells * (cells + 1) + cell % cells);
    const size_t below = at + static_cast<size_t>(cells) + 1;
    work.polygons.push_back({grid[at], grid[at + 1], grid[below]});
    work.polygons.push_back({grid[at + 1], grid[below + 1], grid[below]});
  }
  return work;
}

struct Corner {
  int32_t u_texel, v_texel, q;
};

// A triangle that reaches beyond the target's left, right and lower side and covers it whole, by a
// span of 1024 px a row. No sample lies outside the texture.
Work spans(const Corner& right, const Corner& below, selvage_filter filter) {
  constexpr int32_t px = SELVAGE_SUBPIXELS, texel = SELVAGE_SUBTEXELS, height_px = 64;
  constexpr int32_t left_px = -64, right_px = 4096, bottom_px = 2 * height_px;
  const Polygon polygon = {
      {left_px * px, 0, 10 * texel, 10 * texel, kQ},
      {right_px * px, 0, right.u_texel * texel, right.v_texel * texel, right.q},
      {left_px * px, bottom_px * px, below.u_texel * texel, below.v_texel * texel, below.q}};
  return {"px", {polygon}, kTargetWidth_px, height_px, kTextureSide_texel, filter};
}

// The same spans from corners off every grid, so that near-ties are as rare as in a free hand's
// polygon: where steps are simple fractions, each vector has some.
Work uneven_spans(selvage_filter filter) {
  constexpr int32_t height_px = 64;
  const Polygon polygon = {{-16411, -77, 655363, 655411, kQ},
                           {1048613, 33, 54329341, 26870309, kQ},
                           {-16519, 32801, 2621477, 3932311, kQ}};
  return {"px", {polygon}, kTargetWidth_px, height_px, kTextureSide_texel, filter};
}

struct Knot {
  int32_t x_px, y_px, u_texel, v_texel, q;
};

// 64 spans of such a width, by the area filter and off every grid. The polygon covers the target,
// no box reaches beyond the texture.
Work minified(std::initializer_list<Knot> knots, int32_t width_px) {
  constexpr int32_t px = SELVAGE_SUBPIXELS, texel = SELVAGE_SUBTEXELS, height_px = 64;
  constexpr int32_t texture_side_texel = 1024;
  Polygon polygon;
  for (const Knot& k : knots) {
    polygon.push_back({k.x_px * px + 83, k.y_px * px + 39, k.u_texel * texel + 21011,
                       k.v_texel * texel + 7, k.q});
  }
  return {"px", {polygon}, width_px, height_px, texture_side_texel, SELVAGE_FILTER_AREA};
}

// Boxes of 4.6 x 4.6 texels; of 2.2 to 6; of 2.5 to 8.8; and of 14.5 x 14.5.
Work area() {
  return minified({{-11, -3, 30, 400, 1}, {600, -2, 1998, -434, 1}, {-13, 150, 234, 896, 1}}, 256);
}
Work area_tilted() {
  return minified(
      {{-11, -3, 30, 400, kQ}, {600, -2, 1430, -160, 2 * kQ}, {-13, 150, 234, 896, kQ + kQ / 4}},
      256);
}
Work area_ruled() {
  return minified({{-11, -3, 30, 300, kQ},
                   {300, -2, 1000, 40, 2 * kQ},
                   {290, 90, 900, 700, kQ + kQ / 2},
                   {-20, 80, 60, 900, kQ}},
                  256);
}
Work area_sums() {
  Work work =
      minified({{-2, -3, 30, 250, 1}, {200, -2, 2255, -446, 1}, {-4, 150, 543, 1940, 1}}, 64);
  work.with_sums = true;
  return work;
}

// A work item of the report, all of it.
std::optional<Work> report_item(std::string_view id) {
  const auto loads = reports::workloads(kSeed);
  const auto load = std::ranges::find(loads, id, &reports::Workload::id);
  if (load == loads.end()) return std::nullopt;
  return Work{"px",
              load->polygons,
              load->target_side_px,
              load->target_side_px,
              load->texture_side_texel,
              load->filter};
}

// An adversarial item of the report, or the ordinary twin of one: what there is of it in 64 rows.
std::optional<Work> adversarial(std::string_view id) {
  constexpr int32_t height_px = 64;
  const auto loads = reports::adversarial_workloads();
  const auto load = std::ranges::find(loads, id, &reports::Workload::id);
  if (load == loads.end()) return std::nullopt;
  Work work{"px", {}, load->target_side_px, height_px, load->texture_side_texel, load->filter};
  std::ranges::copy_if(load->polygons, std::back_inserter(work.polygons), [](const Polygon& each) {
    return std::ranges::min(each, {}, &selvage_vertex::y).y < height_px * SELVAGE_SUBPIXELS;
  });
  return work;
}

// A map of the search for near-ties that cost the most, or one of its ordinary twins.
std::optional<Work> near_tie_map(std::string_view seed_or_twin) {
  const bool is_twin = seed_or_twin.ends_with(kOrdinary);
  if (is_twin) seed_or_twin.remove_suffix(kOrdinary.size());
  const char* const end = seed_or_twin.data() + seed_or_twin.size();
  uint64_t seed = 0;
  const auto [stop, error] = std::from_chars(seed_or_twin.data(), end, seed);
  if (error != std::errc() || stop != end) return std::nullopt;
  const reports::NearTieMap map = reports::near_tie_map(seed);
  return Work{"px",
              {is_twin ? map.ordinary[0] : map.hard},
              reports::kMapWidth_px,
              reports::kMapHeight_px,
              reports::kMapTexture_texel,
              SELVAGE_FILTER_NEAREST,
              map.address};
}

}  // namespace

std::optional<Work> work_of(std::string_view kind) {
  constexpr std::string_view kFlipped = "-flipped", kList = "-list";
  for (const auto& [suffix, setting] :
       {std::pair(kFlipped, &Work::flips_texture), std::pair(kList, &Work::as_list)}) {
    if (!kind.ends_with(suffix)) continue;
    std::optional<Work> work = work_of(kind.substr(0, kind.size() - suffix.size()));
    if (work) (*work).*setting = true;
    return work;
  }
  if (kind == "mesh-52") return mesh(52, Depth::kFlat);
  if (kind == "mesh-484") return mesh(484, Depth::kFlat);
  if (kind == "tilted-52") return mesh(52, Depth::kTilted);
  if (kind == "tilted-484") return mesh(484, Depth::kTilted);
  constexpr Corner right{829, 410, kQ}, near{400, 200, 2 * kQ};
  constexpr Corner below{40, 60, kQ}, near_below{40, 60, kQ + kQ / 2};
  if (kind == "affine") return spans(right, below, SELVAGE_FILTER_NEAREST);
  if (kind == "perspective") return spans(near, near_below, SELVAGE_FILTER_NEAREST);
  if (kind == "bilinear") return spans(right, below, SELVAGE_FILTER_BILINEAR);
  if (kind == "bilinear-any") return uneven_spans(SELVAGE_FILTER_BILINEAR);
  if (kind == "area") return area();
  if (kind == "area-tilted") return area_tilted();
  if (kind == "area-ruled") return area_ruled();
  if (kind == "area-sums") return area_sums();
  if (kind == "quads") return report_item("W9");
  if (kind == "quad-tilted") return report_item("W4-rounded");
  constexpr std::string_view kMap = "seed-";
  if (kind.starts_with(kMap)) return near_tie_map(kind.substr(kMap.size()));
  return adversarial(kind);
}

Work excerpt_of(Work work) {
  constexpr size_t kMany = 8, kSomeTriangles = 64;
  if (work.polygons.size() >= kMany) {
    work.polygons.resize(
        std::min(work.polygons.size(), work.unit == "triangle" ? kSomeTriangles : kMany));
    return work;
  }
  int32_t top_fx8 = SELVAGE_X_END, bottom_fx8 = SELVAGE_X_MIN;
  for (const Polygon& each : work.polygons) {
    const auto [top, bottom] = std::ranges::minmax(each, {}, &selvage_vertex::y);
    top_fx8 = std::min(top_fx8, top.y);
    bottom_fx8 = std::max(bottom_fx8, bottom.y);
  }
  const int32_t top_px = std::max(top_fx8 / SELVAGE_SUBPIXELS, 0);
  const int32_t bottom_px = std::min(bottom_fx8 / SELVAGE_SUBPIXELS + 1, work.target_height_px);
  const int32_t rows = work.filter == SELVAGE_FILTER_AREA ? 2 : 8;
  const int32_t first_px = std::max((top_px + bottom_px - rows) / 2, top_px);
  work.rows_px = {first_px, std::min(first_px + rows, bottom_px)};
  return work;
}

}  // namespace selvage::budget
