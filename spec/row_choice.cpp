#include "spec/row_choice.h"

#include <algorithm>

#include "spec/tolerance.h"

namespace selvage::spec {
namespace {

// The columns of a row that are drawn.
[[nodiscard]] Columns drawn_columns(const Case& c, const ScanLine& line, int32_t y_px) {
  Columns columns = columns_of(line);
  columns = {std::max(columns.first_px, 0), std::min(columns.end_px, c.target_width_px)};
  if (!c.has_clip) return columns;
  if (y_px < c.clip.top || c.clip.bottom <= y_px) return {0, 0};
  return {std::max(columns.first_px, c.clip.left), std::min(columns.end_px, c.clip.right)};
}

// A texel's centre lies on this pixel's.
[[nodiscard]] bool is_copied(const ScanLine& line, int32_t x_px, int32_t y_px) {
  const std::optional<Sample> exact = sample(line, x_px);
  const Rational half(1, 2);
  const auto is_whole = [](const Rational& number) { return number.get_den() == 1; };
  return exact && is_whole(exact->u - x_px - half) && is_whole(exact->v - y_px - half);
}

[[nodiscard]] std::string fault_of_exact(const selvage_choice& choice, const ScanLine& line,
                                         const Columns& columns, int32_t y_px) {
  if (choice.bound != 0) return "an exact method has a bound";
  switch (choice.method) {
    case SELVAGE_METHOD_NONE:
      return "it draws pixels, and says that it draws none";
    case SELVAGE_METHOD_COPY:
      return is_copied(line, columns.first_px, y_px) && is_copied(line, columns.last_px(), y_px)
                 ? ""
                 : "texel centres are not on pixel centres, and it says that it copies";
    case SELVAGE_METHOD_EXACT_AFFINE:
      return line.left.q == line.right.q ? "" : "q differ, and it says that they do not";
    case SELVAGE_METHOD_FILTER:
      return "it says that it filters, and the filter is nearest";
    case SELVAGE_METHOD_HISTORIC:
      return "it says that it draws by another profile";
    default:
      return "";
  }
}

}  // namespace

bool is_stepped(const selvage_choice& choice) {
  return choice.method == SELVAGE_METHOD_SUBDIVIDED ||
         choice.method == SELVAGE_METHOD_AFFINE_FOR_PERSPECTIVE;
}

std::string fault_of(const selvage_choice& choice, const Case& c,
                     const std::optional<ScanLine>& line, int32_t y_px, int32_t tolerance_fx16) {
  const Columns columns = line ? drawn_columns(c, *line, y_px) : Columns{0, 0};
  if (columns.empty()) {
    return same(choice, {SELVAGE_METHOD_NONE, 0, 0}) ? "" : "it draws no pixel there";
  }
  if (choice.method < SELVAGE_METHOD_NONE || choice.method > SELVAGE_METHOD_HISTORIC) {
    return "no method is told";
  }
  if (choice.bound < 0 || choice.bound > tolerance_fx16) return "the bound exceeds the tolerance";
  if ((choice.segment_px != 0) != (choice.method == SELVAGE_METHOD_SUBDIVIDED)) {
    return "segments without subdivision, or it without them";
  }
  if (!is_stepped(choice)) return fault_of_exact(choice, *line, columns, y_px);
  if (choice.segment_px % 16 != 0) return "segments are no multiple of 16 px";
  const Rational bound_texel = Rational(choice.bound) / SELVAGE_SUBTEXELS;
  return bound_texel >= chord_bound(*line, choice.segment_px)
             ? ""
             : "the bound is less than the derived one";
}

std::string fault_of_filtered(const selvage_choice& choice, bool draws) {
  const bool is_one =
      choice.method == SELVAGE_METHOD_COPY || choice.method == SELVAGE_METHOD_FILTER;
  if (choice.bound != 0 || choice.segment_px != 0) return "a filter has a bound or segments";
  if (draws && !is_one) return "it mixes texels, and says that it does not";
  return draws || choice.method == SELVAGE_METHOD_NONE ? "" : "it draws no pixel";
}

selvage_choice together(const selvage_choice& some, const selvage_choice& row) {
  const bool shorter = row.segment_px != 0 && row.segment_px < some.segment_px;
  return {std::max(some.method, row.method),
          some.segment_px == 0 || shorter ? row.segment_px : some.segment_px,
          std::max(some.bound, row.bound)};
}

bool same(const selvage_choice& a, const selvage_choice& b) {
  return a.method == b.method && a.segment_px == b.segment_px && a.bound == b.bound;
}

std::string text_of(const selvage_choice& choice) {
  return "method " + std::to_string(choice.method) + ", segments of " +
         std::to_string(choice.segment_px) + " px, bound " + std::to_string(choice.bound) +
         "/65536 texel";
}

}  // namespace selvage::spec
