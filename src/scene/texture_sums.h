// Textures with sums for the area filter, made when they pay.
//
// To make them costs as much as visiting some texels, and whether a scene will go on to spare so
// many is not known. So they are made when as much has been lost without them: whatever comes, that
// costs at most twice what the better of always and never would. The picture is the same.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>

#include "selvage.h"

namespace selvage::scene {

using Clock = int64_t (*)();  // ns since whenever

// What sums cost for each texel of the texture, in texels visited. Measured: 13 ns, against 0.45.
inline constexpr double kMakingSums_texels = 30;

class TextureSums {
 public:
  // Copies with sums, texels and all, are made as long as all of them have at most so many bytes.
  TextureSums(size_t most_bytes, Clock now_ns) : most_bytes_(most_bytes), now_ns_(now_ns) {}

  // The texture itself, or its copy with sums, which is good as long as this is. By `number` it is
  // known again; its texels stay as they are. Sums would spare so many texels now.
  [[nodiscard]] selvage_texture of(size_t number, const selvage_texture& texture,
                                   double spared_texels);

  [[nodiscard]] size_t bytes() const { return bytes_; }
  // What making them has cost until now.
  [[nodiscard]] int64_t ns() const { return ns_; }

 private:
  struct alignas(SELVAGE_PREPARED_ALIGNMENT) Block {
    std::byte bytes[SELVAGE_PREPARED_ALIGNMENT];
  };
  struct Copy {
    double lost_texels = 0;
    std::unique_ptr<Block[]> memory;  // once it is made
    selvage_texture texture{};
  };
  void make(const selvage_texture& texture, Copy& copy);

  size_t most_bytes_, bytes_ = 0;
  Clock now_ns_;
  int64_t ns_ = 0;
  std::map<size_t, Copy> copies_;
};

}  // namespace selvage::scene
