// A thin C++ face over selvage.h: views instead of pointers, defaults instead of NULL.
#pragma once

#include <optional>
#include <span>

#include "selvage.h"

namespace selvage {

using Vertex = selvage_vertex;
using Image = selvage_image;
using Texture = selvage_texture;
using Rect = selvage_rect;
using Options = selvage_options;

// As selvage_draw; without a clip rectangle the whole target is drawn on.
[[nodiscard]] inline selvage_status draw(const Image& target, std::span<const Vertex> polygon,
                                         const Texture& texture, const Options& options = {},
                                         const std::optional<Rect>& clip = std::nullopt) {
  return selvage_draw(&target, clip ? &*clip : nullptr, polygon.data(), polygon.size(), &texture,
                      &options);
}

}  // namespace selvage
