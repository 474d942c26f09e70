#include "cli/render_report.h"

#include <algorithm>
#include <sstream>

#include "cli/error.h"
#include "cli/job.h"
#include "cli/number.h"
#include "scene/paints.h"

namespace selvage::cli {
namespace {

using nlohmann::ordered_json;

[[nodiscard]] std::string filter_name(selvage_filter filter) {
  constexpr const char* kNames[] = {"nearest", "four", "bilinear", "area"};
  return kNames[filter];
}

// Why this and nothing cheaper.
[[nodiscard]] std::string reason(const scene::ScreenFace& face, const scene::Plan& plan) {
  if (!face.paint.texture) return "one colour: any map will do";
  if (plan.depth_ratio == 1) return "one depth: affine is exact";
  if (plan.affine) return "affine is within the tolerance";
  if (plan.options.filter != SELVAGE_FILTER_NEAREST)
    return "affine is not, and this filter is exact";
  return plan.options.tolerance > 0 ? "affine is not; the mapper has the tolerance"
                                    : "exact is asked for";
}

void count_pixels(const scene::Drawing& drawing, int32_t width_px, int32_t height_px,
                  RenderStats& stats) {
  const size_t area = static_cast<size_t>(width_px) * static_cast<size_t>(height_px);
  std::vector<uint8_t> shown(area);
  const Bitmap ones{SELVAGE_INDEX8, 1, 1, {1}};
  const selvage_texture texture = ones.texture();
  for (const scene::Piece& piece : drawing.pieces) {
    Bitmap mask{SELVAGE_INDEX8, width_px, height_px, std::vector<uint8_t>(area)};
    const selvage_image image = mask.image();
    const std::vector<selvage_vertex>& vertices = drawing.view.faces[piece.face].vertices;
    const selvage_status status =
        selvage_draw(&image, &piece.clip, vertices.data(), vertices.size(), &texture, nullptr);
    if (status != SELVAGE_OK) throw UserError(selvage_status_text(status));
    for (size_t i = 0; i < area; ++i) {
      stats.written_px += mask.bytes[i];
      shown[i] = shown[i] | mask.bytes[i];
    }
  }
  for (const uint8_t one : shown) stats.shown_px += one;
}

}  // namespace

void RenderStats::add(const RenderStats& other) {
  counts.objects += other.counts.objects;
  counts.objects_rejected += other.counts.objects_rejected;
  counts.faces += other.counts.faces;
  counts.clipped_away += other.counts.clipped_away;
  counts.backs += other.counts.backs;
  counts.off_screen += other.counts.off_screen;
  counts.refused += other.counts.refused;
  counts.seen += other.counts.seen;
  for (const auto& [method, faces] : other.drawn_by) drawn_by[method] += faces;
  pieces += other.pieces;
  written_px += other.written_px;
  shown_px += other.shown_px;
  compose_ns += other.compose_ns;
  draw_ns += other.draw_ns;
}

FaceChoice choice_of(const scene::Scene& scene, const scene::Drawing& drawing, size_t face,
                     Bitmap& target) {
  const scene::ScreenFace& seen = drawing.view.faces[face];
  const scene::Plan& plan = drawing.plans[face];
  const std::vector<selvage_vertex> vertices = vertices_to_draw(seen, plan);
  const selvage_image image = target.image();
  scene::Paint unlit = seen.paint;
  unlit.light = {};
  scene::Paints paints(scene);
  const selvage_texture texture = paints.texture(unlit);
  selvage_choice choice{};
  const selvage_status status = selvage_choose(&image, nullptr, vertices.data(), vertices.size(),
                                               &texture, &plan.options, &choice);
  if (status != SELVAGE_OK) throw UserError(selvage_status_text(status));
  const bool instead = plan.affine && plan.depth_ratio > 1 && seen.paint.texture.has_value();
  const bool by_rows = choice.method == SELVAGE_METHOD_EXACT_PERSPECTIVE && choice.bound > 0;
  return {instead   ? "affine for perspective, whole face"
          : by_rows ? "exact perspective, cheaper in wide rows"
                    : std::string(method_name(choice.method)),
          choice.segment_px, plan.affine ? plan.bound_texel : choice.bound / scene::kSubtexels};
}

RenderStats stats_of(const scene::Scene& scene, const scene::Drawing& drawing, Bitmap& target) {
  RenderStats stats;
  stats.counts = drawing.view.counts;
  for (size_t i = 0; i < drawing.view.faces.size(); ++i) {
    ++stats.drawn_by[choice_of(scene, drawing, i, target).method];
  }
  stats.pieces = static_cast<int64_t>(drawing.pieces.size());
  count_pixels(drawing, target.width_px, target.height_px, stats);
  return stats;
}

ordered_json explanation(const scene::Scene& scene, const scene::Drawing& drawing, double tolerance,
                         Bitmap& target) {
  ordered_json faces = ordered_json::array();
  for (size_t i = 0; i < drawing.view.faces.size(); ++i) {
    const scene::ScreenFace& face = drawing.view.faces[i];
    const scene::Plan& plan = drawing.plans[i];
    const FaceChoice choice = choice_of(scene, drawing, i, target);
    faces.push_back({{"object", scene.objects[face.object].name},
                     {"face", face.face + 1},
                     {"method", choice.method},
                     {"segment_px", choice.segment_px},
                     {"filter", filter_name(plan.options.filter)},
                     {"bound_texel", choice.bound_texel},
                     {"tolerance_texel", tolerance},
                     {"depth_ratio", plan.depth_ratio},
                     {"affine_bound_texel", plan.affine_bound_texel},
                     {"texels_per_px", plan.texels_per_px},
                     {"reason", reason(face, plan)}});
  }
  return faces;
}

std::string explanation_text(const ordered_json& faces) {
  std::ostringstream text;
  for (const ordered_json& face : faces) {
    text << face["object"].get<std::string>() << " face " << face["face"] << ": "
         << face["method"].get<std::string>();
    if (face["segment_px"] > 0) text << " every " << face["segment_px"] << " px";
    text << ", " << face["filter"].get<std::string>() << "; off by at most "
         << show(face["bound_texel"]) << " texel; depths 1:" << show(face["depth_ratio"])
         << ", affine " << show(face["affine_bound_texel"]) << " texel, "
         << show(face["texels_per_px"]) << " texels a pixel; " << face["reason"].get<std::string>()
         << '\n';
  }
  return text.str();
}

ordered_json stats_json(const RenderStats& stats, int32_t frames) {
  const scene::Counts& counts = stats.counts;
  const double written = static_cast<double>(std::max<int64_t>(stats.written_px, 1));
  return {{"frames", frames},
          {"objects", counts.objects},
          {"objects_rejected", counts.objects_rejected},
          {"faces", counts.faces},
          {"faces_clipped_away", counts.clipped_away},
          {"faces_from_behind", counts.backs},
          {"faces_off_screen", counts.off_screen},
          {"faces_refused", counts.refused},
          {"faces_seen", counts.seen},
          {"faces_by_method", stats.drawn_by},
          {"pieces", stats.pieces},
          {"written_px", stats.written_px},
          {"shown_px", stats.shown_px},
          {"compose_ns", stats.compose_ns},
          {"draw_ns", stats.draw_ns},
          {"draw_ns_per_px", static_cast<double>(stats.draw_ns) / written}};
}

std::string stats_text(const RenderStats& stats, int32_t frames) {
  std::ostringstream text;
  const ordered_json values = stats_json(stats, frames);
  for (const auto& item : values.items()) {
    if (item.value().is_object()) {
      for (const auto& method : item.value().items()) {
        text << "  faces, " << method.key() << ": " << method.value() << '\n';
      }
    } else {
      text << item.key() << ": " << item.value() << '\n';
    }
  }
  return text.str();
}

}  // namespace selvage::cli
