// Law SAME: neither layouts nor tiles nor threads nor kernels show in the picture, nor what the
// memory has held before.
#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "spec/canvas.h"
#include "spec/law_list.h"
#include "spec/law_tools.h"
#include "spec/polygon_scene.h"
#include "spec/refusal.h"
#include "spec/scene_model.h"
#include "spec/status_name.h"
#include "spec/texture_memory.h"

namespace selvage::spec {
namespace {

inline constexpr std::array<int32_t, 6> kThreads = {1, 2, 3, 8, 0, 64};  // 0: all
inline constexpr std::array kKernels = {SELVAGE_KERNEL_SCALAR, SELVAGE_KERNEL_SSE4,
                                        SELVAGE_KERNEL_AVX2, SELVAGE_KERNEL_AVX512,
                                        SELVAGE_KERNEL_NEON};
struct Drawn {
  Canvas canvas;
  selvage_status status = SELVAGE_OK;
};

// One polygon after another; the first error ends it.
[[nodiscard]] selvage_status draw_each(const Subject& subject, const PolygonScene& scene,
                                       Canvas* canvas, const selvage_rect* clip,
                                       selvage_kernel kernel = SELVAGE_KERNEL_FASTEST) {
  const selvage_image image = canvas->image();
  const selvage_options options = scene.options(kernel);
  const auto textures = scene.textures();
  for (const selvage_polygon& p : scene.polygons(textures)) {
    const selvage_status status = with_shown(scene.shown(), [&] {
      return subject.draw(&image, clip, p.vertices, p.count, p.texture, &options);
    });
    if (status != SELVAGE_OK) return status;
  }
  return SELVAGE_OK;
}

[[nodiscard]] Drawn draw_in_turn(const Subject& subject, const PolygonScene& scene,
                                 selvage_kernel kernel = SELVAGE_KERNEL_FASTEST) {
  Drawn drawn{scene.blank()};
  drawn.status = draw_each(subject, scene, &drawn.canvas, scene.clip(), kernel);
  return drawn;
}

// Through clip rectangles that tile what is visible, in any order.
[[nodiscard]] Drawn draw_in_tiles(const Subject& subject, const PolygonScene& scene) {
  const Case& c = scene.shown();
  Choices choices(c.choice + 2);
  selvage_rect whole = {0, 0, c.target_width_px, c.target_height_px};
  if (c.has_clip) {
    whole = {std::max(whole.left, c.clip.left), std::max(whole.top, c.clip.top),
             std::min(whole.right, c.clip.right), std::min(whole.bottom, c.clip.bottom)};
  }
  const int32_t height_px = choices.pick(c.target_height_px / 4, c.target_height_px) + 1;
  const int32_t width_px = choices.pick(c.target_width_px / 3, c.target_width_px) + 1;
  std::vector<selvage_rect> tiles;
  for (int32_t top = whole.top; top < whole.bottom; top += height_px) {
    for (int32_t left = whole.left; left < whole.right; left += width_px) {
      tiles.push_back({left, top, std::min(left + width_px, whole.right),
                       std::min(top + height_px, whole.bottom)});
    }
  }
  Drawn drawn{scene.blank()};
  while (!tiles.empty() && drawn.status == SELVAGE_OK) {
    std::swap(tiles[static_cast<size_t>(choices.pick(0, static_cast<int32_t>(tiles.size())))],
              tiles.back());
    drawn.status = draw_each(subject, scene, &drawn.canvas, &tiles.back());
    tiles.pop_back();
  }
  return drawn;
}

// Each from the memory of the one before, whose vertices and texels it held.
[[nodiscard]] Drawn draw_in_one_memory(const Subject& subject, const PolygonScene& scene) {
  Drawn drawn{scene.blank()};
  const selvage_image image = drawn.canvas.image();
  const selvage_options options = scene.options();
  std::optional<TextureMemory> texture;
  std::vector<selvage_vertex> vertices;
  for (size_t i = 0; i < scene.count() && drawn.status == SELVAGE_OK; ++i) {
    if (subject.begin_case) subject.begin_case();  // else it would be given memory in turn
    drawn.status = with_shown(scene.shown(), [&] {
      scene.put_texture(subject, i, &texture);
      vertices = scene.outline(i);
      return subject.draw(&image, scene.clip(), vertices.data(), vertices.size(), &texture->view(),
                          &options);
    });
  }
  return drawn;
}

[[nodiscard]] Drawn draw_together(const Subject& subject, const PolygonScene& scene,
                                  int32_t threads) {
  Drawn drawn{scene.blank()};
  const selvage_image image = drawn.canvas.image();
  const selvage_options options = scene.options();
  const auto textures = scene.textures();
  const auto polygons = scene.polygons(textures);
  drawn.status = with_shown(scene.shown(), [&] {
    return subject.draw_many(&image, scene.clip(), polygons.data(), polygons.size(), &options,
                             threads, nullptr);
  });
  return drawn;
}

[[nodiscard]] Violation difference(const PolygonScene& scene, const std::string& what,
                                   const Drawn& in_turn, const Drawn& other) {
  const Picture wanted = scene.picture_of(in_turn.canvas), drawn = scene.picture_of(other.canvas);
  Violation violation{.law = "SAME", .what = what, .shown = scene.shown()};
  violation.scene = scene.copies();
  const auto at = std::ranges::mismatch(wanted.pixels, drawn.pixels);
  if (at.in1 == wanted.pixels.end()) {
    violation.allowed = "the bytes beside the pixels as they were";
    violation.drawn = "others";
    return violation;
  }
  const auto index = static_cast<int32_t>(at.in1 - wanted.pixels.begin());
  violation.x_px = index % wanted.width_px;
  violation.y_px = index / wanted.width_px;
  violation.allowed = scene.describe(*at.in1) + ", as one after another";
  violation.drawn = scene.describe(*at.in2);
  violation.comparison = std::make_shared<const Comparison>(Comparison{drawn, wanted, false});
  return violation;
}

// Every byte, those beside the pixels included.
[[nodiscard]] Judgement judge_other(const PolygonScene& scene, const std::string& what,
                                    const Drawn& in_turn, const Drawn& other) {
  const Case& c = scene.shown();
  Judgement judgement = {.judged_px = static_cast<uint64_t>(c.target_width_px) *
                                      static_cast<uint64_t>(c.target_height_px)};
  if (other.status != in_turn.status) {
    judgement.violation =
        violation_of_call("SAME", what, c, "status " + status_name(in_turn.status),
                          "status " + status_name(other.status));
  } else if (!(other.canvas == in_turn.canvas)) {
    judgement.violation = difference(scene, what, in_turn, other);
  }
  return judgement;
}

// Holds drawings of a scene against the one that draws a polygon after another, or, where a subject
// does not draw exactly and two drawings may differ by that, all of them against the model.
class SceneJudge {
 public:
  SceneJudge(const Subject& subject, const PolygonScene& scene)
      : scene_(scene), in_turn_(draw_in_turn(subject, scene)) {
    demand_drawn(in_turn_.status, scene.shown());
    if (!draws_exactly(subject.claims)) model_.emplace(scene, subject.claims);
  }

  [[nodiscard]] Judgement judge_in_turn() const {
    if (!model_) return {};
    return model_->judge(polygons() + "one after another show their texels", in_turn_.canvas);
  }
  // `how` they were drawn: "tile by tile".
  [[nodiscard]] Judgement judge(const std::string& how, const Drawn& other) const {
    const std::string what = polygons() + how + " show what they show one after another";
    if (!model_ || other.status != in_turn_.status) {
      return judge_other(scene_, what, in_turn_, other);
    }
    return model_->judge(what, other.canvas);
  }

 private:
  [[nodiscard]] std::string polygons() const {
    return std::to_string(scene_.count()) + " polygons drawn ";
  }

  const PolygonScene& scene_;
  Drawn in_turn_;
  std::optional<SceneModel> model_;
};

[[nodiscard]] Judgement check_scene(const Subject& subject, const Case& c) {
  const PolygonScene scene(subject, c);
  const SceneJudge judge(subject, scene);
  Judgement judgement = judge.judge_in_turn();
  if (judgement.violation) return judgement;
  if (subject.claims.clip &&
      add(&judgement, judge.judge("tile by tile", draw_in_tiles(subject, scene)))) {
    return judgement;
  }
  if (add(&judgement, judge.judge("each from the memory that held the one before",
                                  draw_in_one_memory(subject, scene)))) {
    return judgement;
  }
  for (const selvage_kernel kernel : kKernels) {
    if (!subject.claims.named_errors) break;  // for it may have none but the fastest
    const Drawn by_kernel = draw_in_turn(subject, scene, kernel);
    if (by_kernel.status == SELVAGE_ERROR_KERNEL) continue;  // not one for this machine
    const std::string how = "by kernel " + std::to_string(kernel) + " of selvage_kernel";
    if (add(&judgement, judge.judge(how, by_kernel))) return judgement;
  }
  if (!subject.draw_many) return judgement;
  for (const int32_t threads : kThreads) {
    const std::string how = "in one call, by " + (threads == 0 ? "all" : std::to_string(threads)) +
                            (threads == 1 ? " thread," : " threads,");
    if (add(&judgement, judge.judge(how, draw_together(subject, scene, threads)))) break;
  }
  return judgement;
}

}  // namespace

Judgement check_same(const Subject& subject, const Case& c) {
  // From a texel on it is not promised, and what it would allow is without end.
  if (!is_valid(c) || subject.claims.accuracy_fx16 >= SELVAGE_SUBTEXELS) return {};
  Judgement judgement;
  // Two layouts may differ in texels that are not exact: all laws draw from either.
  if (shows_exact_texels(subject.claims)) judgement = check_same_layouts(subject, c);
  if (judgement.violation) return judgement;
  demand_claimed(subject, c);
  // Nor is it promised that texels that were rounded once are rounded the same again, or elsewhere.
  if (shows_exact_texels(subject.claims)) {
    for (const auto part : {check_same_again, check_same_place, check_same_texture}) {
      if (add(&judgement, part(subject, c))) return judgement;
    }
  }
  add(&judgement, check_scene(subject, c));
  return judgement;
}

}  // namespace selvage::spec
