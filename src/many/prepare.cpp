#include "many/prepare.h"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>

#include "draw_call.h"
#include "mapper/image_check.h"

namespace selvage::many {
namespace {

// What lies between a polygon and its texels. A texture that the polygon before had is not checked
// again.
class Checks {
 public:
  explicit Checks(const Request& request)
      : request_(request), target_(mapper::memory_of(request.target)) {}

  [[nodiscard]] selvage_status examine(const selvage_polygon& given, mapper::Polygon* polygon) {
    selvage_status status = check_texture(given.texture);
    if (status == SELVAGE_OK) status = check_vertices(given);
    if (status != SELVAGE_OK) return status;
    return check_outline(request_.options, {given.vertices, given.count}, polygon);
  }

 private:
  // By its address before it is looked at: what lies in the scratch memory has been overwritten.
  [[nodiscard]] selvage_status check_texture(const selvage_texture* texture) {
    if (texture == nullptr) return SELVAGE_ERROR_TEXTURE_NULL;
    if (texture == known_) return SELVAGE_OK;
    selvage_status status = check_apart(mapper::memory_of(texture, 1, sizeof *texture));
    if (status == SELVAGE_OK) status = check_source(request_.options, request_.target, texture);
    if (status == SELVAGE_OK && mapper::memory_of(*texture).meets(request_.scratch)) {
      status = SELVAGE_ERROR_SCRATCH_OVERLAP;
    }
    if (status == SELVAGE_OK) known_ = texture;
    return status;
  }

  [[nodiscard]] selvage_status check_vertices(const selvage_polygon& given) const {
    const auto& [vertices, count, texture] = given;
    const selvage_status status = mapper::check_vertices(target_, vertices, count);
    if (status != SELVAGE_OK) return status;
    const mapper::Memory memory = mapper::memory_of(vertices, count, sizeof *vertices);
    return memory.meets(request_.scratch) ? SELVAGE_ERROR_SCRATCH_OVERLAP : SELVAGE_OK;
  }

  [[nodiscard]] selvage_status check_apart(const mapper::Memory& memory) const {
    if (memory.meets(target_)) return SELVAGE_ERROR_OVERLAP;
    return memory.meets(request_.scratch) ? SELVAGE_ERROR_SCRATCH_OVERLAP : SELVAGE_OK;
  }

  const Request& request_;
  mapper::Memory target_;
  const selvage_texture* known_ = nullptr;
};

// The polygons are [first, end).
[[nodiscard]] Preparation prepare_run(const Request& request, size_t first, size_t end,
                                      const BandIndex* index) {
  Preparation run;
  Checks checks(request);
  const Rows visible{request.visible.top, request.visible.bottom};
  std::optional<BandIndex::Writer> writer;
  if (index != nullptr) writer.emplace(*index, first);
  for (size_t i = first; i < end; ++i) {
    const selvage_polygon& given = request.polygons[i];
    // In its place: a copy would wait for what was just stored.
    Prepared* const prepared = std::construct_at(&request.prepared[i]);
    mapper::Polygon& polygon = prepared->polygon;
    prepared->texture = given.texture;
    run.status = checks.examine(given, &polygon);
    if (run.status != SELVAGE_OK) {
      run.failed = i;
      return run;
    }
    const Rows reach = reach_of(polygon, request.options.profile);
    run.reach = {std::min(run.reach.first, reach.first), std::max(run.reach.end, reach.end)};
    run.row_count += reach.within(visible).count();
    if (writer) writer->add(index->bands().reached_by(reach));
  }
  if (writer) writer->end();
  return run;
}

}  // namespace

Rows reach_of(const mapper::Polygon& polygon, selvage_profile profile) {
  const int32_t last_row = profile == SELVAGE_PROFILE_DKIT ? 1 : 0;  // it draws both ends
  return {polygon.top_row, polygon.bottom_row + last_row};
}

Preparation prepare(const Request& request, const Runs& runs, const BandIndex* index) {
  std::array<Preparation, kMostRuns> parts{};
  runs.for_each([&](size_t run, size_t first, size_t end) {
    parts[run] = prepare_run(request, first, end, index);
  });

  Preparation all;
  for (size_t run = 0; run < runs.count() && all.status == SELVAGE_OK; ++run) {
    const Preparation& part = parts[run];
    all.status = part.status;
    all.failed = part.failed;
    all.reach = {std::min(all.reach.first, part.reach.first),
                 std::max(all.reach.end, part.reach.end)};
    all.row_count += part.row_count;
  }
  return all;
}

}  // namespace selvage::many
