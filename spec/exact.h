// The exact model: what the `exact` profile means, over rational numbers, by brute force.
//
// It knows nothing of edges that step, spans or samplers: each pixel is asked on its own. Vertices
// are in their ranges (src/selvage.h); the outline must be y-monotone for scan_line and sample.
#pragma once

#include <gmpxx.h>

#include <cstdint>
#include <optional>
#include <span>

#include "selvage.h"

namespace selvage::spec {

using Rational = mpq_class;

// GMP's own conversion knows no 64 bits where a long has 32.
[[nodiscard]] inline Rational rational(int64_t n) {
  return Rational(static_cast<int32_t>(n >> 32)) * 0x1p32 + static_cast<uint32_t>(n);
}

[[nodiscard]] inline Rational to_px(int32_t fx8) { return Rational(fx8) / SELVAGE_SUBPIXELS; }

// Where an edge crosses a scan line: x in px; u q, v q and q, which are linear in y along the edge.
struct Crossing {
  Rational x, uq, vq, q;
};

// The two crossings of a scan line, left.x <= right.x.
struct ScanLine {
  Crossing left, right;
};

// The exact coordinates at the centre of a covered pixel, texels.
struct Sample {
  Rational u, v;
};

struct Texel {
  int32_t s, t;
  friend bool operator==(const Texel&, const Texel&) = default;
};

// SELVAGE_OK, SELVAGE_ERROR_VERTEX_COUNT or SELVAGE_ERROR_NOT_MONOTONE.
[[nodiscard]] selvage_status validity(std::span<const selvage_vertex> vertices);

// The scan line through the centres of row y_px; empty if no edge crosses it.
[[nodiscard]] std::optional<ScanLine> scan_line(std::span<const selvage_vertex> vertices,
                                                int32_t y_px);

// Column x_px of a scan line; empty if its centre is not in [left, right).
[[nodiscard]] std::optional<Sample> sample(const ScanLine& line, int32_t x_px);
[[nodiscard]] std::optional<Sample> sample(std::span<const selvage_vertex> vertices, int32_t x_px,
                                           int32_t y_px);

// The greatest integer that is not above the number.
[[nodiscard]] int32_t floor(const Rational& number);

// The texel that holds the sample, addressed into a texture of width x height texels.
[[nodiscard]] Texel nearest_texel(const Sample& sample, int32_t width, int32_t height,
                                  selvage_address address);
[[nodiscard]] int32_t address_texel(int32_t texel, int32_t size, selvage_address address);

}  // namespace selvage::spec
