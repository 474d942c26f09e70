// Law TOLERANCE: what is drawn within a tolerance is within the bound that is told, and the bound
// within the tolerance.
#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "spec/filter_texture.h"
#include "spec/law_list.h"
#include "spec/law_tools.h"
#include "spec/row_choice.h"
#include "spec/tolerance.h"
#include "spec/tolerant_subject.h"
#include "spec/wide_rows.h"

namespace selvage::spec {
namespace {

constexpr std::string_view kLaw = "TOLERANCE";

// Any tolerance may be asked for; beyond a few texels nothing new is drawn by it.
inline constexpr int32_t kMostToleranceBits = 22;

[[nodiscard]] Rational to_texels(const Rational& fx16) { return fx16 / SELVAGE_SUBTEXELS; }

// The rows of a case as they are drawn within a tolerance.
class TolerantCase {
 public:
  TolerantCase(const Subject& subject, const Case& c, const Tolerance& tolerance)
      : subject_(subject),
        case_(c),
        tolerance_fx16_(tolerance.fx16),
        drawn_(draw(tolerating(subject, tolerance), c)),
        asked_(subject, c, tolerance) {
    for (int32_t y = 0; y < c.target_height_px; ++y) {
      lines_.push_back(scan_line(c.vertices, y));
      columns_.push_back(lines_.back() ? columns_of(*lines_.back()) : Columns{0, 0});
    }
  }

  [[nodiscard]] Judgement judge() {
    const bool asks_rows = subject_.choose && subject_.claims.clip;
    Judgement judgement = judge_coverage();
    if (!drawn_.memory_fault.empty()) return blame_memory();
    selvage_choice all{SELVAGE_METHOD_NONE, 0, 0};
    for (int32_t y = 0; !judgement.violation && y < case_.target_height_px; ++y) {
      const std::optional<ScanLine>& line = lines_[static_cast<size_t>(y)];
      Rational allowed = to_texels(tolerance_fx16_);
      const selvage_choice choice = asks_rows ? asked_.row(y) : all;
      if (asks_rows) {
        const std::string fault =
            fault_of(choice, subject_.claims, case_, line, y, tolerance_fx16_);
        if (!asked_.fault().empty()) return blame(std::move(judgement), asked_.fault(), choice, y);
        if (!fault.empty()) return blame(std::move(judgement), fault, choice, y);
        all = together(all, choice);
      }
      if (columns_[static_cast<size_t>(y)].empty()) continue;
      if (asks_rows) {
        allowed = is_stepped(choice) ? std::min(to_texels(choice.bound),
                                                Rational(chord_bound(*line, choice.segment_px) +
                                                         to_texels(rounding_bound_fx16(*line))))
                                     : Rational(0);
      }
      allowed += accuracy_of(subject_);
      add(&judgement, judge_row(y, *line, allowed));
    }
    if (judgement.violation || !asks_rows) return judgement;
    const selvage_choice told = asked_.all();
    if (!asked_.fault().empty()) return blame(std::move(judgement), asked_.fault(), told, -1);
    if (same(told, all)) return judgement;
    return blame(std::move(judgement),
                 "of all rows the last method, the shortest segments, the greatest bound are told",
                 told, -1);
  }

 private:
  [[nodiscard]] bool is_due(int32_t x, int32_t y) const {
    const Columns& columns = columns_[static_cast<size_t>(y)];
    return is_visible(case_, {x, y}) && columns.first_px <= x && x < columns.end_px;
  }

  // Which pixels are drawn is exact whatever the tolerance.
  [[nodiscard]] Judgement judge_coverage() const {
    const auto wanted = [&](int32_t x, int32_t y) {
      const bool due = is_due(x, y);
      if (due == drawn_.at(x, y).has_value()) return must_be(drawn_.at(x, y));
      return must_be(due ? expected_pixel(case_, x, y) : MaybePixel());
    };
    return compare(kLaw, "which pixels are drawn does not depend on the tolerance", case_, drawn_,
                   without_doubt(subject_.claims.coverage_accuracy_fx16, case_, drawn_, wanted));
  }

  [[nodiscard]] Judgement judge_row(int32_t y, const ScanLine& line,
                                    const Rational& allowed) const {
    const TexelLaw law{kLaw,
                       "within " + to_texels(tolerance_fx16_).get_str() +
                           " texel, a texel lies within " + allowed.get_str() +
                           " texel of its exact (u, v)",
                       case_};
    Judgement judgement;
    for (int32_t x = 0; x < case_.target_width_px; ++x) {
      const std::optional<uint32_t>& pixel = drawn_.at(x, y);
      const std::optional<Sample> exact = pixel ? sample(line, x) : std::nullopt;
      if (exact && !law.judge({x, y}, reach_around(*exact, allowed), *pixel, &judgement)) break;
    }
    return judgement;
  }

  // MEM draws without a tolerance.
  [[nodiscard]] Judgement blame_memory() const {
    Judgement judgement{.judged_px = drawn_.pixels.size()};
    judgement.violation = violation_of_call(
        kLaw,
        "within " + to_texels(tolerance_fx16_).get_str() +
            " texel, too, nothing but pixels of the target is written, and they do not depend on "
            "what was there",
        case_, "an untouched surrounding", drawn_.memory_fault);
    return judgement;
  }

  [[nodiscard]] Judgement blame(Judgement judgement, const std::string& fault,
                                const selvage_choice& choice, int32_t y_px) const {
    judgement.violation = violation_of_call(
        kLaw,
        "row " + std::to_string(y_px) + ", within " + to_texels(tolerance_fx16_).get_str() +
            " texel: " + fault,
        case_, "a choice whose bound is derived and within the tolerance", text_of(choice));
    return judgement;
  }

  const Subject& subject_;
  const Case& case_;
  int32_t tolerance_fx16_;
  Picture drawn_;
  AskedChoice asked_;
  std::vector<std::optional<ScanLine>> lines_;  // of the rows
  std::vector<Columns> columns_;                // that they cover
};

// Powers of two in between, and what some row's own bound is, or just not.
[[nodiscard]] int32_t some_tolerance(const Case& c, Choices& choices) {
  constexpr std::array kUsual = {SELVAGE_SUBTEXELS / 256, SELVAGE_SUBTEXELS / 16,
                                 SELVAGE_SUBTEXELS / 4, int32_t{SELVAGE_SUBTEXELS}};
  const int32_t kind = choices.pick(0, 3);
  if (kind == 0) return kUsual[static_cast<size_t>(choices.pick(0, 4))];
  const int32_t any = (1 << choices.pick(0, kMostToleranceBits)) + choices.pick(0, 16);
  const auto line = scan_line(c.vertices, choices.pick(0, c.target_height_px));
  if (kind == 1 || !line || columns_of(*line).empty()) return any;
  const int32_t segment_px = 16 * choices.pick(0, 20);
  const Rational bound =
      chord_bound(*line, segment_px) * SELVAGE_SUBTEXELS + rounding_bound_fx16(*line);
  return bound < (1 << kMostToleranceBits) ? std::max(floor(bound) + choices.pick(-2, 3), 1) : any;
}

// Which may be none that it has: only who names errors is asked for it.
[[nodiscard]] selvage_kernel some_kernel(const Subject& subject, const Case& c) {
  if (!subject.claims.named_errors) return SELVAGE_KERNEL_FASTEST;
  constexpr uint32_t kOwnChoices = 0x9E3779B9;  // apart from those that make the case
  Choices choices(c.choice ^ kOwnChoices);
  return static_cast<selvage_kernel>(choices.pick(SELVAGE_KERNEL_FASTEST, SELVAGE_KERNEL_NEON + 1));
}

// What it is drawn by within any tolerance, and without.
[[nodiscard]] Judgement judge_filtered(const Subject& subject, const Case& c,
                                       const Tolerance& tolerance) {
  const TexelAt texel_at = filter_texture(c);
  const Picture without = draw(subject, c, texel_at);
  OtherDrawing other = drawing_of(subject, "without a tolerance it shows it");
  other.shows_texels = false;
  Judgement judgement = compare(kLaw, "of filters nearest alone makes use of a tolerance", c,
                                draw(tolerating(subject, tolerance), c, texel_at), other,
                                [&](int32_t x, int32_t y) { return must_be(without.at(x, y)); });
  if (judgement.violation || !subject.choose) return judgement;
  AskedChoice asked(subject, c, tolerance);
  const selvage_choice choice = asked.all();
  const std::string fault =
      asked.fault().empty() ? fault_of_filtered(choice, subject.claims, c) : asked.fault();
  if (fault.empty()) return judgement;
  judgement.violation =
      violation_of_call(kLaw, "asked what it filters by: " + fault, c,
                        "a method that mixes or copies texels, exactly", text_of(choice));
  return judgement;
}

}  // namespace

Judgement check_tolerance(const Subject& subject, const Case& any) {
  const Case c = with_nearest(any);
  Judgement judgement;
  if (!is_valid(c) || c.profile != SELVAGE_PROFILE_EXACT) return judgement;
  Choices choices(c.choice);
  for (const Case& shown : {c, within(subject.claims, made_wide(c, choices))}) {
    if (!is_valid(shown)) continue;
    const Tolerance tolerance{some_tolerance(shown, choices), some_kernel(subject, shown)};
    if (add(&judgement, TolerantCase(subject, shown, tolerance).judge())) return judgement;
  }
  if (any.filter != SELVAGE_FILTER_NEAREST && can_be_filtered(any)) {
    const Tolerance tolerance{some_tolerance(any, choices), SELVAGE_KERNEL_FASTEST};
    add(&judgement, judge_filtered(subject, any, tolerance));
  }
  return judgement;
}

}  // namespace selvage::spec
