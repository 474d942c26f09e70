#include "spec/row_choice.h"

#include <algorithm>

#include "spec/law_tools.h"
#include "spec/texel_reach.h"
#include "spec/tolerance.h"

namespace selvage::spec {
namespace {

// Whether pixels are drawn: surely, or maybe, where all that would be are in doubt.
struct Drawn {
  bool surely = false, maybe = false;

  void add(const Drawn& more) {
    surely = surely || more.surely;
    maybe = maybe || more.maybe;
  }
};

[[nodiscard]] Drawn drawn_in_row(const Capabilities& claims, const Case& c,
                                 const std::optional<ScanLine>& line, int32_t y_px) {
  const Columns columns = line ? columns_of(*line) : Columns{0, 0};
  Drawn drawn;
  for (int32_t x = 0; x < c.target_width_px && !drawn.surely; ++x) {
    const bool is_covered = columns.first_px <= x && x < columns.end_px;
    const bool in_doubt = is_in_doubt(claims.coverage_accuracy_fx16, c, {x, y_px});
    drawn.add({.surely = is_covered && is_visible(c, {x, y_px}) && !in_doubt, .maybe = in_doubt});
  }
  return {drawn.surely, drawn.surely || drawn.maybe};
}

// A texel's centre lies on this pixel's, as far as the subject claims its texels to be exact.
[[nodiscard]] bool is_copied(const Capabilities& claims, const ScanLine& line, int32_t x_px,
                             int32_t y_px) {
  const std::optional<Sample> exact = sample(line, x_px);
  const Rational half(1, 2), accuracy = accuracy_of(claims);
  const auto is_whole = [&](const Rational& number) {
    return abs(number - floor(number + half)) <= accuracy;
  };
  return exact && is_whole(exact->u - x_px - half) && is_whole(exact->v - y_px - half);
}

[[nodiscard]] std::string fault_of_exact(const selvage_choice& choice, const Capabilities& claims,
                                         const ScanLine& line, int32_t y_px) {
  const Columns columns = columns_of(line);
  const auto copies = [&](int32_t x_px) {
    return columns.empty() || is_copied(claims, line, x_px, y_px);
  };
  if (choice.bound != 0) return "an exact method has a bound";
  switch (choice.method) {
    case SELVAGE_METHOD_COPY:
      return copies(columns.first_px) && copies(columns.last_px())
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

std::string fault_of(const selvage_choice& choice, const Capabilities& claims, const Case& c,
                     const std::optional<ScanLine>& line, int32_t y_px, int32_t tolerance_fx16) {
  const Drawn drawn = drawn_in_row(claims, c, line, y_px);
  if (same(choice, {SELVAGE_METHOD_NONE, 0, 0})) {
    return drawn.surely ? "it draws pixels, and says that it draws none" : "";
  }
  if (!drawn.maybe) return "it draws no pixel there";
  if (choice.method <= SELVAGE_METHOD_NONE || choice.method > SELVAGE_METHOD_HISTORIC) {
    return "no method is told";
  }
  if (choice.bound < 0 || choice.bound > tolerance_fx16) return "the bound exceeds the tolerance";
  if ((choice.segment_px != 0) != (choice.method == SELVAGE_METHOD_SUBDIVIDED)) {
    return "segments without subdivision, or it without them";
  }
  if (!is_stepped(choice)) return line ? fault_of_exact(choice, claims, *line, y_px) : "";
  if (choice.segment_px % 16 != 0) return "segments are no multiple of 16 px";
  if (!line || columns_of(*line).empty()) return "";  // what is in doubt has no bound
  const Rational bound_texel = Rational(choice.bound) / SELVAGE_SUBTEXELS;
  return bound_texel >= chord_bound(*line, choice.segment_px)
             ? ""
             : "the bound is less than the derived one";
}

std::string fault_of_filtered(const selvage_choice& choice, const Capabilities& claims,
                              const Case& c) {
  Drawn drawn;
  for (int32_t y = 0; y < c.target_height_px && !drawn.surely; ++y) {
    drawn.add(drawn_in_row(claims, c, scan_line(c.vertices, y), y));
  }
  const bool is_one =
      choice.method == SELVAGE_METHOD_COPY || choice.method == SELVAGE_METHOD_FILTER;
  const bool is_none = choice.method == SELVAGE_METHOD_NONE;
  if (choice.bound != 0 || choice.segment_px != 0) return "a filter has a bound or segments";
  if (!is_one && !is_none) return "it mixes texels, and says that it does not";
  if (is_none) return drawn.surely ? "it draws pixels, and says that it draws none" : "";
  return drawn.maybe ? "" : "it draws no pixel";
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
