#include "scene/scan_line.h"

#include <algorithm>
#include <optional>

#include "scene/active_edge.h"
#include "scene/piece_list.h"
#include "scene/row_span.h"
#include "scene/visible_row.h"

namespace selvage::scene {
namespace {

// An entry of the edge table.
struct TableEdge {
  int32_t first_row;  // in the picture
  size_t face;
  const selvage_vertex *top, *bottom;
};

// All edges that some row of the picture crosses, by their first row.
[[nodiscard]] std::vector<TableEdge> edge_table(std::span<const ScreenFace> faces, Size size) {
  std::vector<TableEdge> table;
  for (size_t face = 0; face < faces.size(); ++face) {
    const std::vector<selvage_vertex>& vertices = faces[face].vertices;
    for (size_t i = 0; i < vertices.size(); ++i) {
      const selvage_vertex *top = &vertices[i], *bottom = &vertices[(i + 1) % vertices.size()];
      if (top->y > bottom->y) std::swap(top, bottom);
      const EdgeRows rows = rows_between(top->y, bottom->y);
      const int32_t first_row = std::max(rows.first_row, 0);
      if (first_row < std::min(rows.end_row, size.height_px)) {
        table.push_back({first_row, face, top, bottom});
      }
    }
  }
  std::stable_sort(table.begin(), table.end(), [](const TableEdge& a, const TableEdge& b) {
    return a.first_row < b.first_row;
  });
  return table;
}

// The active edges, and the spans between them.
class ActiveEdges {
 public:
  explicit ActiveEdges(std::span<const TableEdge> table) : waiting_(table) {}

  // Rows are entered one after another from 0.
  void enter(int32_t row) {
    std::erase_if(edges_, [&](const ActiveEdge& edge) { return edge.end_row() <= row; });
    for (ActiveEdge& edge : edges_) edge.step();
    for (; !waiting_.empty() && waiting_.front().first_row == row; waiting_ = waiting_.subspan(1)) {
      const TableEdge& edge = waiting_.front();
      edges_.emplace_back(edge.face, *edge.top, *edge.bottom, row);
    }
  }

  // Each face has two of the edges or none.
  void spans(int32_t width_px, std::vector<RowSpan>& spans) {
    std::stable_sort(edges_.begin(), edges_.end(),
                     [](const ActiveEdge& a, const ActiveEdge& b) { return a.face() < b.face(); });
    spans.clear();
    for (size_t i = 0; i + 1 < edges_.size(); i += 2) {
      RowSpan span(edges_[i], edges_[i + 1]);
      span.clip(width_px);
      if (!span.empty()) spans.push_back(span);
    }
  }

 private:
  std::span<const TableEdge> waiting_;
  std::vector<ActiveEdge> edges_;
};

}  // namespace

std::vector<Piece> scan_line_pieces(std::span<const ScreenFace> faces, Size size) {
  const std::vector<TableEdge> table = edge_table(faces, size);
  ActiveEdges active(table);
  VisibleRow visible;
  PieceList pieces(faces.size(), size.width_px);
  std::vector<RowSpan> spans;
  for (int32_t row = 0; row < size.height_px; ++row) {
    active.enter(row);
    active.spans(size.width_px, spans);
    for (const Segment& segment : visible.resolve(spans)) {
      pieces.add(row, spans[segment.span], segment.first_px, segment.end_px);
    }
  }
  return std::move(pieces).take();
}

}  // namespace selvage::scene
