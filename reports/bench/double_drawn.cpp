#include "reports/bench/double_drawn.h"

#include <algorithm>
#include <bit>
#include <stdexcept>

namespace selvage::reports {

namespace {

constexpr int32_t kCell_px = kApart_px;  // polygons of a class share no cell, nor touch in one

// Which classes have a polygon in which cells of the target.
class ClassMap {
 public:
  explicit ClassMap(int32_t side_px)
      : side_cells_(side_px / kCell_px + 1),
        classes_(static_cast<size_t>(side_cells_) * static_cast<size_t>(side_cells_)) {}

  // The first class that has nothing near the polygon, which now has.
  size_t take(const std::vector<selvage_vertex>& polygon) {
    const auto [left, right] = std::minmax_element(
        polygon.begin(), polygon.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
    const auto [top, bottom] = std::minmax_element(
        polygon.begin(), polygon.end(), [](const auto& a, const auto& b) { return a.y < b.y; });
    uint64_t taken = 0;
    const auto each_cell = [&](int32_t margin, const auto& act) {
      for (int32_t y = cell(top->y, -margin); y <= cell(bottom->y, margin); ++y) {
        for (int32_t x = cell(left->x, -margin); x <= cell(right->x, margin); ++x)
          act(classes_[static_cast<size_t>(y) * static_cast<size_t>(side_cells_) +
                       static_cast<size_t>(x)]);
      }
    };
    each_cell(1, [&](uint64_t classes) { taken |= classes; });
    const auto free = static_cast<size_t>(std::countr_one(taken));
    if (free == 64) throw std::runtime_error("a workload with 64 polygons on one place");
    each_cell(0, [&](uint64_t& classes) { classes |= uint64_t{1} << free; });
    return free;
  }

 private:
  [[nodiscard]] int32_t cell(int32_t position_fx8, int32_t offset) const {
    const int32_t at = position_fx8 / (kCell_px * SELVAGE_SUBPIXELS) + offset;
    return std::clamp(at, 0, side_cells_ - 1);
  }

  int32_t side_cells_;
  std::vector<uint64_t> classes_;
};

}  // namespace

std::vector<Workload> apart(const Workload& load) {
  ClassMap map(load.target_side_px);
  Workload empty = load;
  empty.polygons.clear();
  std::vector<Workload> classes;
  for (const auto& polygon : load.polygons) {
    const size_t chosen = map.take(polygon);
    if (chosen >= classes.size()) classes.resize(chosen + 1, empty);
    classes[chosen].polygons.push_back(polygon);
  }
  return classes;
}

uint64_t count_double(const Subject& subject, const std::vector<Workload>& classes,
                      const Texture& texture, const std::vector<int32_t>& rows_px, Target& target) {
  const auto width = static_cast<size_t>(target.width_px);
  std::vector<uint8_t> drawn(rows_px.size() * width);
  for (const Workload& one : classes) {
    std::fill(target.pixels.begin(), target.pixels.end(), kUntouched);
    subject.prepare(one, texture, target)();
    for (size_t r = 0; r < rows_px.size(); ++r) {
      const uint32_t* row = target.row(rows_px[r]);
      for (size_t x = 0; x < width; ++x) {
        if (row[x] != kUntouched) ++drawn[r * width + x];
      }
    }
  }
  return static_cast<uint64_t>(
      std::count_if(drawn.begin(), drawn.end(), [](uint8_t times) { return times > 1; }));
}

}  // namespace selvage::reports
