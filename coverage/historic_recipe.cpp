#include "coverage/historic_recipe.h"

#include <algorithm>
#include <cstdlib>
#include <tuple>
#include <utility>

#include "spec/dda.h"
#include "spec/vertex_units.h"

namespace selvage::coverage {
namespace {

using spec::kTexel_fx16;

[[nodiscard]] int64_t floor_half(int64_t a) { return floor_quotient(a, 2); }

// ceil x, for the error term that Bresenham's edge keeps passes 0 where x leaves a whole column.
[[nodiscard]] int64_t column_from(const HistoricEdge& edge, int64_t rows) {
  return edge.left_px() - floor_quotient(-rows * edge.width_px(), edge.height_px());
}

[[nodiscard]] int64_t nearest_column(const HistoricEdge& edge, int64_t rows) {
  const int64_t height = edge.height_px();
  return edge.left_px() + floor_quotient(2 * rows * edge.width_px() + height, 2 * height);
}

[[nodiscard]] HistoricSpan left_runs_up(const EdgePoint& a, const EdgePoint& b) {
  return a.edge.runs_down ? HistoricSpan{b, a} : HistoricSpan{a, b};
}

[[nodiscard]] HistoricSpan left_is_least(const EdgePoint& a, const EdgePoint& b) {
  const auto key = [](const EdgePoint& end) {
    return std::tuple(end.column_px, end.u_fx16, end.v_fx16);
  };
  return key(b) < key(a) ? HistoricSpan{b, a} : HistoricSpan{a, b};
}

[[nodiscard]] int32_t addressed(int64_t texel, int32_t size, selvage_address mode) {
  if (mode == SELVAGE_ADDRESS_CLAMP) {
    return static_cast<int32_t>(std::clamp<int64_t>(texel, 0, size - 1));
  }
  return static_cast<int32_t>(texel - size * floor_quotient(texel, size));
}

[[nodiscard]] std::vector<HistoricEdge> edges_met(const HistoricRecipe& recipe, const Job& job,
                                                  int32_t y) {
  std::vector<HistoricEdge> edges;
  for (size_t i = 0; i < job.vertices.size(); ++i) {
    const selvage_vertex& a = job.vertices[i];
    const selvage_vertex& b = job.vertices[(i + 1) % job.vertices.size()];
    if (a.y == b.y) continue;
    const bool runs_down = a.y < b.y;
    const auto& [top, bottom] = runs_down ? std::tie(a, b) : std::tie(b, a);
    const HistoricEdge edge{top, bottom, runs_down, top.y / SELVAGE_SUBPIXELS,
                            bottom.y / SELVAGE_SUBPIXELS};
    if (recipe.meets(job, edge, y)) edges.push_back(edge);
  }
  return edges;
}

[[nodiscard]] EdgePoint meet(const HistoricRecipe& recipe, const Job& job, const HistoricEdge& edge,
                             int32_t y) {
  const int64_t rows = recipe.source_rows(job, edge, y), height = edge.height_px();
  return {edge, rows, recipe.column(edge, recipe.target_rows(job, edge, y)),
          recipe.edge_walk(edge.top.u, edge.bottom.u, rows, height),
          recipe.edge_walk(edge.top.v, edge.bottom.v, rows, height)};
}

[[nodiscard]] spec::Texel texel_at(const HistoricRecipe& recipe, const Job& job,
                                   const HistoricSpan& span, int32_t x) {
  const int64_t steps = recipe.steps(job, span), walked = recipe.walked(job, span, x);
  const auto along = [&](int64_t left_fx16, int64_t right_fx16, int32_t size_texel) {
    const int64_t at_fx16 =
        steps == 0 ? left_fx16 : recipe.span_walk(left_fx16, right_fx16, walked, steps);
    return recipe.address(recipe.texel(at_fx16), size_texel, job.address);
  };
  return {along(span.left.u_fx16, span.right.u_fx16, job.texture.width),
          along(span.left.v_fx16, span.right.v_fx16, job.texture.height)};
}

void draw_row(const HistoricRecipe& recipe, const Job& job, int32_t y) {
  const std::vector<HistoricEdge> edges = edges_met(recipe, job, y);
  if (edges.size() != 2) return;
  const HistoricSpan span =
      recipe.order(meet(recipe, job, edges[0], y), meet(recipe, job, edges[1], y));
  const std::optional<spec::Texel> block = recipe.block_shift(job);
  for (int32_t x = 0; x < job.target.width; ++x) {
    if (!recipe.in_clip(job, x, y) || !recipe.covers(span, x)) continue;
    const spec::Texel texel =
        block ? spec::Texel{recipe.address(x + block->s, job.texture.width, job.address),
                            recipe.address(y + block->t, job.texture.height, job.address)}
              : texel_at(recipe, job, span, x);
    copy_texel(job, texel, x, y);
  }
}

void set_two_stage(HistoricRecipe* r) {
  const bool prestep = r->profile == SELVAGE_PROFILE_ABRASH57;
  r->meets = [](const Job&, const HistoricEdge& edge, int32_t y) {
    return edge.top_px <= y && y < edge.bottom_px;
  };
  r->column = column_from;
  r->edge_walk = r->span_walk = prestep ? prestepped_walk : truncated_walk;
  r->order = left_runs_up;
  r->covers = [](const HistoricSpan& span, int32_t x) {
    return span.left.column_px <= x && x < span.right.column_px;
  };
  const int64_t rounding_fx16 = prestep ? kTexel_fx16 / 2 : 0;
  r->texel = [=](int64_t fx16) { return floor_quotient(fx16 + rounding_fx16, kTexel_fx16); };
  r->block_shift = [=](const Job& job) {
    return prestep ? spec::centred_block_shift(job.vertices) : std::nullopt;
  };
}

void set_classroom(HistoricRecipe* r) {
  r->meets = [](const Job& job, const HistoricEdge& edge, int32_t y) {
    const int32_t lowest_fx8 = std::ranges::max(job.vertices, {}, &selvage_vertex::y).y;
    if (y == lowest_fx8 / SELVAGE_SUBPIXELS) return edge.bottom_px == y;
    return edge.top_px <= y && y < edge.bottom_px;
  };
  r->column = nearest_column;
  r->edge_walk = rounded_walk;
  r->span_walk = even_walk;
  r->order = left_is_least;
  r->covers = [](const HistoricSpan& span, int32_t x) {
    return span.left.column_px <= x && x <= span.right.column_px;
  };
  r->texel = [](int64_t fx16) { return floor_quotient(fx16 + kTexel_fx16 / 2, kTexel_fx16); };
  r->block_shift = [](const Job&) { return std::nullopt; };
}

}  // namespace

int64_t floor_quotient(int64_t a, int64_t b) { return a / b - (a % b < 0 ? 1 : 0); }

int64_t truncated_walk(int64_t a, int64_t b, int64_t walked, int64_t steps) {
  return a + walked * ((b - a) / steps);
}

int64_t prestepped_walk(int64_t a, int64_t b, int64_t walked, int64_t steps) {
  return truncated_walk(a, b, walked, steps) + floor_half((b - a) / steps);
}

int64_t even_walk(int64_t a, int64_t b, int64_t walked, int64_t steps) {
  return a + floor_quotient(walked * (b - a), steps);
}

int64_t rounded_walk(int64_t a, int64_t b, int64_t walked, int64_t steps) {
  const int64_t twice = 2 * (a * steps + walked * (b - a)) + kTexel_fx16 * steps;
  return floor_quotient(twice, 2 * steps * kTexel_fx16) * kTexel_fx16;
}

HistoricRecipe::HistoricRecipe(selvage_profile id) : profile(id) {
  target_rows = source_rows = [](const Job&, const HistoricEdge& edge, int32_t y) {
    return int64_t{y} - edge.top_px;
  };
  steps = [](const Job&, const HistoricSpan& span) {
    return span.right.column_px - span.left.column_px;
  };
  walked = [](const Job&, const HistoricSpan& span, int32_t x) { return x - span.left.column_px; };
  address = addressed;
  if (id == SELVAGE_PROFILE_DKIT) {
    set_classroom(this);
  } else {
    set_two_stage(this);
  }
}

spec::Subject subject_of(std::string name, HistoricRecipe recipe) {
  const selvage_profile profile = recipe.profile;
  EndStatus status = recipe.status;
  const auto draw = [recipe = std::move(recipe)](const Job& job) {
    for (int32_t y = 0; y < job.target.height; ++y) draw_row(recipe, job, y);
  };
  return subject_of(std::move(name), profile, draw, std::move(status));
}

}  // namespace selvage::coverage
