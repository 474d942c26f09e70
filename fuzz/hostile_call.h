// A call of selvage_draw with raw arguments, and memory behind it that is exactly as large as the
// accepted arguments require: a sanitizer sees the first byte beyond. Claims that would need more
// than a fraction of a megabyte are made smaller.
#pragma once

#include <cstddef>
#include <cstdint>
#include <new>
#include <vector>

#include "fuzz/bytes.h"
#include "selvage.h"

namespace selvage::fuzz {

// One bit each, from the first bytes of the input.
enum Hostility : uint32_t {
  kNoTarget = 1u << 0,
  kNoPixels = 1u << 1,
  kNoClip = 1u << 2,
  kNoVertices = 1u << 3,
  kNoTexture = 1u << 4,
  kNoTexels = 1u << 5,
  kNoOptions = 1u << 6,
  kOddPixels = 1u << 7,          // one byte past an aligned address
  kOddTexels = 1u << 8,          // likewise
  kSharedBitmap = 1u << 9,       // the texture starts inside the target's buffer
  kVerticesInTarget = 1u << 10,  // the vertices lie in the target's first bytes
  kPrepared = 1u << 11,          // texture.prepared is not NULL, and not behind the texels
  kHugeCount = 1u << 12,         // with kNoVertices: a count that nothing backs
  kSums = 1u << 13               // texture.prepared is behind the texels, where it can be
};

// The claims of an image or a texture.
struct Claim {
  int32_t width, height;
  int64_t pitch;
  int32_t format;
};

struct Extent {
  int64_t bytes = 0;  // from the lowest byte to the end of the last row
  int64_t first = 0;  // where the top row starts: not 0 where the pitch is negative
  int32_t pixel_bytes = 1;
};

// At multiples of a tile, so that textures in tiles have a chance.
template <class T>
struct Aligned {
  using value_type = T;
  static constexpr std::align_val_t kAlignment{SELVAGE_PREPARED_ALIGNMENT};
  Aligned() = default;
  template <class U>
  Aligned(const Aligned<U>&) {}
  [[nodiscard]] T* allocate(size_t count) {
    return static_cast<T*>(::operator new(count * sizeof(T), kAlignment));
  }
  void deallocate(T* memory, size_t) { ::operator delete(memory, kAlignment); }
  friend bool operator==(const Aligned&, const Aligned&) { return true; }
};
using Block = std::vector<uint8_t, Aligned<uint8_t>>;

// One call and all the memory behind it.
struct Call {
  uint32_t hostile;
  Claim target_claim, texture_claim;
  int32_t layout;
  selvage_rect clip;
  selvage_options options;
  uint16_t shared_offset;
  Extent target_extent, texture_extent;
  int64_t target_start = 0, texture_start = 0;  // the lowest byte of each in its block
  int64_t sums_offset = 0;  // from the texture's first texel; 0 where it has none
  Block target_block, own_texture_block;
  std::vector<selvage_vertex> vertices;
  bool vertices_in_target = false;

  explicit Call(Bytes bytes);
  [[nodiscard]] bool has(Hostility bit) const { return (hostile & bit) != 0; }
  [[nodiscard]] const selvage_rect* clip_or_null() const { return has(kNoClip) ? nullptr : &clip; }
  [[nodiscard]] Block& texture_block() {
    return has(kSharedBitmap) ? target_block : own_texture_block;
  }
  void place_sums();
  void place();
  [[nodiscard]] selvage_status draw();
};

// The target's pixels are the same in both blocks, whatever may be drawn apart: those inside the
// clip.
[[nodiscard]] bool same_elsewhere(Block after, const Block& before, const Call& call);
// The texels are the same in both blocks, and the sums.
[[nodiscard]] bool same_texels(const Block& after, const Block& before, const Call& call);

}  // namespace selvage::fuzz
