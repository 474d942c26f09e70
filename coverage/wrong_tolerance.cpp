// Wrong mappers: what they make of a tolerance, and what they tell of it.
#include <algorithm>
#include <cmath>

#include "coverage/catalogue.h"
#include "coverage/recipe.h"
#include "spec/tolerance.h"

namespace selvage::coverage {
namespace {

using spec::Rational;
using spec::Sample;
using spec::ScanLine;

constexpr std::string_view kToleranceLaw = "TOLERANCE";

// The map of a row at its centres, straight between its values segment_px apart.
class Segments {
 public:
  Segments(const ScanLine& line, int32_t segment_px)
      : line_(line), columns_(spec::columns_of(line)), segment_px_(segment_px) {}

  [[nodiscard]] Sample operator()(const Rational& x) {
    const int32_t px = spec::floor(x);
    move_to(px - (px - columns_.first_px) % segment_px_);
    Rational t(px - from_px_, std::max(to_px_ - from_px_, 1));
    t.canonicalize();
    return {from_.u + t * (to_.u - from_.u), from_.v + t * (to_.v - from_.v)};
  }

 private:
  void move_to(int32_t from_px) {
    if (to_px_ >= from_px_ && from_px == from_px_) return;
    const Rational half(1, 2);
    from_px_ = from_px;
    to_px_ = std::min(from_px + segment_px_, columns_.last_px());
    from_ = Recipe::interpolate(line_, from_px_ + half);
    to_ = Recipe::interpolate(line_, to_px_ + half);
  }

  ScanLine line_;
  spec::Columns columns_;
  int32_t segment_px_;
  int32_t from_px_ = 0, to_px_ = -1;  // no segment yet
  Sample from_{}, to_{};
};

// The longest segments, a multiple of 16 px, whose chords keep the tolerance; 0 if none do.
[[nodiscard]] int32_t longest_px(const ScanLine& line, double tolerance_fx16,
                                 double share_of_bound = 1) {
  const double of_16_px = spec::chord_bound(line, 16).get_d() * 65536.0 * share_of_bound;
  constexpr double kMost = 4096;
  const double most = of_16_px > 0 ? std::sqrt(tolerance_fx16 / of_16_px) : kMost;
  return 16 * static_cast<int32_t>(std::min(most, kMost));
}

template <class SegmentPx>
void add_subdivided(Catalogue* catalogue, std::string_view name, std::string_view bug,
                    SegmentPx segment_px) {
  catalogue->add(name, kToleranceLaw, bug, [=](Recipe& r) {
    r.map_of_row = [=](const Job& job, const ScanLine& line) -> Recipe::RowMap {
      const bool bends = job.tolerance > 0 && !spec::columns_of(line).empty();
      const int32_t px = bends ? segment_px(job, line) : 0;
      if (px > 0) return Segments(line, px);
      return [&line](const Rational& x) { return Recipe::interpolate(line, x); };
    };
  });
}

void spoil_bounds(Catalogue* catalogue) {
  add_subdivided(
      catalogue, "segments_twice_too_long",
      "perspective is divided half as often as the bound asks",
      [](const Job& job, const ScanLine& line) { return 2 * longest_px(line, job.tolerance); });
  add_subdivided(catalogue, "bound_by_the_greatest_q",
                 "the bound of a chord has the greatest q cubed below, not the least",
                 [](const Job& job, const ScanLine& line) {
                   const double left = line.left.q.get_d(), right = line.right.q.get_d();
                   const double ratio = std::min(left, right) / std::max(left, right);
                   return longest_px(line, job.tolerance, std::pow(ratio, 3));
                 });
  add_subdivided(
      catalogue, "tolerance_in_1_256_texel", "the tolerance is taken for 1/256 texel",
      [](const Job& job, const ScanLine& line) { return longest_px(line, 256.0 * job.tolerance); });
  add_subdivided(catalogue, "affine_whenever_tolerant",
                 "any tolerance is taken for leave to divide at span ends only",
                 [](const Job&, const ScanLine&) { return 1 << 20; });
}

void spoil_coverage(Catalogue* catalogue) {
  catalogue->add("tolerant_edges", kToleranceLaw, "within a tolerance x is taken for whole pixels",
                 [](Recipe& r) {
                   r.prepare = [](Job& job) {
                     if (job.tolerance == 0) return;
                     for (selvage_vertex& v : job.vertices) v.x &= ~(SELVAGE_SUBPIXELS - 1);
                   };
                 });
}

// The mapper that this program is linked with; tell(choice) changes what it tells.
template <class Tell>
[[nodiscard]] spec::Subject telling(std::string name, Tell tell) {
  spec::Subject subject = spec::built_in();
  subject.name = std::move(name);
  subject.choose = [tell](const selvage_image* target, const selvage_rect* clip,
                          const selvage_vertex* vertices, size_t count,
                          const selvage_texture* texture, const selvage_options* options,
                          selvage_choice* choice) {
    const selvage_status status =
        selvage_choose(target, clip, vertices, count, texture, options, choice);
    if (status == SELVAGE_OK) tell(*choice);
    return status;
  };
  return subject;
}

void spoil_telling(Catalogue* catalogue) {
  catalogue->add(
      kToleranceLaw, "the bound that is told is half of the derived one",
      telling("tells_half_the_bound", [](selvage_choice& choice) { choice.bound /= 2; }));
  catalogue->add(kToleranceLaw, "what is drawn within a tolerance is told exact",
                 telling("tells_that_it_is_exact", [](selvage_choice& choice) {
                   choice = {SELVAGE_METHOD_EXACT_PERSPECTIVE, 0, 0};
                 }));
  catalogue->add(
      kToleranceLaw, "segments are told to be half as long",
      telling("tells_shorter_segments", [](selvage_choice& choice) { choice.segment_px /= 2; }));
  struct Exact {
    const char *what, *name;
    selvage_method method, told;
  };
  for (const Exact& exact : {
           Exact{"what is affine is told a copy", "tells_a_copy", SELVAGE_METHOD_EXACT_AFFINE,
                 SELVAGE_METHOD_COPY},
           Exact{"what is in perspective is told affine", "tells_that_it_is_affine",
                 SELVAGE_METHOD_EXACT_PERSPECTIVE, SELVAGE_METHOD_EXACT_AFFINE},
           Exact{"where nothing is drawn a method is told", "tells_of_nothing", SELVAGE_METHOD_NONE,
                 SELVAGE_METHOD_EXACT_AFFINE},
           Exact{"copies are told to be nothing", "tells_nothing", SELVAGE_METHOD_COPY,
                 SELVAGE_METHOD_NONE},
           Exact{"of a filter that of nearest is told", "tells_no_filter", SELVAGE_METHOD_FILTER,
                 SELVAGE_METHOD_EXACT_AFFINE},
       }) {
    catalogue->add(kToleranceLaw, exact.what, telling(exact.name, [exact](selvage_choice& choice) {
                     if (choice.method == exact.method) choice.method = exact.told;
                   }));
  }
}

}  // namespace

void add_wrong_tolerance(Catalogue* catalogue) {
  spoil_bounds(catalogue);
  spoil_coverage(catalogue);
  spoil_telling(catalogue);
}

}  // namespace selvage::coverage
