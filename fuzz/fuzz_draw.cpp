// Raw hostile arguments -> selvage_draw. Laws TOTAL and MEM: a picture or a named error, an error
// draws nothing, nothing outside the clip or between the rows is written, inputs stay as they were.
//
// Arguments may lie about everything but the memory behind them: buffers are heap blocks exactly as
// large as the claims require, so a sanitizer sees the first byte beyond; claims that would need
// more than kMaxImageBytes are made smaller.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <vector>

#include "fuzz/bytes.h"
#include "selvage.h"

namespace {

using selvage::fuzz::Bytes;
__extension__ typedef __int128 Wide;  // holds height x pitch

constexpr int32_t kMaxImageBytes = 1 << 18;

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
  kPrepared = 1u << 11,          // texture.prepared is not NULL
  kHugeCount = 1u << 12          // with kNoVertices: a count that nothing backs
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

int32_t pixel_bytes(int32_t format) {
  return format == SELVAGE_INDEX8 ? 1 : format == SELVAGE_RGB565 ? 2 : 4;
}

Wide magnitude(int64_t pitch) { return pitch < 0 ? -static_cast<Wide>(pitch) : pitch; }

// The memory that a claim needs if it may be accepted; nothing if it must be refused. Shrinks a
// claim that would need too much.
Extent settle(Claim& claim) {
  Extent extent;
  if (claim.format < SELVAGE_INDEX8 || claim.format > SELVAGE_RGBA8888) return extent;
  extent.pixel_bytes = pixel_bytes(claim.format);
  if (claim.width < 1 || claim.height < 1) return extent;
  const auto span = [&] {
    return (claim.height - 1) * magnitude(claim.pitch) +
           static_cast<Wide>(claim.width) * extent.pixel_bytes;
  };
  if (magnitude(claim.pitch) < static_cast<Wide>(claim.width) * extent.pixel_bytes) return extent;
  if (span() > std::numeric_limits<ptrdiff_t>::max()) return extent;
  claim.width = std::min(claim.width, kMaxImageBytes / extent.pixel_bytes);
  if (span() > kMaxImageBytes) {
    const Wide room = kMaxImageBytes - claim.width * extent.pixel_bytes;
    claim.height = static_cast<int32_t>(1 + room / magnitude(claim.pitch));
  }
  extent.bytes = static_cast<int64_t>(span());
  if (claim.pitch < 0) {
    extent.first = static_cast<int64_t>((claim.height - 1) * magnitude(claim.pitch));
  }
  return extent;
}

// A block of exactly this many bytes, filled with a pattern; of one byte where none are needed, so
// that it has an address.
std::vector<uint8_t> block(int64_t size_bytes, uint32_t state) {
  std::vector<uint8_t> memory(static_cast<size_t>(std::max<int64_t>(size_bytes, 1)));
  for (uint8_t& byte : memory) byte = static_cast<uint8_t>((state = state * 1664525u + 1u) >> 24);
  return memory;
}

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
  std::vector<uint8_t> target_block, own_texture_block;
  std::vector<selvage_vertex> vertices;
  bool vertices_in_target = false;

  explicit Call(Bytes bytes);
  [[nodiscard]] bool has(Hostility bit) const { return (hostile & bit) != 0; }
  [[nodiscard]] const selvage_rect* clip_or_null() const { return has(kNoClip) ? nullptr : &clip; }
  [[nodiscard]] std::vector<uint8_t>& texture_block() {
    return has(kSharedBitmap) ? target_block : own_texture_block;
  }
  void place();
  [[nodiscard]] selvage_status draw();
};

Call::Call(Bytes bytes)
    : hostile(bytes.take<uint32_t>()),
      target_claim(bytes.take<Claim>()),
      texture_claim(bytes.take<Claim>()),
      layout(bytes.take<int32_t>()),
      clip(bytes.take<selvage_rect>()),
      options(bytes.take<selvage_options>()),
      shared_offset(bytes.take<uint16_t>()),
      target_extent(settle(target_claim)),
      texture_extent(settle(texture_claim)) {
  vertices.reserve(std::max<size_t>(bytes.left() / sizeof(selvage_vertex), 1));  // exact
  while (bytes.left() >= sizeof(selvage_vertex)) {
    vertices.push_back(bytes.take<selvage_vertex>());
  }
  place();
}

// Lays out the memory: the target in its block, the texture in its own or in the same.
void Call::place() {
  target_start = has(kOddPixels) ? 1 : 0;
  texture_start = (has(kOddTexels) ? 1 : 0) + (has(kSharedBitmap) ? shared_offset : 0);
  const int64_t target_end = target_start + target_extent.bytes;
  const int64_t texture_end = texture_start + texture_extent.bytes;
  const bool shared = has(kSharedBitmap);
  target_block = block(shared ? std::max(target_end, texture_end) : target_end, 1);
  own_texture_block = block(shared ? 0 : texture_end, 2);
  const size_t vertex_bytes = vertices.size() * sizeof(selvage_vertex);
  vertices_in_target = has(kVerticesInTarget) && !has(kNoVertices) && !vertices.empty() &&
                       static_cast<int64_t>(vertex_bytes) <= target_extent.bytes;
  if (vertices_in_target) std::memcpy(target_block.data(), vertices.data(), vertex_bytes);
}

selvage_status Call::draw() {
  const Claim& t = target_claim;
  const Claim& s = texture_claim;
  const selvage_image target = {
      has(kNoPixels) ? nullptr : target_block.data() + target_start + target_extent.first, t.width,
      t.height, static_cast<ptrdiff_t>(t.pitch), t.format};
  const selvage_texture texture = {
      has(kNoTexels) ? nullptr : texture_block().data() + texture_start + texture_extent.first,
      s.width,
      s.height,
      static_cast<ptrdiff_t>(s.pitch),
      s.format,
      layout,
      has(kPrepared) ? &layout : nullptr};
  const selvage_vertex* corners = vertices.data();
  if (vertices_in_target) corners = reinterpret_cast<const selvage_vertex*>(target_block.data());
  if (has(kNoVertices)) corners = nullptr;
  const size_t count = has(kNoVertices) && has(kHugeCount) ? SIZE_MAX : vertices.size();
  return selvage_draw(has(kNoTarget) ? nullptr : &target, clip_or_null(), corners, count,
                      has(kNoTexture) ? nullptr : &texture, has(kNoOptions) ? nullptr : &options);
}

void require(bool holds, const char* what, selvage_status status) {
  if (holds) return;
  std::fprintf(stderr, "selvage_draw: %s (status %d: %s)\n", what, status,
               selvage_status_text(status));
  std::abort();
}

// Whether columns [left, right) of rows [top, bottom) of an image are the same in both blocks.
bool same_pixels(const std::vector<uint8_t>& a, const std::vector<uint8_t>& b, int64_t top_row,
                 const Claim& claim, const selvage_rect& part) {
  const int64_t bytes = pixel_bytes(claim.format);
  for (int64_t row = part.top; row < part.bottom; ++row) {
    const int64_t begin = top_row + row * claim.pitch + part.left * bytes;
    const int64_t length = std::max<int64_t>(part.right - part.left, 0) * bytes;
    if (!std::equal(a.begin() + begin, a.begin() + begin + length, b.begin() + begin)) return false;
  }
  return true;
}

// The same after what may be drawn, the pixels inside target and clip, is copied from `before`.
bool same_elsewhere(std::vector<uint8_t> after, const std::vector<uint8_t>& before,
                    const Call& call) {
  const Claim& claim = call.target_claim;
  const int64_t bytes = pixel_bytes(claim.format);
  selvage_rect part = {0, 0, claim.width, claim.height};
  if (const selvage_rect* clip = call.clip_or_null()) {
    part = {std::max(part.left, clip->left), std::max(part.top, clip->top),
            std::min(part.right, clip->right), std::min(part.bottom, clip->bottom)};
  }
  const int64_t top_row = call.target_start + call.target_extent.first;
  for (int64_t row = part.top; row < part.bottom && part.left < part.right; ++row) {
    const int64_t begin = top_row + row * claim.pitch + part.left * bytes;
    std::copy_n(before.begin() + begin, (part.right - part.left) * bytes, after.begin() + begin);
  }
  return after == before;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  Call call{Bytes(data, size)};
  const std::vector<uint8_t> target_before = call.target_block;
  const std::vector<uint8_t> texture_before = call.texture_block();
  const std::vector<selvage_vertex> vertices_before = call.vertices;
  const selvage_status status = call.draw();

  require(status >= SELVAGE_OK && status < SELVAGE_STATUS_COUNT, "a status without a name", status);
  require(
      call.vertices.empty() || std::memcmp(call.vertices.data(), vertices_before.data(),
                                           vertices_before.size() * sizeof(selvage_vertex)) == 0,
      "wrote to the vertices", status);
  if (status != SELVAGE_OK) {
    require(call.target_block == target_before, "drew in spite of an error", status);
    return 0;
  }
  require(!call.vertices_in_target, "drew over its own vertices", status);
  const Claim& texture = call.texture_claim;
  require(same_pixels(call.texture_block(), texture_before,
                      call.texture_start + call.texture_extent.first, texture,
                      {0, 0, texture.width, texture.height}),
          "wrote to the texture", status);
  require(same_elsewhere(call.target_block, target_before, call), "wrote outside the clip", status);
  return 0;
}
