// Lists of polygons, raw ones among them -> selvage_draw_many. Law SAME and law TOTAL: what it
// draws is what selvage_draw draws one after another; if one of them is refused, that one is named
// and nothing is drawn; no byte beyond the scratch memory that it asked for is written.
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

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const Scene scene{selvage::fuzz::Bytes(data, size)};
  const auto area = static_cast<size_t>(scene.width_px) * static_cast<size_t>(scene.height_px);
  const std::vector<uint8_t> blank(area, 0xA5);
  std::vector<uint8_t> in_turn = blank, together = blank;
  const selvage_image one = scene.on(in_turn), all = scene.on(together);

  selvage_status wanted = SELVAGE_OK;
  size_t refused = 0;
  for (; refused < scene.polygons.size(); ++refused) {
    const auto& [vertices, count, texture] = scene.polygons[refused];
    wanted = selvage_draw(&one, &scene.clip, vertices, count, texture, &scene.options);
    if (wanted != SELVAGE_OK) break;
  }
  // Exactly as large as asked for: a sanitizer sees the first byte beyond.
  const size_t bytes = selvage_draw_many_bytes(scene.polygons.size());
  void* const scratch = std::malloc(bytes + 1);
  if (scratch == nullptr) return 0;
  static_cast<uint8_t*>(scratch)[bytes] = 0x77;
  size_t failed = scene.polygons.size();
  const selvage_status status =
      selvage_draw_many(&all, &scene.clip, scene.polygons.data(), scene.polygons.size(),
                        &scene.options, scene.threads, scratch, bytes, &failed);
  require(static_cast<uint8_t*>(scratch)[bytes] == 0x77, "wrote beyond its scratch memory", status);
  std::free(scratch);

  if (scene.polygons.empty()) return 0;  // bad options are errors even then
  require(status == wanted, "not the status of one after another", status);
  require(together == (status == SELVAGE_OK ? in_turn : blank), "not the picture due", status);
  if (status >= SELVAGE_ERROR_PROFILE && status <= SELVAGE_ERROR_KERNEL) return 0;
  require(failed == refused, "another polygon is named", status);
  return 0;
}
