// A list of polygons behind the first half of selvage_draw_many: checked, examined and listed.
#pragma once

#include <gtest/gtest.h>

#include <span>
#include <vector>

#include "many/band_index.h"
#include "many/prepare.h"
#include "support.h"

namespace selvage::many {

struct PreparedList {
  std::vector<Prepared> prepared;
  Request request;
  std::vector<BandIndex::Group> groups;
  BandIndex index;

  // Refers to all that it is given.
  PreparedList(std::span<const selvage_polygon> polygons, const selvage_image& target,
               const selvage_options& options = {})
      : prepared(polygons.size()),
        request{target, {0, 0, target.width, target.height}, options, polygons, prepared, {0, 0}},
        groups(BandIndex::groups(polygons.size())),
        index(Bands({0, target.height}), groups) {
    EXPECT_EQ(prepare(request, Runs(polygons.size(), 2), &index).status, SELVAGE_OK);
  }
  PreparedList(const PreparedList&) = delete;
  PreparedList& operator=(const PreparedList&) = delete;

  [[nodiscard]] const Bands& bands() const { return index.bands(); }
  [[nodiscard]] BandRange all_bands() const { return {0, bands().count()}; }
};

}  // namespace selvage::many
