#include "spec/law_tools.h"

#include <algorithm>
#include <utility>

#include "spec/outline_distance.h"

namespace selvage::spec {

// The finalizer of SplitMix64 (Steele, Lea, Flood 2014) over a Weyl sequence.
int32_t Choices::pick(int32_t least, int32_t end) {
  state_ += 0x9E3779B97F4A7C15U;
  uint64_t z = state_;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
  z ^= z >> 31;
  const auto count = static_cast<uint64_t>(int64_t{end} - least);
  return static_cast<int32_t>(least + static_cast<int64_t>(z % count));
}

Pixel choose_pixel(const Case& c, Choices& choices) {
  constexpr int32_t kFarthest_px = 30000;
  const int32_t x_px = choices.pick(0, std::min(c.target_width_px, kFarthest_px));
  const int32_t y_px = choices.pick(0, std::min(c.target_height_px, kFarthest_px));
  return {x_px, y_px};
}

Case with_nearest(const Case& c) {
  Case changed = c;
  changed.filter = SELVAGE_FILTER_NEAREST;
  return changed;
}

void take_other_texture_size(Case* c) {
  std::swap(c->texture_width_texel, c->texture_height_texel);
  if (c->texture_width_texel == c->texture_height_texel) {
    c->texture_width_texel = (c->texture_width_texel + 1) / 2;
  }
}

Case with_vertices(const Capabilities& claims, const Case& c,
                   std::vector<selvage_vertex> vertices) {
  Case changed = c;
  changed.vertices = std::move(vertices);
  make_acceptable(profile_of(c), claims, changed.vertices);
  if (!can_be_filtered(c)) changed.filter = SELVAGE_FILTER_NEAREST;
  return changed;
}

Case visible(const Subject& subject, Case c) {
  make_visible(profile_of(c), subject.claims, &c.vertices);
  return c;
}

std::optional<std::vector<selvage_vertex>> moved(std::span<const selvage_vertex> vertices,
                                                 int64_t dx_fx8, int64_t dy_fx8) {
  const auto in_range = [](int64_t fx8) { return SELVAGE_X_MIN <= fx8 && fx8 < SELVAGE_X_END; };
  std::vector<selvage_vertex> result(vertices.begin(), vertices.end());
  for (selvage_vertex& v : result) {
    if (!in_range(v.x + dx_fx8) || !in_range(v.y + dy_fx8)) return std::nullopt;
    v.x = static_cast<int32_t>(v.x + dx_fx8);
    v.y = static_cast<int32_t>(v.y + dy_fx8);
  }
  return result;
}

std::optional<std::vector<selvage_vertex>> moved_in_band(const Capabilities& claims, const Case& c,
                                                         int64_t dx_fx8, int64_t dy_fx8) {
  Case there = c;
  const auto vertices = moved(c.vertices, dx_fx8, dy_fx8);
  if (!vertices) return std::nullopt;
  there.vertices = *vertices;
  return lies_in_guard_band(claims, there) ? vertices : std::nullopt;
}

void tell_coordinates(Violation* violation, const Case& shown, int32_t x_px, int32_t y_px) {
  if (!is_valid(shown)) return;
  const std::optional<Sample> point = ModelRow(shown, y_px).coordinates(x_px);
  if (!point) return;
  violation->u = point->u.get_str();
  violation->v = point->v.get_str();
}

namespace {

// Of a texel of the coordinate texture.
void tell_offset(Violation* violation, const MaybePixel& drawn) {
  const Case& shown = violation->shown;
  if (!drawn || violation->u.empty() || shown.filter != SELVAGE_FILTER_NEAREST) return;
  const Texel texel = texel_of(*drawn);
  if (texel.s >= shown.texture_width_texel || texel.t >= shown.texture_height_texel) return;
  const Sample exact{Rational(violation->u), Rational(violation->v)};
  violation->off_by = offset_to(texel, exact, shown);
}

}  // namespace

std::string describe_colour(uint32_t pixel) {
  std::string text = "channels";
  for (int i = 0; i < 4; ++i) text += (i == 0 ? " " : ", ") + std::to_string(channel(pixel, i));
  return text;
}

std::string describe_pixel(const Case& c, const std::optional<uint32_t>& pixel) {
  if (!pixel) return "nothing";
  if (c.filter != SELVAGE_FILTER_NEAREST) return describe_colour(*pixel);
  const Texel texel = texel_of(*pixel);
  const bool is_outside = texel.s >= c.texture_width_texel || texel.t >= c.texture_height_texel;
  return describe_texel(*pixel) + (is_outside ? ", which the texture does not have" : "");
}

Violation violation_at(std::string_view law, std::string what, const Case& shown, int32_t x_px,
                       int32_t y_px, std::string allowed, const std::optional<uint32_t>& drawn) {
  Violation violation{.law = std::string(law),
                      .what = std::move(what),
                      .x_px = x_px,
                      .y_px = y_px,
                      .allowed = std::move(allowed),
                      .drawn = describe_pixel(shown, drawn),
                      .shown = shown};
  tell_coordinates(&violation, shown, x_px, y_px);
  tell_offset(&violation, drawn);
  return violation;
}

Violation violation_of_call(std::string_view law, std::string what, const Case& shown,
                            std::string allowed, std::string drawn) {
  return {.law = std::string(law),
          .what = std::move(what),
          .allowed = std::move(allowed),
          .drawn = std::move(drawn),
          .shown = shown};
}

bool is_in_doubt(int32_t coverage_accuracy_fx16, const Case& shown, Pixel at) {
  return coverage_accuracy_fx16 > 0 && is_visible(shown, at) &&
         is_near_outline(sample_point(shown, at), shown.vertices, coverage_accuracy_fx16);
}

void tell_outline_offset(Violation* violation, bool is_drawn) {
  const Case& shown = violation->shown;
  const Pixel at{violation->x_px, violation->y_px};
  if (!is_valid(shown) || !is_visible(shown, at)) return;
  if (ModelRow(shown, at.y_px).coordinates(at.x_px).has_value() == is_drawn) return;
  violation->off_by_px = outline_distance_px(sample_point(shown, at), shown.vertices).get_d();
}

WantedAt without_doubt(int32_t coverage_accuracy_fx16, const Case& shown, const Picture& picture,
                       WantedAt wanted_at) {
  return [&, coverage_accuracy_fx16, wanted_at = std::move(wanted_at)](int32_t x, int32_t y) {
    const Wanted wanted = wanted_at(x, y);
    const bool differs = wanted.judged && wanted.pixel != picture.at(x, y);
    return differs && is_in_doubt(coverage_accuracy_fx16, shown, {x, y}) ? unjudged() : wanted;
  };
}

Judgement compare(std::string_view law, std::string_view what, const Case& shown,
                  const Picture& picture, const WantedAt& wanted_at) {
  Judgement judgement;
  for (int32_t y = 0; y < picture.height_px; ++y) {
    for (int32_t x = 0; x < picture.width_px; ++x) {
      const Wanted wanted = wanted_at(x, y);
      if (!wanted.judged) continue;
      ++judgement.judged_px;
      if (wanted.pixel == picture.at(x, y)) continue;
      judgement.violation = violation_at(law, std::string(what), shown, x, y,
                                         describe_pixel(shown, wanted.pixel), picture.at(x, y));
      tell_outline_offset(&*judgement.violation, picture.at(x, y).has_value());
      return judgement;
    }
  }
  return judgement;
}

namespace {

[[nodiscard]] std::string describe(const Case& c, bool shows_texels, const MaybePixel& pixel) {
  if (shows_texels || !pixel) return describe_pixel(c, pixel);
  return c.format == SELVAGE_RGBA8888 ? describe_colour(*pixel) : "value " + std::to_string(*pixel);
}

[[nodiscard]] std::shared_ptr<const Comparison> comparison_of(const Picture& picture,
                                                              bool shows_texels,
                                                              const WantedAt& wanted_at) {
  Comparison all{picture, picture, shows_texels};
  size_t index = 0;
  for (int32_t y = 0; y < picture.height_px; ++y) {
    for (int32_t x = 0; x < picture.width_px; ++x, ++index) {
      const Wanted wanted = wanted_at(x, y);
      if (wanted.judged) all.wanted.pixels[index] = wanted.pixel;
    }
  }
  return std::make_shared<const Comparison>(std::move(all));
}

}  // namespace

Judgement compare(std::string_view law, std::string_view what, const Case& shown,
                  const Picture& picture, const OtherDrawing& other, const WantedAt& wanted_at) {
  const auto of_texels_judged = [&](int32_t x, int32_t y) {
    Wanted wanted = wanted_at(x, y);
    const MaybePixel& drawn = picture.at(x, y);
    if (!other.judges_texels && wanted.pixel && drawn) wanted.pixel = drawn;
    return wanted;
  };
  const WantedAt judged_at =
      without_doubt(other.coverage_accuracy_fx16, shown, picture, of_texels_judged);
  Judgement judgement = compare(law, what, shown, picture, judged_at);
  if (!judgement.violation) return judgement;
  Violation& violation = *judgement.violation;
  violation.comparison = comparison_of(picture, other.shows_texels, judged_at);
  if (!other.shows_texels) violation.off_by.reset();
  const auto told = [&](const Picture& of) {
    return describe(shown, other.shows_texels, of.at(violation.x_px, violation.y_px));
  };
  violation.drawn = told(violation.comparison->drawn);
  const bool is_any_texel =
      !other.judges_texels &&
      violation.comparison->wanted.at(violation.x_px, violation.y_px).has_value();
  violation.allowed = is_any_texel ? "a texel" : told(violation.comparison->wanted);
  violation.allowed += ", as " + std::string(other.clause);
  if (other.shows_texels && is_valid(shown)) {
    const MaybePixel exact = expected_pixel(shown, violation.x_px, violation.y_px);
    violation.allowed += "; the exact one is " + describe_pixel(shown, exact);
  }
  return judgement;
}

bool add(Judgement* total, Judgement part) {
  total->judged_px += part.judged_px;
  add(&total->margin, part.margin);
  if (!total->violation) total->violation = std::move(part.violation);
  return total->violation.has_value();
}

}  // namespace selvage::spec
