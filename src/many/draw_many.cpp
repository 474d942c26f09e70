// The C interface to many polygons: all are checked, then bands of rows are drawn side by side. A
// band is drawn as a clip rectangle would have it drawn, so that by law CLIP no band changes a
// pixel, whatever their number and whoever draws them.
#include <algorithm>
#include <cstddef>
#include <span>

#include "draw_call.h"
#include "many/bands.h"
#include "many/prepare.h"
#include "many/runs.h"
#include "many/share_out.h"
#include "many/workers.h"
#include "mapper/image.h"
#include "selvage.h"

namespace selvage::many {
namespace {

// A polygon's share of the scratch memory, which holds first all that is Prepared, then the entries
// of the index.
inline constexpr size_t kBytesPerPolygon = sizeof(Prepared) + kMostNodes * sizeof(uint32_t);
inline constexpr size_t kMostPolygons =
    std::min<size_t>(SIZE_MAX / kBytesPerPolygon, UINT32_MAX / kMostNodes);
static_assert(alignof(Prepared) <= alignof(std::max_align_t));
static_assert(alignof(Prepared) % alignof(uint32_t) == 0);

// More bands balance the threads better, and cost more set-up: a polygon's once in each.
inline constexpr int32_t kBandsPerWorker = 3;
inline constexpr int32_t kLeastBandRows = 8;
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

void draw_one(const Request& request, const selvage_rect& visible, const Prepared& one) {
  draw_checked(request.target, visible, one.polygon, *one.texture, request.options);
}

void draw_in_bands(const Request& request, const Bands& bands, std::span<uint32_t> entries,
                   const Runs& runs, int32_t workers) {
  BandIndex index(bands, entries);
  const auto reach = [&](size_t i) {
    return reach_of(request.prepared[i].polygon, request.options.profile);
  };
  runs.for_each([&](size_t run, size_t first, size_t end) {
    for (size_t i = first; i < end; ++i) index.add(run, reach(i));
  });
  index.end_adding();
  runs.for_each([&](size_t run, size_t first, size_t end) {
    for (size_t i = first; i < end; ++i) index.list(run, static_cast<uint32_t>(i), reach(i));
  });

  share_out(bands.count(), workers, [&](size_t band) {
    const Rows rows = bands.rows(band);
    const selvage_rect strip{request.visible.left, rows.first, request.visible.right, rows.end};
    BandIndex::Reader reader(index, band);
    for (uint32_t i; reader.next(&i);) draw_one(request, strip, request.prepared[i]);
  });
}

void draw_all(const Request& request, const Preparation& preparation, const Runs& runs,
              int32_t workers) {
  const Rows rows = preparation.reach.within({request.visible.top, request.visible.bottom});
  if (rows.empty()) return;
  constexpr auto kMostWanted = static_cast<int32_t>(kMostBands / 2);
  const int32_t wanted = std::min(workers, kMostWanted) * kBandsPerWorker;
  const Bands bands(rows, static_cast<size_t>(std::min(wanted, kMostWanted)), kLeastBandRows);
  if (workers == 1 || bands.count() == 1 || preparation.row_count < kLeastRowsToShare) {
    for (const Prepared& one : request.prepared) draw_one(request, request.visible, one);
    return;
  }
  const size_t count = request.prepared.size();
  auto* const entries = reinterpret_cast<uint32_t*>(request.prepared.data() + count);
  draw_in_bands(request, bands, {entries, count * kMostNodes}, runs, workers);
}

}  // namespace
}  // namespace selvage::many

size_t selvage_draw_many_bytes(size_t polygon_count) {
  using namespace selvage::many;
  return polygon_count <= kMostPolygons ? polygon_count * kBytesPerPolygon : SIZE_MAX;
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
  const int32_t workers = many::worker_count(threads);
  const many::Runs runs(polygon_count, workers);
  const many::Preparation preparation = many::prepare(request, runs);
  if (preparation.status == SELVAGE_OK) {
    many::draw_all(request, preparation, runs, workers);
  } else if (failed != nullptr) {
    *failed = preparation.failed;
  }
  return preparation.status;
}
