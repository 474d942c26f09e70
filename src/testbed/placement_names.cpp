// What a placement calls the places in its memory.
#include <algorithm>

#include "testbed/extent.h"
#include "testbed/placement.h"

namespace selvage::testbed {
namespace {

[[nodiscard]] std::string number_of_bytes(uintptr_t count) {
  return std::to_string(count) + (count == 1 ? " byte" : " bytes");
}

struct Grid {
  ptrdiff_t pitch;
  int32_t width, height;
  selvage_format format;
};

// Which pixel an address is, or would be. Without padding the pixel after the end of a row is the
// first of the next; which of them was meant there is no telling.
[[nodiscard]] std::string pixel_at(intptr_t offset, const Grid& grid) {
  const auto bytes = static_cast<ptrdiff_t>(bytes_per_pixel(grid.format));
  const ptrdiff_t stride = grid.pitch < 0 ? -grid.pitch : grid.pitch;
  const ptrdiff_t down = offset >= 0 ? offset / stride : -((stride - 1 - offset) / stride);
  const ptrdiff_t column = (offset - down * stride) / bytes;
  const auto text = [&](ptrdiff_t x, ptrdiff_t y) {
    return "(" + std::to_string(x) + ", " + std::to_string(grid.pitch < 0 ? -y : y) + ")";
  };
  const ptrdiff_t first = grid.pitch < 0 ? 1 - ptrdiff_t{grid.height} : 0;
  const bool is_tight = stride == grid.width * bytes;
  std::string told = text(column, down);
  if (is_tight && down == first + grid.height) told += " or " + text(column + grid.width, down - 1);
  if (is_tight && down == first - 1) told += " or " + text(column - grid.width, down + 1);
  return told;
}

[[nodiscard]] std::string relation(uintptr_t address, const Range& range, const std::string& name) {
  if (range.is_empty()) return "through the " + name + ", which is to be refused";
  if (address == range.end) return "just after the end of the " + name;
  if (address > range.end) {
    return number_of_bytes(address - range.end) + " after the end of the " + name;
  }
  if (address < range.begin) {
    return number_of_bytes(range.begin - address) + " before the start of the " + name;
  }
  return "in the " + name;
}

[[nodiscard]] uintptr_t distance(uintptr_t address, const Range& range) {
  if (address < range.begin) return range.begin - address;
  return address < range.end ? 0 : address - range.end + 1;
}

// The least that holds all of them.
[[nodiscard]] Range hull(const std::vector<Placed>& all) {
  Range range;
  for (const Placed& placed : all) {
    if (placed.from.is_empty()) continue;
    if (range.is_empty()) range = placed.range();
    range = {std::min(range.begin, placed.range().begin), std::max(range.end, placed.range().end)};
  }
  return range;
}

}  // namespace

std::string Placement::place_of(uintptr_t address) const {
  if (arenas_.target.guarded().holds(address)) {
    const std::string where = relation(address, target_.range(), "target");
    if (target_.from.is_empty()) return where;
    const auto offset = static_cast<intptr_t>(address - target_.moved(call_.target->pixels));
    const selvage_image& target = *call_.target;
    const Grid grid{target.pitch, target.width, target.height, target.format};
    return where + ", where pixel " + pixel_at(offset, grid) +
           (target_.range().holds(address) ? " is" : " would be");
  }
  if (arenas_.vertices.guarded().holds(address)) {
    return relation(address, hull(vertices_), "vertices");
  }
  if (arenas_.polygons.guarded().holds(address)) return "in the list of polygons, or beside it";
  if (arenas_.structures.guarded().holds(address)) {
    return "in the structures that hold its arguments";
  }
  if (arenas_.results.guarded().holds(address)) return "beside the structure for its answer";
  return place_in_memory(address);
}

// Where it prepares a texture, its scratch memory, or a texture.
std::string Placement::place_in_memory(uintptr_t address) const {
  const auto begin = reinterpret_cast<uintptr_t>(call_.memory);
  if (arenas_.scratch.guarded().holds(address)) {
    if (call_.function != Function::kDrawMany) return "the scratch memory of another call";
    return relation(address, {begin, begin + call_.bytes}, "scratch memory");
  }
  for (const Arena& arena : arenas_.prepared) {
    if (!arena.guarded().holds(address) || call_.function != Function::kPrepare) continue;
    if (arena.range().begin > begin || begin > arena.range().end) continue;
    return relation(address, {begin, begin + call_.bytes}, "memory to prepare in");
  }
  return place_in_textures(address);
}

std::string Placement::place_in_textures(uintptr_t address) const {
  const auto is_in = [&](const Arena& arena) { return arena.guarded().holds(address); };
  const bool is_prepared = std::ranges::any_of(arenas_.prepared, is_in);
  if (!is_prepared && !is_in(arenas_.texture) && !is_in(arenas_.other_textures)) return {};
  const PlacedTexture* nearest = nullptr;
  for (const PlacedTexture& texture : textures_) {
    if (texture.is_copied == is_prepared) continue;
    if (nearest == nullptr ||
        distance(address, texture.placed.range()) < distance(address, nearest->placed.range())) {
      nearest = &texture;
    }
  }
  if (nearest == nullptr) return "a texture of another call";
  const auto& [texture, placed, is_copied] = *nearest;
  const std::string name = is_copied ? "texture" : "prepared texture";
  const std::string where = relation(address, placed.range(), name);
  if (placed.from.is_empty() || texture->layout != SELVAGE_LAYOUT_ROWS) return where;
  const auto offset = static_cast<intptr_t>(address - placed.moved(texture->texels));
  if (!is_copied && (texture->pitch == 0 || offset < 0)) return where;
  const Grid grid{texture->pitch, texture->width, texture->height, texture->format};
  return where + ", at texel " + pixel_at(offset, grid);
}

}  // namespace selvage::testbed
