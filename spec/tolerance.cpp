#include "spec/tolerance.h"

#include <algorithm>

#include "selvage.h"

namespace selvage::spec {
namespace {

[[nodiscard]] int32_t ceil(const Rational& number) { return -floor(-number); }

[[nodiscard]] Rational q_at(const ScanLine& line, int32_t px) {
  const Rational t = (px + Rational(1, 2) - line.left.x) / (line.right.x - line.left.x);
  return line.left.q + t * (line.right.q - line.left.q);
}

// q at the first and the last pixel, in order.
struct Depths {
  Rational least, greatest;
  explicit Depths(const ScanLine& line) {
    const Columns columns = columns_of(line);
    const Rational a = q_at(line, columns.first_px), b = q_at(line, columns.last_px());
    least = std::min(a, b);
    greatest = std::max(a, b);
  }
};

}  // namespace

Columns columns_of(const ScanLine& line) {
  const Rational half(1, 2);
  return {ceil(line.left.x - half), ceil(line.right.x - half)};
}

// For u = A / q with A and q linear in x, u' = (A' q - A q') / q^2, whose numerator is the same at
// every x, and u'' = -2 (A' q - A q') q' / q^3. A chord over N steps is off by N^2 / 8 max |u''|.
Rational chord_bound(const ScanLine& line, int32_t segment_px) {
  const Columns columns = columns_of(line);
  const int32_t row_steps = columns.last_px() - columns.first_px;
  const int32_t steps = segment_px == 0 ? row_steps : std::min(segment_px, row_steps);
  const Rational width = line.right.x - line.left.x;
  const Rational q_step = (line.right.q - line.left.q) / width;
  const Rational least = Depths(line).least;
  const auto of = [&](const Rational& left, const Rational& right) {
    const Rational slope = (right * line.left.q - left * line.right.q) / width;
    return Rational(abs(slope * q_step) * steps * steps / (4 * least * least * least));
  };
  return std::max(of(line.left.uq, line.right.uq), of(line.left.vq, line.right.vq));
}

Rational rounding_bound_fx16(const ScanLine& line) {
  const Depths q(line);
  const Columns columns = columns_of(line);
  const Rational reach = std::max(Rational(q.greatest / q.least), Rational(4096));
  const Rational below_a_unit = 2 * reach + 4 + 2 * (columns.last_px() - columns.first_px);
  return 4 + below_a_unit / SELVAGE_SUBTEXELS;
}

}  // namespace selvage::spec
