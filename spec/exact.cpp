#include "spec/exact.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace selvage::spec {
namespace {

[[nodiscard]] Rational centre(int32_t index_px) { return index_px + Rational(1, 2); }

[[nodiscard]] Rational mix(const Rational& a, const Rational& b, const Rational& t) {
  return a + t * (b - a);
}

[[nodiscard]] Crossing mix(const Crossing& a, const Crossing& b, const Rational& t) {
  return {mix(a.x, b.x, t), mix(a.uq, b.uq, t), mix(a.vq, b.vq, t), mix(a.q, b.q, t)};
}

[[nodiscard]] Crossing at_vertex(const selvage_vertex& p) {
  const Rational q(p.q);
  return {to_px(p.x), Rational(p.u) / SELVAGE_SUBTEXELS * q, Rational(p.v) / SELVAGE_SUBTEXELS * q,
          q};
}

// Calls visit(top, bottom) for each edge that the line at height y crosses: y_top <= y < y_bottom.
template <class Visit>
void for_each_crossed(std::span<const selvage_vertex> vertices, const Rational& y, Visit visit) {
  for (size_t i = 0; i < vertices.size(); ++i) {
    const selvage_vertex& a = vertices[i];
    const selvage_vertex& b = vertices[(i + 1) % vertices.size()];
    const auto [top, bottom] = a.y <= b.y ? std::pair(a, b) : std::pair(b, a);
    if (to_px(top.y) <= y && y < to_px(bottom.y)) visit(top, bottom);
  }
}

}  // namespace

selvage_status validity(std::span<const selvage_vertex> vertices) {
  if (vertices.size() < 3) return SELVAGE_ERROR_VERTEX_COUNT;
  // How many edges a line crosses changes at vertices only, so the lines through them tell all.
  for (const selvage_vertex& vertex : vertices) {
    int crossed = 0;
    for_each_crossed(vertices, to_px(vertex.y), [&](const auto&, const auto&) { ++crossed; });
    if (crossed > 2) return SELVAGE_ERROR_NOT_MONOTONE;
  }
  return SELVAGE_OK;
}

std::optional<ScanLine> scan_line(std::span<const selvage_vertex> vertices, int32_t y_px) {
  const Rational y = centre(y_px);
  std::vector<Crossing> crossings;
  for_each_crossed(vertices, y, [&](const selvage_vertex& top, const selvage_vertex& bottom) {
    const Rational t = (y - to_px(top.y)) / (to_px(bottom.y) - to_px(top.y));
    crossings.push_back(mix(at_vertex(top), at_vertex(bottom), t));
  });
  if (crossings.size() != 2) return std::nullopt;
  if (crossings[1].x < crossings[0].x) std::swap(crossings[0], crossings[1]);
  return ScanLine{crossings[0], crossings[1]};
}

std::optional<Sample> sample(const ScanLine& line, int32_t x_px) {
  const Rational x = centre(x_px);
  if (x < line.left.x || line.right.x <= x) return std::nullopt;
  const Crossing point =
      mix(line.left, line.right, (x - line.left.x) / (line.right.x - line.left.x));
  return Sample{point.uq / point.q, point.vq / point.q};
}

std::optional<Sample> sample(std::span<const selvage_vertex> vertices, int32_t x_px, int32_t y_px) {
  const std::optional<ScanLine> line = scan_line(vertices, y_px);
  return line ? sample(*line, x_px) : std::nullopt;
}

int32_t floor(const Rational& number) {
  mpz_class quotient;
  mpz_fdiv_q(quotient.get_mpz_t(), number.get_num_mpz_t(), number.get_den_mpz_t());
  return static_cast<int32_t>(quotient.get_si());
}

int32_t address_texel(int32_t texel, int32_t size, selvage_address address) {
  if (address == SELVAGE_ADDRESS_CLAMP) return std::clamp(texel, 0, size - 1);
  const int64_t periods = int64_t{1} + 32768;  // enough to make any texel positive
  return static_cast<int32_t>((texel + periods * size) % size);
}

Texel nearest_texel(const Sample& sample, int32_t width, int32_t height, selvage_address address) {
  return {address_texel(floor(sample.u), width, address),
          address_texel(floor(sample.v), height, address)};
}

}  // namespace selvage::spec
