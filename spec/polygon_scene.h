// What law SAME draws in many ways: some polygons, of one case.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "spec/canvas.h"
#include "spec/case.h"
#include "spec/geometry.h"
#include "spec/picture.h"
#include "spec/subject.h"
#include "spec/texture_memory.h"

namespace selvage::spec {

inline constexpr uint8_t kSceneBackground = 0x5A;

// Polygons over each other in the order of drawing, of three kinds in turn: copies of the case's
// outline, triangles of its vertices, copies with one q; of two textures that differ in every
// texel, and often in size.
class PolygonScene {
 public:
  PolygonScene(const Subject& subject, const Case& c);

  [[nodiscard]] const Case& shown() const { return case_; }
  [[nodiscard]] size_t count() const { return outlines_.size(); }
  [[nodiscard]] Canvas blank() const {
    return {case_.format,     case_.target_width_px, case_.target_height_px,
            case_.padding_px, case_.flip_target,     kSceneBackground};
  }
  [[nodiscard]] const selvage_rect* clip() const { return case_.has_clip ? &case_.clip : nullptr; }
  [[nodiscard]] selvage_options options(selvage_kernel kernel = SELVAGE_KERNEL_FASTEST) const {
    return {case_.profile, case_.filter, case_.address, 0, kernel};
  }
  [[nodiscard]] const std::vector<selvage_vertex>& outline(size_t i) const { return outlines_[i]; }
  // Polygon i alone: its outline, and the size of its texture.
  [[nodiscard]] Case case_of(size_t i) const;
  // "as copies of it, moved by (0, 0), (-2, 7) as a triangle of it px: ..."
  [[nodiscard]] std::string copies() const;
  // The texture of polygon i.
  [[nodiscard]] TexelAt texels_of(size_t i) const;
  // Lays it out: in new memory, or in that of another one's.
  void put_texture(const Subject& subject, size_t i, std::optional<TextureMemory>* memory) const;
  // What is left of the background counts as not drawn: no other way to tell it from a texel.
  [[nodiscard]] Picture picture_of(const Canvas& drawn) const;
  // Of either texture. Where a texel of the one has the value of one of the other, the first is
  // told.
  [[nodiscard]] std::string describe(const std::optional<uint32_t>& pixel) const;
  // Views of the scene.
  [[nodiscard]] std::vector<selvage_texture> textures() const {
    return {textures_[0].view(), textures_[1].view()};
  }
  [[nodiscard]] std::vector<selvage_polygon> polygons(
      const std::vector<selvage_texture>& textures) const;

 private:
  // The last one is then where the one before is, with other (u, v); it hides that.
  [[nodiscard]] bool is_last_turned() const { return moves_.size() > 2 && case_.choice % 4 < 2; }

  enum class Kind : uint8_t { kCopy, kTriangle, kOneQ };

  Case case_, second_;  // the case with the size and layout of the second texture
  std::array<TextureMemory, 2> textures_;
  std::vector<Pixel> moves_;  // of the case's outline: of none to begin with, then of each copy
  std::vector<Kind> kinds_;
  std::vector<std::vector<selvage_vertex>> outlines_;
};

}  // namespace selvage::spec
