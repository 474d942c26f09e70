// Which of the mapper's inner loops draw a polygon: asked of the mapper itself, behind its
// interface.
#pragma once

#include <span>
#include <string>

#include "selvage.h"

namespace selvage::cli {

// "scalar", "avx2", ...; "none" where no kernel is in it: rows that are copied.
// The arguments are such that selvage_choose takes them, and this is its choice for them.
[[nodiscard]] std::string drawn_kernel(std::span<const selvage_vertex> vertices,
                                       const selvage_texture& texture,
                                       const selvage_options& options, selvage_method method);

}  // namespace selvage::cli
