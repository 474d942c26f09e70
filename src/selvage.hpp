// A thin C++ face over selvage.h: views instead of pointers, defaults instead of NULL.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "selvage.h"

namespace selvage {

using Vertex = selvage_vertex;
using Image = selvage_image;
using Texture = selvage_texture;
using Polygon = selvage_polygon;
using Rect = selvage_rect;
using Options = selvage_options;
using Choice = selvage_choice;

// What a status says, for people.
[[nodiscard]] inline std::string_view text_of(selvage_status status) {
  return selvage_status_text(status);
}

// As selvage_snap: the nearest vertex of the grid, whose w is 1 in an affine map.
struct Place {
  double x_px, y_px, u_texel, v_texel;
  double w = 1;
};
[[nodiscard]] inline selvage_status snap(const Place& place, Vertex& vertex, double w_near = 1) {
  return selvage_snap(place.x_px, place.y_px, place.u_texel, place.v_texel, place.w, w_near,
                      &vertex);
}

// As selvage_fit: the whole texture onto three corners or four, anticlockwise on the screen.
[[nodiscard]] inline selvage_status fit(std::span<const Vertex> corners, const Texture& texture,
                                        std::span<Vertex, 4> fitted, size_t doubled = 0) {
  return selvage_fit(corners.data(), corners.size(), doubled, texture.width, texture.height,
                     fitted.data());
}

// As selvage_draw; without a clip rectangle the whole target is drawn on.
[[nodiscard]] inline selvage_status draw(const Image& target, std::span<const Vertex> polygon,
                                         const Texture& texture, const Options& options = {},
                                         const std::optional<Rect>& clip = std::nullopt) {
  return selvage_draw(&target, clip ? &*clip : nullptr, polygon.data(), polygon.size(), &texture,
                      &options);
}

// As selvage_choose: what draw would draw the same by.
[[nodiscard]] inline selvage_status choose(const Image& target, std::span<const Vertex> polygon,
                                           const Texture& texture, const Options& options,
                                           Choice& choice,
                                           const std::optional<Rect>& clip = std::nullopt) {
  return selvage_choose(&target, clip ? &*clip : nullptr, polygon.data(), polygon.size(), &texture,
                        &options, &choice);
}

// As selvage_prepare: rows at a better pitch, or tiles; with sums for the area filter or without.
[[nodiscard]] inline selvage_status prepare(const Texture& source, selvage_layout layout,
                                            bool with_sums, std::span<std::byte> memory,
                                            Texture& prepared) {
  return selvage_prepare(&source, layout, with_sums ? 1 : 0, memory.data(), memory.size(),
                         &prepared);
}

// As selvage_prepare_bytes.
[[nodiscard]] inline size_t prepare_bytes(const Texture& source, selvage_layout layout,
                                          bool with_sums) {
  return selvage_prepare_bytes(&source, layout, with_sums ? 1 : 0);
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

// As selvage_draw_many_bytes: the scratch memory that draw_many needs.
[[nodiscard]] inline size_t draw_many_bytes(size_t polygon_count) {
  return selvage_draw_many_bytes(polygon_count);
}

// Whether this build has the kernel and this machine can run it.
[[nodiscard]] inline bool has_kernel(selvage_kernel kernel) {
  return selvage_has_kernel(kernel) != 0;
}

// As selvage_fastest_kernel: the kernel for Options, found by a clock in some milliseconds.
[[nodiscard]] inline selvage_status fastest_kernel(selvage_filter filter, selvage_format format,
                                                   selvage_work work, std::span<std::byte> scratch,
                                                   selvage_kernel& fastest) {
  return selvage_fastest_kernel(filter, format, work, scratch.data(), scratch.size(), &fastest);
}

}  // namespace selvage
