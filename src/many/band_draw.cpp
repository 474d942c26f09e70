#include "many/band_draw.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "many/band_work.h"
#include "many/hand_over.h"
#include "many/part_draw.h"
#include "many/work_left.h"
#include "many/workers.h"
#include "mapper/nearest_rounding.h"

namespace selvage::many {
namespace {

struct Drawing {
  const Request& request;
  const BandIndex& index;
  HandOver parts;

  // Each thread has a mode of rounding. The caller's is not set aside before: oneTBB gives all of
  // its threads the mode of who uses it first.
  void work(size_t worker) {
    const mapper::NearestRounding rounding;
    while (const std::optional<Part> part = parts.take(worker)) {
      PartDraw(request, index, &parts, *part).draw_all();
      parts.done();
    }
  }
};

// About as much work for each.
void share(const Request& request, const BandIndex& index, BandRange bands, std::span<Part> parts) {
  const mapper::NearestRounding rounding;
  const BandShares shares(work_left(request, index.bands(), {0, bands}, bands), bands);
  for (size_t i = 0; i < parts.size(); ++i) parts[i] = {0, shares.part(i, parts.size())};
}

}  // namespace

void draw_in_bands(const Request& request, const BandIndex& index, Rows reach, int32_t workers) {
  const BandRange bands = index.bands().reached_by(reach);
  const size_t useful = std::min(bands.count(), static_cast<size_t>(workers));
  std::array<Part, kMostBands> parts;
  share(request, index, bands, {parts.data(), useful});
  Drawing drawing{request, index, HandOver({parts.data(), useful})};
  run_workers(
      static_cast<int32_t>(useful),
      [](void* of, size_t worker) { static_cast<Drawing*>(of)->work(worker); }, &drawing);
}

}  // namespace selvage::many
