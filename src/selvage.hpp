// A thin C++ face over selvage.h: views instead of pointers, defaults instead of NULL.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "selvage.h"

namespace selvage {

using Vertex = selvage_vertex;
using Image = selvage_image;
using Texture = selvage_texture;
using Polygon = selvage_polygon;
using Rect = selvage_rect;
using Options = selvage_options;

// As selvage_draw; without a clip rectangle the whole target is drawn on.
[[nodiscard]] inline selvage_status draw(const Image& target, std::span<const Vertex> polygon,
                                         const Texture& texture, const Options& options = {},
                                         const std::optional<Rect>& clip = std::nullopt) {
  return selvage_draw(&target, clip ? &*clip : nullptr, polygon.data(), polygon.size(), &texture,
                      &options);
}

// As selvage_draw_many, over all the threads of the machine unless told otherwise. `failed`, if
// given, gets the index of the polygon that is refused.
[[nodiscard]] inline selvage_status draw_many(const Image& target,
                                              std::span<const Polygon> polygons,
                                              std::span<std::byte> scratch,
                                              const Options& options = {},
                                              const std::optional<Rect>& clip = std::nullopt,
                                              int32_t threads = 0, size_t* failed = nullptr) {
  return selvage_draw_many(&target, clip ? &*clip : nullptr, polygons.data(), polygons.size(),
                           &options, threads, scratch.data(), scratch.size(), failed);
}

}  // namespace selvage
