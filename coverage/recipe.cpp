#include "coverage/recipe.h"

#include <cstring>
#include <utility>

namespace selvage::coverage {
namespace {

[[nodiscard]] size_t bytes_per_pixel(selvage_format format) {
  return format == SELVAGE_INDEX8 ? 1 : format == SELVAGE_RGB565 ? 2 : 4;
}

void copy_texel(const Job& job, int32_t s, int32_t t, int32_t x, int32_t y) {
  const auto size = static_cast<ptrdiff_t>(bytes_per_pixel(job.target.format));
  const char* texel =
      static_cast<const char*>(job.texture.texels) + t * job.texture.pitch + s * size;
  char* pixel = static_cast<char*>(job.target.pixels) + y * job.target.pitch + x * size;
  std::memcpy(pixel, texel, static_cast<size_t>(size));
}

void draw_row(const Recipe& recipe, const Job& job, const spec::ScanLine& line, int32_t y) {
  for (int32_t x = 0; x < job.target.width; ++x) {
    const spec::Rational centre = x + spec::Rational(1, 2);
    if (!recipe.in_clip(job, x, y) || !recipe.covers(line, centre)) continue;
    if (line.left.x == line.right.x) continue;
    const spec::Sample point = recipe.map(job, line, centre);
    const int32_t s = recipe.address(recipe.round(point.u), job.texture.width, job.address);
    const int32_t t = recipe.address(recipe.round(point.v), job.texture.height, job.address);
    copy_texel(job, s, t, x, y);
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

spec::Sample Recipe::interpolate(const spec::ScanLine& line, const spec::Rational& x) {
  const spec::Rational t = (x - line.left.x) / (line.right.x - line.left.x);
  const auto mix = [&](const spec::Rational& a, const spec::Rational& b) {
    return spec::Rational(a + t * (b - a));
  };
  const spec::Rational q = mix(line.left.q, line.right.q);
  return {mix(line.left.uq, line.right.uq) / q, mix(line.left.vq, line.right.vq) / q};
}

spec::Subject subject_of(std::string name, Recipe recipe) {
  const auto call = [recipe = std::move(recipe)](const selvage_image* target,
                                                 const selvage_rect* clip,
                                                 const selvage_vertex* vertices, size_t count,
                                                 const selvage_texture* texture,
                                                 const selvage_options* options) -> selvage_status {
    // The checks are not what is wrong here: an empty clip rectangle asks for nothing but them.
    const selvage_rect nothing{0, 0, 0, 0};
    const selvage_status status = selvage_draw(target, &nothing, vertices, count, texture, options);
    if (status != SELVAGE_OK) return recipe.status(status);
    draw(recipe,
         Job{.target = *target,
             .clip = clip != nullptr ? *clip : selvage_rect{0, 0, target->width, target->height},
             .vertices = {vertices, vertices + count},
             .texture = *texture,
             .address = options != nullptr ? options->address : SELVAGE_ADDRESS_CLAMP});
    return recipe.status(status);
  };
  return {std::move(name), call};
}

}  // namespace selvage::coverage
