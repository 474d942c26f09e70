#include "testbed/placement.h"

#include <algorithm>
#include <cstring>

namespace selvage::testbed {
namespace {

inline constexpr size_t kGreatestUnit = 4;

[[nodiscard]] size_t bytes_per_pixel(selvage_format format) {
  return format == SELVAGE_INDEX8 ? 1 : format == SELVAGE_RGB565 ? 2 : kGreatestUnit;
}

[[nodiscard]] uintptr_t address_of(const void* pointer) {
  return reinterpret_cast<uintptr_t>(pointer);
}

// The rows of an image without what is beyond the last one's end; empty, at `pixels`, where it has
// none, or more than `most_bytes`.
[[nodiscard]] Range rows_of(const void* pixels, int32_t width, int32_t height, ptrdiff_t pitch,
                            selvage_format format, size_t most_bytes) {
  const Range none{address_of(pixels), address_of(pixels)};
  const bool is_known = SELVAGE_INDEX8 <= format && format <= SELVAGE_RGBA8888;
  if (pixels == nullptr || !is_known || width < 1 || height < 1 || pitch == PTRDIFF_MIN) {
    return none;
  }
  const size_t row = static_cast<size_t>(width) * bytes_per_pixel(format);
  const auto stride = static_cast<size_t>(pitch < 0 ? -pitch : pitch);
  const size_t steps = static_cast<size_t>(height) - 1;
  if (row > stride || row > most_bytes || stride % bytes_per_pixel(format) != 0) return none;
  if (steps > 0 && stride > (most_bytes - row) / steps) return none;
  const uintptr_t begin = none.begin - (pitch < 0 ? steps * stride : 0);
  return {begin, begin + steps * stride + row};
}

[[nodiscard]] Range range_of(const selvage_image* image, size_t most_bytes) {
  if (image == nullptr) return {};
  return rows_of(image->pixels, image->width, image->height, image->pitch, image->format,
                 most_bytes);
}

[[nodiscard]] Range range_of(const selvage_texture* texture, size_t most_bytes) {
  if (texture == nullptr) return {};
  return rows_of(texture->texels, texture->width, texture->height, texture->pitch, texture->format,
                 most_bytes);
}

[[nodiscard]] Range range_of(const selvage_vertex* vertices, size_t count, size_t most_bytes) {
  const uintptr_t begin = address_of(vertices);
  if (vertices == nullptr || count > most_bytes / sizeof *vertices) return {begin, begin};
  return {begin, begin + count * sizeof *vertices};
}

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

[[nodiscard]] std::string number_of_bytes(uintptr_t count) {
  return std::to_string(count) + (count == 1 ? " byte" : " bytes");
}

// Which pixel an address is, or would be.
[[nodiscard]] std::string pixel_at(intptr_t offset, ptrdiff_t pitch, selvage_format format) {
  const ptrdiff_t stride = pitch < 0 ? -pitch : pitch;
  const ptrdiff_t down = offset >= 0 ? offset / stride : -((stride - 1 - offset) / stride);
  const ptrdiff_t column =
      (offset - down * stride) / static_cast<ptrdiff_t>(bytes_per_pixel(format));
  return "(" + std::to_string(column) + ", " + std::to_string(pitch < 0 ? -down : down) + ")";
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

}  // namespace

Placement::Placement(const Arenas& arenas, const Call& call, bool at_end)
    : arenas_(arenas), call_(call) {
  target_.from = range_of(call.target, arenas.target.range().bytes());
  texture_.from = range_of(call.texture, arenas.texture.range().bytes());
  vertices_.from = range_of(call.vertices, call.count, arenas.vertices.range().bytes());
  // What shares memory with the target, or lies beside it, has to be where it is in relation to it.
  Placed* const others[] = {&texture_, &vertices_};
  const auto is_shared = [&](const Placed& other) {
    return !other.from.is_empty() && !target_.from.is_empty() && other.from.touches(target_.from);
  };
  bool shared[2] = {};
  for (size_t i = 0; i < 2; ++i) {
    if (!is_shared(*others[i])) continue;
    shared[i] = true;
    target_.from = {std::min(target_.from.begin, others[i]->from.begin),
                    std::max(target_.from.end, others[i]->from.end)};
  }
  const auto place = [&](Placed& placed, const Arena& arena, size_t unit) {
    placed.at = at_end ? arena.at_end(placed.from.bytes(), placed.from.begin, unit)
                       : arena.at_begin(placed.from.begin, unit);
  };
  place(target_, arenas.target,
        call.target != nullptr ? bytes_per_pixel(call.target->format) : kGreatestUnit);
  place(texture_, arenas.texture,
        call.texture != nullptr ? bytes_per_pixel(call.texture->format) : kGreatestUnit);
  place(vertices_, arenas.vertices, alignof(selvage_vertex));
  for (size_t i = 0; i < 2; ++i) {
    if (shared[i]) others[i]->at = target_.at + (others[i]->from.begin - target_.from.begin);
  }
}

Call Placement::copy_in() const {
  for (const Placed& placed : {vertices_, texture_, target_}) {
    copy(placed.at, placed.from.begin, placed.from.bytes());
  }
  uintptr_t at = arenas_.structures.range().begin;
  selvage_image* target = put(call_.target, &at);
  selvage_texture* texture = put(call_.texture, &at);
  if (target != nullptr && target->pixels != nullptr) {
    target->pixels = reinterpret_cast<void*>(target_.moved(target->pixels));
  }
  if (texture != nullptr && texture->texels != nullptr) {
    texture->texels = reinterpret_cast<const void*>(texture_.moved(texture->texels));
  }
  const auto* vertices =
      call_.vertices == nullptr
          ? nullptr
          : reinterpret_cast<const selvage_vertex*>(vertices_.moved(call_.vertices));
  return {target, put(call_.clip, &at), vertices, call_.count, texture, put(call_.options, &at)};
}

void Placement::copy_out() const { copy(target_.from.begin, target_.at, target_.from.bytes()); }

std::string Placement::place_of(uintptr_t address) const {
  if (arenas_.target.guarded().holds(address)) {
    const std::string where = relation(address, target_.range(), "target");
    if (target_.from.is_empty()) return where;
    const auto offset = static_cast<intptr_t>(address - target_.moved(call_.target->pixels));
    return where + ", where pixel " + pixel_at(offset, call_.target->pitch, call_.target->format) +
           (target_.range().holds(address) ? " is" : " would be");
  }
  if (arenas_.texture.guarded().holds(address)) {
    const std::string where = relation(address, texture_.range(), "texture");
    if (texture_.from.is_empty()) return where;
    const auto offset = static_cast<intptr_t>(address - texture_.moved(call_.texture->texels));
    return where + ", at texel " + pixel_at(offset, call_.texture->pitch, call_.texture->format);
  }
  if (arenas_.vertices.guarded().holds(address)) {
    return relation(address, vertices_.range(), "vertices");
  }
  if (arenas_.structures.guarded().holds(address)) {
    return "in the structures that hold its arguments";
  }
  return {};
}

}  // namespace selvage::testbed
