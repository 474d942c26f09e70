#include "cli/render_stats.h"

#include <algorithm>
#include <sstream>
#include <utility>

#include "cli/error.h"
#include "cli/render_report.h"

namespace selvage::cli {
namespace {

using nlohmann::ordered_json;

// The rows and columns that a piece may draw in.
[[nodiscard]] selvage_rect reach(const scene::Piece& piece, const scene::ScreenFace& face,
                                 const Bitmap& picture) {
  const auto [top, bottom] =
      std::minmax_element(face.vertices.begin(), face.vertices.end(),
                          [](const auto& a, const auto& b) { return a.y < b.y; });
  const auto [left, right] =
      std::minmax_element(face.vertices.begin(), face.vertices.end(),
                          [](const auto& a, const auto& b) { return a.x < b.x; });
  return {std::max({piece.clip.left, 0, left->x >> 8}), std::max({piece.clip.top, 0, top->y >> 8}),
          std::min({piece.clip.right, picture.width_px, (right->x >> 8) + 1}),
          std::min({piece.clip.bottom, picture.height_px, (bottom->y >> 8) + 1})};
}

// Draws pieces into a mask and tells how many pixels each writes.
class PixelCounter {
 public:
  PixelCounter(int32_t width_px, int32_t height_px)
      : shown_(area(width_px, height_px)),
        mask_{SELVAGE_INDEX8, width_px, height_px, std::vector<uint8_t>(shown_.size())} {}

  [[nodiscard]] int64_t written_px(const scene::Piece& piece, const scene::ScreenFace& face) {
    const selvage_image image = mask_.image();
    const selvage_texture texture = ones_.texture();
    const selvage_status status = selvage_draw(&image, &piece.clip, face.vertices.data(),
                                               face.vertices.size(), &texture, nullptr);
    if (status != SELVAGE_OK) throw UserError(selvage_status_text(status));
    int64_t count = 0;
    const selvage_rect rows = reach(piece, face, mask_);
    for (int32_t y = rows.top; y < rows.bottom; ++y) {
      for (int32_t x = rows.left; x < rows.right; ++x) {
        const size_t at = area(mask_.width_px, y) + static_cast<size_t>(x);
        count += mask_.bytes[at];
        shown_[at] = shown_[at] | std::exchange(mask_.bytes[at], uint8_t{0});
      }
    }
    return count;
  }

  [[nodiscard]] int64_t shown_px() const {
    return std::count(shown_.begin(), shown_.end(), uint8_t{1});
  }

 private:
  [[nodiscard]] static size_t area(int32_t width_px, int32_t height_px) {
    return static_cast<size_t>(width_px) * static_cast<size_t>(height_px);
  }

  std::vector<uint8_t> shown_;
  Bitmap mask_;
  const Bitmap ones_{SELVAGE_INDEX8, 1, 1, {1}};
};

[[nodiscard]] RenderStats::Way of_both(const RenderStats::Way& a, const RenderStats::Way& b) {
  const auto common = [](const std::string& one, const std::string& other) {
    return one == other ? one : "several";
  };
  return {common(a.method, b.method), common(a.filter, b.filter), common(a.kernel, b.kernel)};
}

// An element of "drawn_by".
[[nodiscard]] std::string way_text(const ordered_json& way) {
  std::ostringstream text;
  text << way["method"].get<std::string>() << ", " << way["filter"].get<std::string>()
       << ", kernel " << way["kernel"].get<std::string>() << ": " << way["faces"] << " faces, "
       << way["pixels"] << " pixels";
  return text.str();
}

}  // namespace

void RenderStats::add(const RenderStats& other) {
  counts.objects += other.counts.objects;
  counts.objects_rejected += other.counts.objects_rejected;
  counts.faces_rejected += other.counts.faces_rejected;
  counts.faces += other.counts.faces;
  counts.clipped_away += other.counts.clipped_away;
  counts.backs += other.counts.backs;
  counts.edge_on += other.counts.edge_on;
  counts.off_screen += other.counts.off_screen;
  counts.refused += other.counts.refused;
  counts.seen += other.counts.seen;
  for (const auto& [way, work] : other.drawn_by) {
    drawn_by[way].faces += work.faces;
    drawn_by[way].pixels += work.pixels;
  }
  draw_calls += other.draw_calls;
  written_px += other.written_px;
  shown_px += other.shown_px;
  compose_ns += other.compose_ns;
  light_ns += other.light_ns;
  sums_ns += other.sums_ns;
  draw_ns += other.draw_ns;
}

RenderStats stats_of(const scene::Scene& scene, const scene::Drawing& drawing, Bitmap& target) {
  RenderStats stats;
  stats.counts = drawing.view.counts;
  stats.draw_calls = static_cast<int64_t>(drawing.pieces.size());
  struct Drawn {
    RenderStats::Way way;
    int64_t pixels = 0;
  };
  std::map<std::pair<size_t, size_t>, Drawn> faces;  // by object, and face of it
  PixelCounter counter(target.width_px, target.height_px);
  for (const scene::Piece& piece : drawing.pieces) {
    const scene::ScreenFace& seen = drawing.view.faces[piece.face];
    const int64_t pixels = counter.written_px(piece, seen);
    if (pixels == 0) continue;
    const FaceChoice choice = choice_of(scene, drawing, piece.face, target);
    Drawn& drawn = faces[{seen.object, seen.face}];
    const RenderStats::Way way{choice.method, choice.filter, choice.kernel};
    drawn.way = drawn.pixels == 0 ? way : of_both(drawn.way, way);
    drawn.pixels += pixels;
  }
  for (const auto& [face, drawn] : faces) {
    ++stats.drawn_by[drawn.way].faces;
    stats.drawn_by[drawn.way].pixels += drawn.pixels;
    stats.written_px += drawn.pixels;
  }
  stats.shown_px = counter.shown_px();
  return stats;
}

ordered_json stats_json(const RenderStats& stats, int32_t frames) {
  const scene::Counts& counts = stats.counts;
  int64_t drawn = 0;
  ordered_json drawn_by = ordered_json::array();
  for (const auto& [way, work] : stats.drawn_by) {
    drawn += work.faces;
    drawn_by.push_back({{"method", way.method},
                        {"filter", way.filter},
                        {"kernel", way.kernel},
                        {"faces", work.faces},
                        {"pixels", work.pixels}});
  }
  const double written = static_cast<double>(std::max<int64_t>(stats.written_px, 1));
  return {{"frames", frames},
          {"objects", counts.objects},
          {"objects_culled", counts.objects_rejected},
          {"faces", counts.faces_rejected + counts.faces},
          {"faces_culled",
           {{"with their object", counts.faces_rejected},
            {"clipped away", counts.clipped_away},
            {"from behind", counts.backs},
            {"edge-on", counts.edge_on},
            {"off screen", counts.off_screen},
            {"refused", counts.refused},
            {"without a pixel", static_cast<int64_t>(counts.seen) - drawn}}},
          {"faces_drawn", drawn},
          {"drawn_by", drawn_by},
          {"draw_calls", stats.draw_calls},
          {"pixels_written", stats.written_px},
          {"pixels_shown", stats.shown_px},
          {"compose_ns", stats.compose_ns},
          {"light_ns", stats.light_ns},
          {"sums_ns", stats.sums_ns},
          {"draw_ns", stats.draw_ns},
          {"draw_ns_per_pixel", static_cast<double>(stats.draw_ns) / written}};
}

std::string stats_text(const RenderStats& stats, int32_t frames) {
  std::ostringstream text;
  const ordered_json values = stats_json(stats, frames);
  for (const auto& item : values.items()) {
    text << item.key() << ':';
    if (!item.value().is_structured()) {
      text << ' ' << item.value() << '\n';
      continue;
    }
    text << '\n';
    for (const auto& part : item.value().items()) {
      if (part.value().is_object()) {
        text << "  " << way_text(part.value()) << '\n';
      } else {
        text << "  " << part.key() << ": " << part.value() << '\n';
      }
    }
  }
  return text.str();
}

}  // namespace selvage::cli
