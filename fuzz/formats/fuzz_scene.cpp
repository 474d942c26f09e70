// Bytes -> the files of a scene -> its picture. What is accepted must be drawn, each way.
//
// The bytes are a scene's JSON, an OBJ, an MTL file and a picture, one behind another, with a byte
// 0x1c (ASCII's file separator) between; a file is taken by how its name ends, whatever its name.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <vector>

#include "cli/error.h"
#include "cli/scene_file.h"
#include "scene/draw.h"

namespace {

using namespace selvage;

using Bytes = std::vector<uint8_t>;
constexpr uint8_t kSeparator = 0x1c;
constexpr std::array<const char*, 3> kTexts = {".json", ".obj", ".mtl"};  // the rest: the picture
constexpr scene::Size kSize{24, 18};
constexpr int64_t kMostTexels = 1 << 16;  // larger ones would only run slower

[[nodiscard]] std::array<Bytes, 4> split(const uint8_t* data, size_t size) {
  std::array<Bytes, 4> parts;
  const uint8_t* end = data + size;
  for (size_t i = 0; i + 1 < parts.size(); ++i) {
    const uint8_t* separator = std::find(data, end, kSeparator);
    parts[i].assign(data, separator);
    data = std::min(separator + 1, end);
  }
  parts.back().assign(data, end);
  return parts;
}

[[nodiscard]] size_t part_of(const std::filesystem::path& path) {
  const auto text = std::find(kTexts.begin(), kTexts.end(), path.extension().string());
  return static_cast<size_t>(text - kTexts.begin());
}

// All faces are accounted for, none is refused, and the mapper takes each piece.
void draw(const scene::Scene& scene, double time_s, scene::Hidden way) {
  const scene::Wish wish{scene.tolerance_texel, {}};
  const scene::Drawing drawing = compose(scene, time_s, kSize, wish, way);
  const scene::Counts& counts = drawing.view.counts;
  if (counts.refused != 0) std::abort();
  if (counts.faces !=
      counts.clipped_away + counts.backs + counts.edge_on + counts.off_screen + counts.seen) {
    std::abort();
  }
  if (drawing.plans.size() != drawing.view.faces.size()) std::abort();
  Bytes pixels(static_cast<size_t>(kSize.width_px * kSize.height_px) * 4);
  const selvage_image image{pixels.data(), kSize.width_px, kSize.height_px, kSize.width_px * 4,
                            SELVAGE_RGBA8888};
  if (draw(scene, drawing, image) != SELVAGE_OK) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::array<Bytes, 4> parts = split(data, size);
  cli::SceneFiles files;
  files.read = [&](const std::filesystem::path& path) { return parts[part_of(path)]; };
  try {
    const scene::Scene scene = cli::read_scene("scene.json", files);
    for (const scene::TextureImage& texture : scene.textures) {
      if (int64_t{texture.width_texel} * texture.height_texel > kMostTexels) return 0;
    }
    for (const double time_s : {0.0, 1.5}) {
      for (const auto way : {scene::Hidden::kScanLine, scene::Hidden::kPainter}) {
        draw(scene, time_s, way);
      }
    }
  } catch (const cli::UserError&) {
    // A clear refusal is a right answer; anything else that is thrown ends the program.
  }
  return 0;
}
