// The first half of drawing many polygons: each is checked and examined, nothing is drawn.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "many/band_index.h"
#include "many/bands.h"
#include "many/runs.h"
#include "mapper/image.h"
#include "mapper/polygon.h"
#include "selvage.h"

namespace selvage::many {

// A polygon that has passed its checks. Behind them all, the index has its groups.
struct alignas(BandIndex::Group) Prepared {
  mapper::Polygon polygon;
  const selvage_texture* texture = nullptr;
};

// A call whose arguments, apart from the polygons, have passed their checks.
struct Request {
  selvage_image target;  // by value: a descriptor may lie inside the target
  selvage_rect visible;
  selvage_options options;
  std::span<const selvage_polygon> polygons;
  std::span<Prepared> prepared;  // as many, in the scratch memory
  mapper::Memory scratch;        // all of it: nothing that a polygon refers to may lie there
};

struct Preparation {
  selvage_status status = SELVAGE_OK;
  size_t failed = 0;  // the first polygon that is refused, if one is
  Rows reach{std::numeric_limits<int32_t>::max(), std::numeric_limits<int32_t>::min()};
  int64_t row_count = 0;  // visible rows of all polygons together
};

// The rows that a polygon may write, visible or not.
[[nodiscard]] Rows reach_of(const mapper::Polygon& polygon, selvage_profile profile);

// Fills request.prepared and the index, if there is one, as far as no polygon is refused.
[[nodiscard]] Preparation prepare(const Request& request, const Runs& runs, const BandIndex* index);

}  // namespace selvage::many
