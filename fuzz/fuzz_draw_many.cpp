// Lists of polygons, raw ones among them -> selvage_draw_many. Law SAME and law TOTAL: what it
// draws, by each kernel of the machine, is what selvage_draw draws one after another; if one of
// them is refused, that one is named and nothing is drawn; no byte beyond the scratch memory that
// it asked for is written.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "fuzz/bytes.h"
#include "selvage.h"

namespace {

constexpr int32_t kMostSide_px = 128;
constexpr size_t kMostPolygons = 64, kMostVertices = 8;

void require(bool holds, const char* what, selvage_status status) {
  if (holds) return;
  std::fprintf(stderr, "selvage_draw_many: %s (status %d: %s)\n", what, status,
               selvage_status_text(status));
  std::abort();
}

struct Scene {
  int32_t width_px, height_px, threads;
  selvage_rect clip;
  selvage_options options;
  std::vector<uint8_t> texels = std::vector<uint8_t>(16 * 16);
  selvage_texture texture{texels.data(), 16, 16, 16, SELVAGE_INDEX8, SELVAGE_LAYOUT_ROWS, nullptr};
  std::vector<std::vector<selvage_vertex>> outlines;
  std::vector<selvage_polygon> polygons;

  explicit Scene(selvage::fuzz::Bytes bytes)
      : width_px(1 + bytes.take<uint8_t>() % kMostSide_px),
        height_px(1 + bytes.take<uint8_t>() % kMostSide_px),
        threads(bytes.take<uint8_t>() % 9),
        clip(bytes.take<selvage_rect>()),
        options(bytes.take<selvage_options>()) {
    for (size_t i = 0; i < texels.size(); ++i) texels[i] = static_cast<uint8_t>(i);
    while (bytes.left() > 0 && outlines.size() < kMostPolygons) {
      auto& outline = outlines.emplace_back(bytes.take<uint8_t>() % (kMostVertices + 1));
      for (selvage_vertex& vertex : outline) vertex = bytes.take<selvage_vertex>();
      outline.reserve(1);  // no vertices are not NULL vertices
    }
    for (const auto& outline : outlines) {
      polygons.push_back({outline.data(), outline.size(), &texture});
    }
  }
  [[nodiscard]] selvage_image on(std::vector<uint8_t>& pixels) const {
    return {pixels.data(), width_px, height_px, width_px, SELVAGE_INDEX8};
  }
};

struct Drawn {
  selvage_status status = SELVAGE_OK;
  size_t refused = 0;  // the first one that is, or as many as there are
  std::vector<uint8_t> pixels;
};

[[nodiscard]] std::vector<uint8_t> blank(const Scene& scene) {
  const auto area = static_cast<size_t>(scene.width_px) * static_cast<size_t>(scene.height_px);
  return std::vector<uint8_t>(area, 0xA5);
}

[[nodiscard]] Drawn draw_in_turn(const Scene& scene) {
  Drawn drawn{.pixels = blank(scene)};
  const selvage_image image = scene.on(drawn.pixels);
  for (; drawn.refused < scene.polygons.size(); ++drawn.refused) {
    const auto& [vertices, count, texture] = scene.polygons[drawn.refused];
    drawn.status = selvage_draw(&image, &scene.clip, vertices, count, texture, &scene.options);
    if (drawn.status != SELVAGE_OK) break;
  }
  if (drawn.status != SELVAGE_OK) drawn.pixels = blank(scene);
  return drawn;
}

[[nodiscard]] Drawn draw_together(const Scene& scene, const selvage_options& options) {
  Drawn drawn{.refused = scene.polygons.size(), .pixels = blank(scene)};
  const selvage_image image = scene.on(drawn.pixels);
  // Exactly as large as asked for: a sanitizer sees the first byte beyond.
  const size_t bytes = selvage_draw_many_bytes(scene.polygons.size());
  std::vector<uint8_t> scratch(bytes + 1);
  scratch[bytes] = 0x77;
  drawn.status =
      selvage_draw_many(&image, &scene.clip, scene.polygons.data(), scene.polygons.size(), &options,
                        scene.threads, scratch.data(), bytes, &drawn.refused);
  require(scratch[bytes] == 0x77, "wrote beyond its scratch memory", drawn.status);
  return drawn;
}

// What the fastest one draws is no other kernel's within a tolerance.
void require_of_each_kernel(const Scene& scene, const Drawn& wanted) {
  if (wanted.status != SELVAGE_OK || scene.options.tolerance != 0) return;
  for (selvage_kernel kernel = SELVAGE_KERNEL_SCALAR; kernel <= SELVAGE_KERNEL_NEON; ++kernel) {
    selvage_options options = scene.options;
    options.kernel = kernel;
    const Drawn drawn = draw_together(scene, options);
    if (drawn.status == SELVAGE_ERROR_KERNEL) continue;
    require(drawn.pixels == wanted.pixels, "not the picture due by each kernel", drawn.status);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const Scene scene{selvage::fuzz::Bytes(data, size)};
  const Drawn wanted = draw_in_turn(scene), drawn = draw_together(scene, scene.options);
  if (scene.polygons.empty()) return 0;  // bad options are errors even then
  require(drawn.status == wanted.status, "not the status of one after another", drawn.status);
  require(drawn.pixels == wanted.pixels, "not the picture due", drawn.status);
  require_of_each_kernel(scene, wanted);
  if (drawn.status >= SELVAGE_ERROR_PROFILE && drawn.status <= SELVAGE_ERROR_KERNEL) return 0;
  require(drawn.refused == wanted.refused, "another polygon is named", drawn.status);
  return 0;
}
