#include "reports/stability/measure.h"

#include <algorithm>
#include <cstdlib>
#include <tuple>

#include "reports/stability/bound.h"
#include "spec/law_tools.h"
#include "spec/outline_distance.h"
#include "spec/refusal.h"

namespace selvage::stability {
namespace {

void count_pixel(Errors& errors, const spec::Case& scene, const spec::Texel& exact,
                 const spec::Texel& drawn) {
  const int32_t distance = texel_error(scene, exact, drawn);
  const bool no_texel =
      drawn.s >= scene.texture_width_texel || drawn.t >= scene.texture_height_texel;
  if (no_texel) errors.memory_fault = "a pixel shows what no texel holds";
  ++errors.compared_px;
  errors.wrong_texels += distance > 0;
  errors.largest_texel = std::max(errors.largest_texel, distance);
  errors.sum_texel += static_cast<uint64_t>(distance);
}

// From the outline to a pixel's centre. A centre that is not on it is 2^-33 px away or more, for a
// doubled area of 1 (1/256 px)^2 is the least and 2^25 / 256 px the longest edge.
[[nodiscard]] double outline_offset_px(const spec::Case& scene, spec::Pixel at) {
  constexpr double kTie_px = 0x1p-34;
  const double px =
      spec::about_outline_distance_px(spec::pixel_centre(at.x_px, at.y_px), scene.vertices);
  return px < kTie_px ? 0 : px;
}

// Of a row of a case: how far off a texel may be at a pixel that its profile covers.
class OwnRow {
 public:
  OwnRow(const spec::Case& c, const spec::Rational& accuracy_texel, int32_t y_px)
      : accuracy_texel_(accuracy_texel) {
    if (c.profile == SELVAGE_PROFILE_EXACT) {
      exact_ = spec::scan_line(c.vertices, y_px);
    } else {
      historic_ = spec::historic_line(c.profile, c.vertices, y_px);
    }
  }

  [[nodiscard]] std::optional<spec::Reach> reach(int32_t x_px) const {
    if (historic_) return spec::reach(*historic_, x_px);
    const auto at = exact_ ? spec::sample(*exact_, x_px) : std::nullopt;
    if (!at) return std::nullopt;
    return spec::reach_around(*at, accuracy_texel_);
  }

 private:
  const spec::Rational& accuracy_texel_;  // in the exact profile
  std::optional<spec::ScanLine> exact_;
  std::optional<spec::HistoricLine> historic_;
};

// A drawing by the conventions of its own profile: the largest measured/bound over the pixels that
// the profile covers and that were drawn, and the pixels that are only one of the two.
// What is in doubt may be both.
void judge_by_own_conventions(const spec::Case& drawn_case, const spec::Capabilities& claims,
                              const spec::Picture& picture, Errors& errors) {
  double largest = 0;
  const spec::Rational accuracy_texel = spec::accuracy_of(claims);
  for (int32_t y = 0; y < picture.height_px; ++y) {
    const OwnRow row(drawn_case, accuracy_texel, y);
    for (int32_t x = 0; x < picture.width_px; ++x) {
      const std::optional<uint32_t>& pixel = picture.at(x, y);
      std::optional<spec::Reach> reach = row.reach(x);
      if (!is_visible(drawn_case, {x, y})) reach.reset();
      if (reach.has_value() != pixel.has_value() &&
          !is_in_doubt(claims.coverage_accuracy_fx16, drawn_case, {x, y})) {
        ++errors.own_coverage_px;
      }
      if (!reach || !pixel) continue;
      largest = std::max(largest, part_of_bound(drawn_case, *reach, spec::texel_of(*pixel)));
    }
  }
  errors.part_of_bound = largest;
}

[[nodiscard]] bool q_differs(const spec::Case& c) {
  return std::any_of(c.vertices.begin(), c.vertices.end(),
                     [&](const selvage_vertex& vertex) { return vertex.q != c.vertices[0].q; });
}

}  // namespace

int32_t texel_distance(int32_t a, int32_t b, int32_t size_texel, selvage_address address) {
  const int32_t straight = std::abs(a - b);
  if (address != SELVAGE_ADDRESS_WRAP || straight > size_texel) return straight;
  return std::min(straight, size_texel - straight);
}

int32_t texel_error(const spec::Case& scene, const spec::Texel& a, const spec::Texel& b) {
  return std::max(texel_distance(a.s, b.s, scene.texture_width_texel, scene.address),
                  texel_distance(a.t, b.t, scene.texture_height_texel, scene.address));
}

void Errors::add(const Errors& more) {
  compared_px += more.compared_px;
  missing_px += more.missing_px;
  extra_px += more.extra_px;
  wrong_texels += more.wrong_texels;
  largest_texel = std::max(largest_texel, more.largest_texel);
  sum_texel += more.sum_texel;
  largest_outline_px = std::max(largest_outline_px, more.largest_outline_px);
  part_of_bound = std::max(part_of_bound, more.part_of_bound);  // nothing is below every number
  own_coverage_px += more.own_coverage_px;
  judged_cases += more.judged_cases;
  refused_cases += more.refused_cases;
  hung = hung || more.hung;
  if (memory_fault.empty()) memory_fault = more.memory_fault;
}

double Errors::wrong_share() const {
  return compared_px == 0 ? 0
                          : static_cast<double>(wrong_texels) / static_cast<double>(compared_px);
}

double Errors::mean_texel() const {
  return compared_px == 0 ? 0 : static_cast<double>(sum_texel) / static_cast<double>(compared_px);
}

bool Errors::flawless() const {
  return wrong_texels == 0 && missing_px == 0 && extra_px == 0 && refused_cases == 0 &&
         memory_fault.empty();
}

bool Errors::keeps(Promise promise) const {
  if (!memory_fault.empty()) return false;
  if (promise == Promise::kExact) return flawless();
  return promise == Promise::kNothing ||
         (refused_cases == 0 && own_coverage_px == 0 && part_of_bound <= 1.0);
}

bool is_worse(const Errors& a, const Errors& b, Promise promise) {
  const auto key = [&](const Errors& errors) {
    return std::tuple(!errors.keeps(promise), errors.largest_texel, errors.wrong_texels,
                      errors.missing_px + errors.extra_px);
  };
  return key(a) > key(b);
}

spec::Picture drawing_of(const Contender& contender, const Reference& model) {
  const spec::Case scene = in_its_way(contender, model.scene);
  return spec::draw_whatever_answered(contender.subject, scene);
}

namespace {

[[nodiscard]] Errors errors_of(const Contender& contender, const Reference& model,
                               const spec::Picture& picture) {
  Errors errors{.judged_cases = 1};
  errors.refused_cases = picture.status != SELVAGE_OK;
  errors.memory_fault = picture.memory_fault;
  for (size_t i = 0; i < model.texels.size(); ++i) {
    const std::optional<spec::Texel>& exact = model.texels[i];
    if (exact && picture.pixels[i]) {
      count_pixel(errors, model.scene, *exact, spec::texel_of(*picture.pixels[i]));
    }
    errors.missing_px += exact && !picture.pixels[i];
    errors.extra_px += !exact && picture.pixels[i];
    if (exact.has_value() == picture.pixels[i].has_value()) continue;
    const auto at = static_cast<int32_t>(i);
    const double off_px =
        outline_offset_px(model.scene, {at % picture.width_px, at / picture.width_px});
    errors.largest_outline_px = std::max(errors.largest_outline_px, off_px);
  }
  if (contender.promise == Promise::kBound) {
    judge_by_own_conventions(in_its_way(contender, model.scene), contender.subject.claims, picture,
                             errors);
  }
  return errors;
}

}  // namespace

Errors errors_of(const Contender& contender, const Reference& model) {
  if (!can_draw(contender, model.scene, model.shows_address)) return {};
  try {
    return errors_of(contender, model, drawing_of(contender, model));
  } catch (const spec::NotClaimed&) {
    return {};
  } catch (const spec::SubjectFailure& failure) {
    return {.missing_px = model.covered_px,
            .judged_cases = 1,
            .hung = failure.hung,
            .memory_fault = "it " + failure.happened};
  }
}

FamilyRow measure(const spec::HardFamily& family, std::span<const Contender> contenders,
                  uint64_t first_seed, uint64_t case_count,
                  const std::function<void(uint64_t)>& progress) {
  FamilyRow row{&family};
  for (const Contender& contender : contenders) row.cells.push_back({&contender, {}, {}});
  for (uint64_t k = 0; k < case_count; ++k) {
    if (progress) progress(k);
    const uint64_t seed = first_seed + k;
    const Reference model = reference(family.make(seed));
    row.covered_px += model.covered_px;
    row.perspective = row.perspective || q_differs(model.scene);
    for (Cell& cell : row.cells) {
      if (cell.errors.hung) continue;
      const Errors errors = errors_of(*cell.contender, model);
      cell.errors.add(errors);
      const Promise promise = cell.contender->promise;
      const bool seen = !errors.flawless() || !errors.keeps(promise);
      if (seen && (!cell.worst || is_worse(errors, cell.worst->errors, promise)))
        cell.worst = Worst{seed, errors};
    }
  }
  return row;
}

}  // namespace selvage::stability
