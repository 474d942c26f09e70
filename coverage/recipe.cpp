#include "coverage/recipe.h"

#include <utility>

namespace selvage::coverage {
namespace {

[[nodiscard]] uint32_t filtered(const Recipe& recipe, const Job& job, const spec::Sample& point,
                                int32_t x, int32_t y) {
  const spec::BoxSides sides = job.filter == SELVAGE_FILTER_AREA
                                   ? recipe.sides(recipe.gradient(job, x, y))
                                   : spec::BoxSides{};
  return recipe.mean(recipe.address_taps(recipe.taps(job.filter, point.u, sides.u_fx8),
                                         job.texture.width, job.address),
                     recipe.address_taps(recipe.taps(job.filter, point.v, sides.v_fx8),
                                         job.texture.height, job.address),
                     [&](spec::Texel texel) { return texel_value(job, texel); });
}

[[nodiscard]] Recipe::RowMap map_of_row(const Recipe& recipe, const Job& job,
                                        const spec::ScanLine& line) {
  if (recipe.map_of_row) return recipe.map_of_row(job, line);
  return [&](const spec::Rational& x) { return recipe.map(job, line, x); };
}

void draw_row(const Recipe& recipe, const Job& job, const spec::ScanLine& line, int32_t y) {
  if (line.left.x == line.right.x) return;
  const Recipe::RowMap map = map_of_row(recipe, job, line);
  for (int32_t x = 0; x < job.target.width; ++x) {
    const spec::Rational centre = x + spec::Rational(1, 2);
    if (!recipe.in_clip(job, x, y) || !recipe.covers(line, centre)) continue;
    const spec::Sample point = map(centre);
    if (job.filter != SELVAGE_FILTER_NEAREST) {
      set_pixel(job, filtered(recipe, job, point, x, y), x, y);
      continue;
    }
    const int32_t s = recipe.address(recipe.round(point.u), job.texture.width, job.address);
    const int32_t t = recipe.address(recipe.round(point.v), job.texture.height, job.address);
    copy_texel(job, {s, t}, x, y);
  }
}

void draw(const Recipe& recipe, Job job) {
  recipe.prepare(job);
  if (spec::validity(job.vertices) == SELVAGE_OK) {
    for (int32_t y = 0; y < job.target.height; ++y) {
      const std::optional<spec::ScanLine> line = recipe.cross(job, y);
      if (line) draw_row(recipe, job, *line, y);
    }
  }
  recipe.finish(job);
}

}  // namespace

spec::Gradient gradient_at(const std::vector<selvage_vertex>& vertices, int32_t x_px,
                           int32_t y_px) {
  return spec::gradient(vertices, x_px, y_px).value_or(spec::Gradient{});
}

spec::Sample Recipe::interpolate(const spec::ScanLine& line, const spec::Rational& x) {
  const spec::Rational t = (x - line.left.x) / (line.right.x - line.left.x);
  const auto mix = [&](const spec::Rational& a, const spec::Rational& b) {
    return spec::Rational(a + t * (b - a));
  };
  const spec::Rational q = mix(line.left.q, line.right.q);
  if (q == 0) return {};  // beyond the ends of the span
  return {mix(line.left.uq, line.right.uq) / q, mix(line.left.vq, line.right.vq) / q};
}

spec::Subject subject_of(std::string name, Recipe recipe) {
  EndStatus status = recipe.status;
  return subject_of(
      std::move(name), SELVAGE_PROFILE_EXACT,
      [recipe = std::move(recipe)](Job job) { draw(recipe, std::move(job)); }, std::move(status));
}

}  // namespace selvage::coverage
