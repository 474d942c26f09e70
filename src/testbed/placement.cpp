#include "testbed/placement.h"

#include <algorithm>
#include <cstring>

#include "spec/subject.h"
#include "testbed/extent.h"

namespace selvage::testbed {
namespace {

inline constexpr size_t kMostTextures = 32;  // whose structures have room beside the others

void copy(uintptr_t to, uintptr_t from, size_t bytes) {
  if (bytes > 0) std::memcpy(reinterpret_cast<void*>(to), reinterpret_cast<void*>(from), bytes);
}

// Puts a structure into the page and moves on; NULL stays NULL.
template <class Structure>
[[nodiscard]] Structure* put(const Structure* from, uintptr_t* at) {
  if (from == nullptr) return nullptr;
  auto* to = reinterpret_cast<Structure*>(*at);
  std::memcpy(to, from, sizeof *from);
  *at += (sizeof *from + 15) / 16 * 16;
  return to;
}

[[nodiscard]] Placed packed(Packer* packer, const Range& from, size_t unit) {
  if (const auto at = packer->place(from.bytes(), from.begin, unit)) return {from, *at};
  return {{from.begin, from.begin}, packer->place(0, 0, 1).value_or(0)};
}

// The whole of what was prepared, and where it still is.
[[nodiscard]] const Placed* prepared_with(const selvage_texture& texture,
                                          const std::vector<Placed>& prepared) {
  const auto address = reinterpret_cast<uintptr_t>(texture.texels);
  const auto found = std::ranges::find_if(
      prepared, [address](const Placed& block) { return block.from.holds(address); });
  return found != prepared.end() ? &*found : nullptr;
}

// A structure that the subject fills in, right before the guard.
template <class Structure>
[[nodiscard]] Structure* at_end_of(const Arena& arena) {
  return reinterpret_cast<Structure*>(arena.range().end - sizeof(Structure));
}

}  // namespace

Placement::Placement(const Arenas& arenas, const Call& call, const std::vector<Placed>& prepared,
                     bool at_end)
    : arenas_(arenas), call_(call), at_end_(at_end) {
  if (call.polygons == nullptr) return;
  target_.from = range_of(call.target, arenas.target.range().bytes());
  place_textures(prepared);
  place_vertices();
  const bool fits = textures_.size() <= kMostTextures &&
                    call.count * sizeof(selvage_polygon) <= arenas.polygons.range().bytes();
  if (!fits) throw spec::NotClaimed{"more polygons in a call than can be handed on"};
  place_target();
}

void Placement::place_textures(const std::vector<Placed>& prepared) {
  Packer first(arenas_.texture.range(), at_end_), others(arenas_.other_textures.range(), at_end_);
  for (size_t i = 0; i < call_.count; ++i) {
    const selvage_texture* texture = call_.polygons[i].texture;
    if (texture == nullptr || placed_of(texture) != nullptr) continue;
    if (const Placed* block = prepared_with(*texture, prepared)) {
      textures_.push_back({texture, *block, false});
      continue;
    }
    Packer* packer = textures_.empty() ? &first : &others;
    const Range from = range_of(texture, packer->bytes_left());
    textures_.push_back({texture, packed(packer, from, unit_of(*texture)), true});
  }
}

void Placement::place_vertices() {
  Packer packer(arenas_.vertices.range(), at_end_);
  for (size_t i = 0; i < call_.count; ++i) {
    const selvage_polygon& polygon = call_.polygons[i];
    const Range from = range_of(polygon.vertices, polygon.count, packer.bytes_left());
    vertices_.push_back(packed(&packer, from, alignof(selvage_vertex)));
  }
}

// What shares memory with the target, or lies beside it, has to be where it is in relation to it.
void Placement::place_target() {
  std::vector<Placed*> shared;
  const auto take = [&](Placed* other) {
    if (other->from.is_empty() || target_.from.is_empty()) return;
    if (!other->from.touches(target_.from)) return;
    shared.push_back(other);
    target_.from = {std::min(target_.from.begin, other->from.begin),
                    std::max(target_.from.end, other->from.end)};
  };
  for (PlacedTexture& texture : textures_) {
    if (texture.is_copied) take(&texture.placed);
  }
  for (Placed& vertices : vertices_) take(&vertices);
  Packer packer(arenas_.target.range(), at_end_);
  const size_t unit = call_.target != nullptr ? bytes_per_pixel(call_.target->format) : 1;
  target_ = packed(&packer, target_.from, unit);
  for (Placed* other : shared) other->at = target_.at + (other->from.begin - target_.from.begin);
}

const Placement::PlacedTexture* Placement::placed_of(const selvage_texture* texture) const {
  const auto found = std::ranges::find(textures_, texture, &PlacedTexture::texture);
  return found != textures_.end() ? &*found : nullptr;
}

Call Placement::copy_in() const {
  for (const Placed& placed : vertices_) copy(placed.at, placed.from.begin, placed.from.bytes());
  for (const auto& [texture, placed, is_copied] : textures_) {
    if (is_copied) copy(placed.at, placed.from.begin, placed.from.bytes());
  }
  copy(target_.at, target_.from.begin, target_.from.bytes());
  uintptr_t at = arenas_.structures.range().begin;
  Call call = call_;
  selvage_image* target = put(call_.target, &at);
  if (target != nullptr && target->pixels != nullptr) {
    target->pixels = reinterpret_cast<void*>(target_.moved(target->pixels));
  }
  call.target = target;
  call.clip = put(call_.clip, &at);
  call.options = put(call_.options, &at);
  call.polygons = copy_polygons_in(&at);
  if (call_.choice != nullptr) {
    call.choice = at_end_of<selvage_choice>(arenas_.results);
    *call.choice = *call_.choice;
  }
  if (call_.failed != nullptr) {
    call.failed = at_end_of<size_t>(arenas_.results);
    *call.failed = *call_.failed;
  }
  if (call_.prepared != nullptr) {
    call.prepared = at_end_of<selvage_texture>(arenas_.results);
    *call.prepared = *call_.prepared;
  }
  return call;
}

selvage_polygon* Placement::copy_polygons_in(uintptr_t* at) const {
  if (call_.polygons == nullptr) return nullptr;
  std::vector<selvage_texture*> textures;
  for (const auto& [texture, placed, is_copied] : textures_) {
    textures.push_back(put(texture, at));
    selvage_texture& moved = *textures.back();
    const auto moved_by = placed.at - placed.from.begin;
    if (moved.texels != nullptr) {
      moved.texels = reinterpret_cast<const void*>(placed.moved(moved.texels));
    }
    if (moved.prepared != nullptr) {
      moved.prepared =
          reinterpret_cast<const void*>(reinterpret_cast<uintptr_t>(moved.prepared) + moved_by);
    }
  }
  Packer packer(arenas_.polygons.range(), at_end_);
  const size_t bytes = call_.count * sizeof(selvage_polygon);
  auto* polygons =
      reinterpret_cast<selvage_polygon*>(packer.place(bytes, 0, alignof(selvage_polygon)).value());
  for (size_t i = 0; i < call_.count; ++i) {
    const auto& [vertices, count, texture] = call_.polygons[i];
    const PlacedTexture* placed = placed_of(texture);
    polygons[i] = {
        vertices == nullptr ? nullptr
                            : reinterpret_cast<const selvage_vertex*>(vertices_[i].moved(vertices)),
        count,
        placed == nullptr ? nullptr : textures[static_cast<size_t>(placed - textures_.data())]};
  }
  return polygons;
}

void Placement::copy_out() const {
  copy(target_.from.begin, target_.at, target_.from.bytes());
  if (call_.choice != nullptr) *call_.choice = *at_end_of<selvage_choice>(arenas_.results);
  if (call_.failed != nullptr) *call_.failed = *at_end_of<size_t>(arenas_.results);
  if (call_.prepared != nullptr) *call_.prepared = *at_end_of<selvage_texture>(arenas_.results);
}

}  // namespace selvage::testbed
