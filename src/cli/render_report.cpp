#include "cli/render_report.h"

#include <algorithm>
#include <sstream>

#include "cli/drawn_kernel.h"
#include "cli/error.h"
#include "cli/job.h"
#include "cli/number.h"
#include "scene/paints.h"

namespace selvage::cli {
namespace {

using nlohmann::ordered_json;

// Why this and nothing cheaper.
[[nodiscard]] std::string method_reason(const scene::ScreenFace& face, const scene::Plan& plan,
                                        double tolerance) {
  if (!face.paint.texture) return "one colour: any map will do";
  if (plan.depth_ratio == 1) return "one depth: affine is exact";
  if (plan.affine) return "affine is within the tolerance";
  if (plan.options.filter != SELVAGE_FILTER_NEAREST)
    return "affine is not, and this filter is exact";
  if (tolerance == 0) return "exact is asked for";
  return plan.options.tolerance > 0 ? "affine is not; the mapper has the tolerance"
                                    : "nothing is left for the mapper";
}

[[nodiscard]] std::string reason(const scene::ScreenFace& face, const scene::Plan& plan,
                                 double tolerance) {
  const bool beyond = plan.rounding_bound_texel > rounding_limit_texel(tolerance);
  return method_reason(face, plan, tolerance) +
         (beyond ? "; rounding depths alone may cost more than " +
                       show(rounding_limit_texel(tolerance)) + " texel"
                 : "");
}

// Each number beside the limit that it was held against.
[[nodiscard]] std::string face_line(const ordered_json& face) {
  const double tolerance = face["tolerance_texel"], rounding = face["rounding_bound_texel"];
  const double spare = std::max(0.0, tolerance - rounding);  // for the mapping
  std::ostringstream text;
  text << face["object"].get<std::string>() << " face " << face["face"] << ": "
       << face["method"].get<std::string>();
  if (face["segment_px"] > 0) text << " every " << face["segment_px"] << " px";
  text << ", " << face["filter"].get<std::string>() << ", kernel "
       << face["kernel"].get<std::string>() << "; off by at most "
       << show_beside(face["bound_texel"], tolerance) << " texel (mapping "
       << show_beside(face["mapping_bound_texel"], spare) << ", rounding "
       << show_beside(rounding, rounding_limit_texel(tolerance))
       << "); depths 1:" << show_beside(face["depth_ratio"], 1) << ", affine "
       << show_beside(face["affine_bound_texel"], spare) << " texel, "
       << show_beside(face["texels_per_px"], 1) << " texels a pixel; "
       << face["reason"].get<std::string>() << '\n';
  return text.str();
}

}  // namespace

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
  const std::string kernel = drawn_kernel(vertices, texture, plan.options, choice.method);
  if (choice.method == SELVAGE_METHOD_FILTER) {
    const bool is_affine = plan.affine || plan.depth_ratio == 1;
    choice.method = is_affine ? SELVAGE_METHOD_EXACT_AFFINE : SELVAGE_METHOD_EXACT_PERSPECTIVE;
  }
  const bool instead = plan.affine && plan.depth_ratio > 1 && seen.paint.texture.has_value();
  const bool by_rows = choice.method == SELVAGE_METHOD_EXACT_PERSPECTIVE && choice.bound > 0;
  return {instead   ? "affine for perspective, whole face"
          : by_rows ? "exact perspective, cheaper in wide rows"
                    : std::string(method_name(choice.method)),
          std::string(filter_name(plan.options.filter)), kernel, choice.segment_px,
          plan.affine ? plan.bound_texel : choice.bound / scene::kSubtexels};
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
                     {"textured", face.paint.texture.has_value()},
                     {"method", choice.method},
                     {"segment_px", choice.segment_px},
                     {"filter", choice.filter},
                     {"kernel", choice.kernel},
                     {"bound_texel", choice.mapping_bound_texel + plan.rounding_bound_texel},
                     {"mapping_bound_texel", choice.mapping_bound_texel},
                     {"rounding_bound_texel", plan.rounding_bound_texel},
                     {"tolerance_texel", tolerance},
                     {"depth_ratio", plan.depth_ratio},
                     {"affine_bound_texel", plan.affine_bound_texel},
                     {"texels_per_px", plan.texels_per_px},
                     {"reason", reason(face, plan, tolerance)}});
  }
  return faces;
}

std::string explanation_text(const ordered_json& faces) {
  std::string text;
  size_t untextured = 0;
  for (const ordered_json& face : faces) {
    if (face["textured"]) {
      text += face_line(face);
    } else {
      ++untextured;
    }
  }
  if (untextured == 0) return text;
  return text + std::to_string(untextured) + (untextured == 1 ? " face" : " faces") +
         " of one colour: any map will do\n";
}

void RoundingWarning::add(const scene::Scene& scene, const scene::Drawing& drawing) {
  for (size_t i = 0; i < drawing.plans.size(); ++i) {
    const double bound_texel = drawing.plans[i].rounding_bound_texel;
    if (bound_texel <= limit_texel_) continue;
    const scene::ScreenFace& face = drawing.view.faces[i];
    faces_.insert({face.object, face.face});
    if (bound_texel <= worst_texel_) continue;
    worst_texel_ = bound_texel;
    worst_ = scene.objects[face.object].name + " face " + std::to_string(face.face + 1);
  }
}

std::string RoundingWarning::line() const {
  if (faces_.empty()) return "";
  std::ostringstream text;
  text << "warning: rounding depths to whole q may move the texture of " << faces_.size()
       << (faces_.size() == 1 ? " face" : " faces") << " by more than " << show(limit_texel_)
       << " texel, that of " << worst_ << " by up to " << show_beside(worst_texel_, limit_texel_)
       << "; a camera's \"nearest\" that cuts off what is very near lessens it\n";
  return text.str();
}

}  // namespace selvage::cli
