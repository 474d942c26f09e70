#include "reports/scenes/choices.h"

#include <stdexcept>

#include "scene/paints.h"

namespace selvage::reports {
namespace {

// Cold colours cost little, warm ones much; the lighter of two alike is the filtered one.
constexpr std::array<ChoiceStyle, kChoices> kStyles{
    {{"one-colour", "one colour: there is no map to get wrong", {150, 154, 162, 255}},
     {"exact-affine", "affine, and exact: one depth, or rows that are copied", {0, 190, 196, 255}},
     {"affine-face-nearest", "affine for the whole face, nearest", {46, 158, 98, 255}},
     {"affine-face-area", "affine for the whole face, area filter", {158, 222, 142, 255}},
     {"affine-row", "straight along the row, nearest", {47, 134, 214, 255}},
     {"subdivided", "a division every few pixels, straight between, nearest", {228, 196, 46, 255}},
     {"exact-nearest", "exact: a division a pixel, nearest", {217, 92, 31, 255}},
     {"exact-area", "exact: a division a pixel, area filter", {199, 133, 216, 255}}}};

[[nodiscard]] Choice kind_of(const scene::ScreenFace& face, const scene::Plan& plan,
                             const selvage_choice& choice) {
  const bool nearest = plan.options.filter == SELVAGE_FILTER_NEAREST;
  if (!face.paint.texture) return Choice::kOneColour;
  if (plan.depth_ratio == 1 || choice.method == SELVAGE_METHOD_COPY) return Choice::kExactAffine;
  if (plan.affine) return nearest ? Choice::kAffineFaceNearest : Choice::kAffineFaceFiltered;
  if (!nearest) return Choice::kExactFiltered;
  switch (choice.method) {
    case SELVAGE_METHOD_AFFINE_FOR_PERSPECTIVE:
      return Choice::kAffineRow;
    case SELVAGE_METHOD_SUBDIVIDED:
      return Choice::kSubdivided;
    case SELVAGE_METHOD_EXACT_AFFINE:
      return Choice::kExactAffine;
    default:
      return Choice::kExactNearest;
  }
}

}  // namespace

const ChoiceStyle& style_of(Choice choice) { return kStyles[static_cast<size_t>(choice)]; }

RowChoices::RowChoices(const scene::Scene& scene, const scene::Drawing& drawing,
                       const scene::Size& size)
    : height_px_(size.height_px),
      rows_(drawing.view.faces.size() * static_cast<size_t>(size.height_px)) {
  cli::Raster raster = cli::filled(size.width_px, size.height_px, {});
  const selvage_image image{raster.rgba.data(), size.width_px, size.height_px,
                            static_cast<ptrdiff_t>(size.width_px) * 4, SELVAGE_RGBA8888};
  scene::Paints paints(scene);
  size_t at = 0;
  for (size_t i = 0; i < drawing.view.faces.size(); ++i) {
    const scene::ScreenFace& face = drawing.view.faces[i];
    const scene::Plan& plan = drawing.plans[i];
    const std::vector<selvage_vertex> vertices = vertices_to_draw(face, plan);
    const selvage_texture texture = paints.texture(face.paint);
    for (int32_t y_px = 0; y_px < height_px_; ++y_px, ++at) {
      const selvage_rect row{0, y_px, size.width_px, y_px + 1};
      selvage_choice choice{};
      const selvage_status status = selvage_choose(&image, &row, vertices.data(), vertices.size(),
                                                   &texture, &plan.options, &choice);
      if (status != SELVAGE_OK) throw std::runtime_error(selvage_status_text(status));
      rows_[at] = {kind_of(face, plan, choice), choice.segment_px,
                   plan.affine ? plan.bound_texel : choice.bound / scene::kSubtexels};
    }
  }
}

}  // namespace selvage::reports
