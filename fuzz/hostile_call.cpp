#include "fuzz/hostile_call.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace selvage::fuzz {
namespace {

__extension__ typedef __int128 Wide;  // holds height x pitch

// The area filter may look at all of the texture for each pixel.
int32_t most_image_bytes(const selvage_options& options) {
  return options.filter == SELVAGE_FILTER_AREA ? 1 << 15 : 1 << 18;
}

int32_t pixel_bytes(int32_t format) {
  return format == SELVAGE_INDEX8 ? 1 : format == SELVAGE_RGB565 ? 2 : 4;
}

Wide magnitude(int64_t pitch) { return pitch < 0 ? -static_cast<Wide>(pitch) : pitch; }

// Texels that lie together: one, or a tile of 4 x 4.
int32_t side_of(int32_t layout) { return layout == SELVAGE_LAYOUT_TILES ? 4 : 1; }

// How the bytes of a claim lie: rows of texels, or of tiles. Its format is known, its size
// positive.
struct Shape {
  int64_t rows, row_bytes;
};
Shape shape_of(const Claim& claim, int32_t layout) {
  const int64_t side = side_of(layout);
  return {(claim.height + side - 1) / side,
          (claim.width + side - 1) / side * side * side * pixel_bytes(claim.format)};
}

// The memory that a claim needs if it may be accepted; nothing if it must be refused. Shrinks a
// claim that would need too much.
Extent settle(Claim& claim, int32_t layout, int32_t most_bytes) {
  Extent extent;
  if (claim.format < SELVAGE_INDEX8 || claim.format > SELVAGE_RGBA8888) return extent;
  extent.pixel_bytes = pixel_bytes(claim.format);
  if (claim.width < 1 || claim.height < 1) return extent;
  const auto shape = [&] { return shape_of(claim, layout); };
  const auto span = [&] {
    return (shape().rows - 1) * magnitude(claim.pitch) + static_cast<Wide>(shape().row_bytes);
  };
  if (magnitude(claim.pitch) < static_cast<Wide>(shape().row_bytes)) return extent;
  if (span() > std::numeric_limits<ptrdiff_t>::max()) return extent;
  const int32_t side = side_of(layout);
  claim.width = std::min(claim.width, most_bytes / (side * extent.pixel_bytes));
  if (span() > most_bytes) {
    const Wide room = std::max<Wide>(most_bytes - shape().row_bytes, 0);
    claim.height = static_cast<int32_t>(
        std::min<Wide>(claim.height, (1 + room / magnitude(claim.pitch)) * side));
  }
  extent.bytes = static_cast<int64_t>(span());
  if (claim.pitch < 0) {
    extent.first = static_cast<int64_t>((shape().rows - 1) * magnitude(claim.pitch));
  }
  return extent;
}

// A block of exactly this many bytes, filled with a pattern; of one byte where none are needed, so
// that it has an address.
Block block(int64_t size_bytes, uint32_t state) {
  Block memory(static_cast<size_t>(std::max<int64_t>(size_bytes, 1)));
  for (uint8_t& byte : memory) byte = static_cast<uint8_t>((state = state * 1664525u + 1u) >> 24);
  return memory;
}

}  // namespace

Call::Call(Bytes bytes)
    : hostile(bytes.take<uint32_t>()),
      target_claim(bytes.take<Claim>()),
      texture_claim(bytes.take<Claim>()),
      layout(bytes.take<int32_t>()),
      clip(bytes.take<selvage_rect>()),
      options(bytes.take<selvage_options>()),
      shared_offset(bytes.take<uint16_t>()),
      target_extent(settle(target_claim, SELVAGE_LAYOUT_ROWS, most_image_bytes(options))),
      texture_extent(settle(texture_claim, layout, most_image_bytes(options))) {
  vertices.reserve(std::max<size_t>(bytes.left() / sizeof(selvage_vertex), 1));  // exact
  while (bytes.left() >= sizeof(selvage_vertex)) {
    vertices.push_back(bytes.take<selvage_vertex>());
  }
  place_sums();
  place();
}

// Where the texture may have sums, they are behind its texels, and as large as selvage says.
void Call::place_sums() {
  const Claim& s = texture_claim;
  if (!has(kSums) || texture_extent.bytes == 0 || s.pitch < 0) return;
  alignas(SELVAGE_PREPARED_ALIGNMENT) static const char texel[SELVAGE_PREPARED_ALIGNMENT] = {};
  const selvage_texture texture{texel,    s.width, s.height, static_cast<ptrdiff_t>(s.pitch),
                                s.format, layout,  nullptr};
  const size_t with = selvage_prepare_bytes(&texture, layout, 1);
  if (with == SIZE_MAX) return;
  const size_t without = selvage_prepare_bytes(&texture, layout, 0);
  constexpr int32_t kMostBytes = 1 << 22;
  const Wide offset = shape_of(s, layout).rows * magnitude(s.pitch);
  if (offset + static_cast<Wide>(with - without) > kMostBytes) return;
  sums_offset = static_cast<int64_t>(offset);
  texture_extent.bytes = sums_offset + static_cast<int64_t>(with - without);
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
  selvage_texture texture = {
      has(kNoTexels) ? nullptr : texture_block().data() + texture_start + texture_extent.first,
      s.width,
      s.height,
      static_cast<ptrdiff_t>(s.pitch),
      s.format,
      layout,
      nullptr};
  if (has(kPrepared)) texture.prepared = &layout;
  if (sums_offset > 0 && !has(kNoTexels)) {
    texture.prepared = static_cast<const char*>(texture.texels) + sums_offset;
  }
  const selvage_vertex* corners = vertices.data();
  if (vertices_in_target) corners = reinterpret_cast<const selvage_vertex*>(target_block.data());
  if (has(kNoVertices)) corners = nullptr;
  const size_t count = has(kNoVertices) && has(kHugeCount) ? SIZE_MAX : vertices.size();
  return selvage_draw(has(kNoTarget) ? nullptr : &target, clip_or_null(), corners, count,
                      has(kNoTexture) ? nullptr : &texture, has(kNoOptions) ? nullptr : &options);
}

bool same_texels(const Block& after, const Block& before, const Call& call) {
  const Claim& claim = call.texture_claim;
  const Shape shape = shape_of(claim, call.layout);
  const int64_t top_row = call.texture_start + call.texture_extent.first;
  for (int64_t row = 0; row < shape.rows; ++row) {
    const int64_t begin = top_row + row * claim.pitch;
    const int64_t end = begin + shape.row_bytes;
    if (!std::equal(after.begin() + begin, after.begin() + end, before.begin() + begin)) {
      return false;
    }
  }
  if (call.sums_offset == 0) return true;
  const int64_t begin = top_row + call.sums_offset;
  const int64_t end = call.texture_start + call.texture_extent.bytes;
  return std::equal(after.begin() + begin, after.begin() + end, before.begin() + begin);
}

bool same_elsewhere(Block after, const Block& before, const Call& call) {
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

}  // namespace selvage::fuzz
