// The C interface to many polygons: all are checked, then bands of rows are drawn side by side.
#include <algorithm>
#include <cstddef>
#include <span>

#include "draw_call.h"
#include "many/band_draw.h"
#include "many/band_index.h"
#include "many/bands.h"
#include "many/painter.h"
#include "many/prepare.h"
#include "many/runs.h"
#include "many/workers.h"
#include "mapper/image.h"
#include "mapper/nearest_rounding.h"
#include "selvage.h"

namespace selvage::many {
namespace {

// The scratch memory holds first all that is Prepared, then the groups of the index.
inline constexpr size_t kMostPolygons =
    std::min<size_t>(400'000'000, SIZE_MAX / (2 * sizeof(Prepared)));
static_assert(alignof(Prepared) <= alignof(std::max_align_t));
static_assert(alignof(Prepared) % alignof(BandIndex::Group) == 0);

[[nodiscard]] constexpr size_t bytes_of(size_t polygons) {
  return polygons * sizeof(Prepared) + BandIndex::groups(polygons) * sizeof(BandIndex::Group);
}
static_assert(bytes_of(kMostPolygons) / sizeof(Prepared) >= kMostPolygons, "no overflow");

// Below so many rows of polygons, waking another thread takes longer than drawing them.
inline constexpr int64_t kLeastRowsToShare = 128;

[[nodiscard]] selvage_status check_list(const selvage_image& target,
                                        std::span<const selvage_polygon> polygons) {
  if (polygons.data() == nullptr) return SELVAGE_ERROR_POLYGONS_NULL;
  const auto memory = mapper::memory_of(polygons.data(), polygons.size(), sizeof(selvage_polygon));
  return memory.meets(mapper::memory_of(target)) ? SELVAGE_ERROR_OVERLAP : SELVAGE_OK;
}

[[nodiscard]] selvage_status check_scratch(const selvage_image& target,
                                           std::span<const selvage_polygon> polygons,
                                           const void* scratch, size_t scratch_bytes) {
  const size_t count = polygons.size(), wanted_bytes = selvage_draw_many_bytes(count);
  if (scratch == nullptr) return SELVAGE_ERROR_SCRATCH_NULL;
  if (reinterpret_cast<uintptr_t>(scratch) % alignof(std::max_align_t) != 0) {
    return SELVAGE_ERROR_SCRATCH_ALIGNMENT;
  }
  if (count > kMostPolygons || scratch_bytes < wanted_bytes) return SELVAGE_ERROR_SCRATCH_SIZE;
  const auto memory = mapper::memory_of(scratch, wanted_bytes, 1);
  const auto list = mapper::memory_of(polygons.data(), count, sizeof(selvage_polygon));
  const bool meet = memory.meets(mapper::memory_of(target)) || memory.meets(list);
  return meet ? SELVAGE_ERROR_SCRATCH_OVERLAP : SELVAGE_OK;
}

void draw_in_order(const Request& request) {
  const mapper::NearestRounding rounding;
  Painter painter(request, request.visible);
  for (const Prepared& one : request.prepared) painter.draw(one);
  painter.finish();
}

// Nothing is drawn unless all polygons pass their checks.
[[nodiscard]] Preparation draw_all(const Request& request, int32_t workers) {
  const size_t count = request.prepared.size();
  auto* const groups = reinterpret_cast<BandIndex::Group*>(request.prepared.data() + count);
  const Bands bands({request.visible.top, request.visible.bottom});
  const BandIndex index(bands, {groups, BandIndex::groups(count)});

  const Preparation preparation =
      prepare(request, Runs(count, workers), workers > 1 ? &index : nullptr);
  if (preparation.status != SELVAGE_OK) return preparation;
  if (workers > 1 && preparation.row_count >= kLeastRowsToShare) {
    draw_in_bands(request, index, preparation.reach, workers);
  } else {
    draw_in_order(request);
  }
  return preparation;
}

}  // namespace
}  // namespace selvage::many

size_t selvage_draw_many_bytes(size_t polygon_count) {
  using namespace selvage::many;
  return polygon_count <= kMostPolygons ? bytes_of(polygon_count) : SIZE_MAX;
}

selvage_status selvage_draw_many(const selvage_image* target, const selvage_rect* clip,
                                 const selvage_polygon* polygons, size_t polygon_count,
                                 const selvage_options* options, int32_t threads, void* scratch,
                                 size_t scratch_bytes, size_t* failed) {
  using namespace selvage;
  const selvage_options chosen = options != nullptr ? *options : selvage_options{};
  const std::span<const selvage_polygon> list{polygons, polygon_count};

  selvage_status status = check_call(chosen, target);
  if (status == SELVAGE_OK && threads < 0) status = SELVAGE_ERROR_THREADS;
  if (status != SELVAGE_OK || polygon_count == 0) return status;
  status = many::check_list(*target, list);
  if (status == SELVAGE_OK) status = many::check_scratch(*target, list, scratch, scratch_bytes);
  if (status != SELVAGE_OK) return status;

  const many::Request request{
      .target = *target,
      .visible = mapper::visible_rect(*target, clip),
      .options = chosen,
      .polygons = list,
      .prepared = {static_cast<many::Prepared*>(scratch), polygon_count},
      .scratch = mapper::memory_of(scratch, selvage_draw_many_bytes(polygon_count), 1)};
  const many::Preparation preparation = many::draw_all(request, many::worker_count(threads));
  if (preparation.status != SELVAGE_OK && failed != nullptr) *failed = preparation.failed;
  return preparation.status;
}
