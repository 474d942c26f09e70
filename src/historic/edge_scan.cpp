#include "historic/edge_scan.h"

#include <cstdlib>

#include "historic/whole_px.h"

namespace selvage::historic {

EdgeScan::EdgeScan(const mapper::Polygon& polygon, Direction direction, Prestep prestep)
    : polygon_(&polygon), direction_(direction), prestep_(prestep), end_vertex_(polygon.top) {}

void EdgeScan::next_edge() {
  const size_t count = polygon_->vertices.size();
  const size_t from = end_vertex_;
  if (direction_ == Direction::kRight) {
    end_vertex_ = from + 1 == count ? 0 : from + 1;
  } else {
    end_vertex_ = from == 0 ? count - 1 : from - 1;
  }
  set_up(polygon_->vertices[from], polygon_->vertices[end_vertex_]);
}

void EdgeScan::set_up(const selvage_vertex& from, const selvage_vertex& to) {
  row_ = whole_px(from.y);
  end_row_ = whole_px(to.y);
  const int64_t height = end_row_ - row_;
  if (height <= 0) return;  // crosses no row: go_to passes it by

  // Where x grows, the error starts full and the first fraction turns it over: ceil(x). Where x
  // falls, it starts empty and only a whole column turns it over: ceil(x) again.
  const int64_t width = int64_t{whole_px(to.x)} - whole_px(from.x);
  const bool rightward = width >= 0;
  turn_px_ = rightward ? 1 : -1;
  error_ = rightward ? 0 : 1 - height;
  error_up_ = std::abs(width) % height;
  error_down_ = height;
  whole_step_px_ = width / height;
  column_px_ = whole_px(from.x);
  u_ = SourceWalk(from.u, to.u, height, prestep_);
  v_ = SourceWalk(from.v, to.v, height, prestep_);
}

// At once what as many steps would do of adding error_up_ and, whenever the error has passed 0,
// turning it over: each turn takes error_down_ off, and leaves it in (-error_down_, 0].
void EdgeScan::advance(int64_t rows) {
  error_ += error_up_ * rows;
  const int64_t turns = error_ > 0 ? (error_ + error_down_ - 1) / error_down_ : 0;
  error_ -= turns * error_down_;
  column_px_ += whole_step_px_ * rows + turn_px_ * turns;
  u_.advance(rows);
  v_.advance(rows);
}

void EdgeScan::go_to(int32_t row) {
  while (row >= end_row_) next_edge();
  advance(int64_t{row} - row_);
  row_ = row;
}

}  // namespace selvage::historic
