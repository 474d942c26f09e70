// What a subject drew while a case was judged, kept: it may not draw the same again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "spec/picture.h"

namespace selvage::spec {

class Drawings {
 public:
  void note(const Case& c, const TexelAt& texel_at, const Picture& picture);
  // The last picture of this case with this texture; null where none was noted.
  [[nodiscard]] const Picture* find(const Case& c, const TexelAt& texel_at) const;

 private:
  struct Drawing {
    Case scene;
    std::pair<uint32_t, uint32_t> texels;  // two of them tell the textures apart
    Picture picture;
  };
  std::vector<Drawing> drawings_;
  size_t pixels_ = 0;
};

}  // namespace selvage::spec
