#include "spec/polygon_scene.h"

#include <algorithm>
#include <array>
#include <utility>

#include "spec/law_tools.h"

namespace selvage::spec {
namespace {

inline constexpr int32_t kMostRowsAdded = 100, kMostRowsAddedRarely = 1000, kRarely = 16;
inline constexpr int32_t kMostPolygons = 8;
inline constexpr std::array<int32_t, 6> kLongLists = {9, 16, 17, 33, 65, 100};
inline constexpr size_t kMostTold = 8;

// The case over more rows, so that there are tiles and bands to be cut.
[[nodiscard]] Case heightened(const Case& c, int32_t longest_side_px, Choices& choices) {
  Case high = c;
  const bool is_high = choices.pick(0, kRarely) == 0 && c.target_width_px <= 32;
  const int32_t most_px = std::min({kMaxTargetPx / c.target_width_px, 32000, longest_side_px});
  high.target_height_px = std::clamp(
      c.target_height_px + choices.pick(0, is_high ? kMostRowsAddedRarely : kMostRowsAdded),
      c.target_height_px, std::max(c.target_height_px, most_px));
  if (choices.pick(0, 2) == 0) high.clip.bottom = high.target_height_px;
  return high;
}

// Of the second texture all texels are the complement of the first one's, or some: a mapper may
// know a texture again by a few of them.
[[nodiscard]] TexelAt texture_of(const Case& c, bool second) {
  constexpr int32_t kSome = 3;
  const bool all = c.choice % 2 == 0;
  return [texture = folded_texture(c.format), second, all](Texel texel) {
    const bool complement = second && (all || (texel.s + 2 * texel.t) % kSome == kSome - 1);
    return complement ? ~texture(texel) : texture(texel);
  };
}

// The same outline, with the (u, v) of each vertex at the one before: a mapper may know it again by
// its places.
[[nodiscard]] std::vector<selvage_vertex> with_texels_turned(std::vector<selvage_vertex> outline) {
  const selvage_vertex first = outline.front();
  for (size_t i = 0; i < outline.size(); ++i) {
    const selvage_vertex& next = i + 1 < outline.size() ? outline[i + 1] : first;
    outline[i].u = next.u;
    outline[i].v = next.v;
  }
  return outline;
}

// All over the target and beyond; where a copy cannot be it stays.
[[nodiscard]] std::vector<Pixel> moves_of(const Capabilities& claims, const Case& c,
                                          Choices& choices) {
  std::vector<Pixel> moves{{0, 0}};
  const bool is_long = choices.pick(0, 16) == 0 && c.target_width_px <= 64;
  const int32_t count = is_long ? kLongLists[static_cast<size_t>(choices.pick(0, 6))]
                                : choices.pick(2, kMostPolygons + 1);
  while (moves.size() < static_cast<size_t>(count)) {
    const int32_t dx_px = choices.pick(-c.target_width_px, c.target_width_px + 1) / 2;
    const int32_t dy_px = choices.pick(-c.target_height_px, c.target_height_px + 1);
    const bool can_be = moved_in_band(claims, c, int64_t{dx_px} * SELVAGE_SUBPIXELS,
                                      int64_t{dy_px} * SELVAGE_SUBPIXELS)
                            .has_value();
    moves.push_back(can_be ? Pixel{dx_px, dy_px} : Pixel{0, 0});
  }
  return moves;
}

[[nodiscard]] Case scene_case(const Subject& subject, const Case& c) {
  Choices choices(c.choice);
  return heightened(c, subject.claims.longest_side_px, choices);
}

// Of another size where any (u, v) may be drawn, and as given where the first is prepared.
[[nodiscard]] Case second_texture(const Subject& subject, Case c) {
  Choices choices(c.choice + 3);
  if (choices.pick(0, 3) == 0) c.layout = Layout::kGiven;
  if (!subject.claims.outside_texels || choices.pick(0, 2) == 0) return c;
  take_other_texture_size(&c);
  return c;
}

// Three vertices of an outline, as far from each other as they can be in its list.
[[nodiscard]] std::vector<selvage_vertex> triangle_of(const std::vector<selvage_vertex>& outline) {
  const size_t third = outline.size() / 3;
  return {outline[0], outline[third], outline[2 * third]};
}

}  // namespace

PolygonScene::PolygonScene(const Subject& subject, const Case& c)
    : case_(scene_case(subject, c)),
      second_(second_texture(subject, case_)),
      textures_{TextureMemory(subject, case_, texture_of(c, false), kSceneBackground),
                TextureMemory(subject, second_, texture_of(c, true), kSceneBackground)} {
  Choices choices(c.choice + 1);
  moves_ = moves_of(subject.claims, case_, choices);
  const auto first_kind = static_cast<size_t>(choices.pick(0, 3));
  for (const Pixel& move : moves_) {
    auto outline = moved(c.vertices, int64_t{move.x_px} * SELVAGE_SUBPIXELS,
                         int64_t{move.y_px} * SELVAGE_SUBPIXELS)
                       .value();
    const auto kind = static_cast<Kind>((first_kind + kinds_.size()) % 3);
    kinds_.push_back(kind);
    if (kind == Kind::kTriangle) {
      outline = triangle_of(outline);
      make_visible(profile_of(c), subject.claims, &outline);
    }
    if (kind == Kind::kOneQ) {
      for (selvage_vertex& v : outline) v.q = outline.front().q;
    }
    outlines_.push_back(std::move(outline));
  }
  if (is_last_turned()) {
    moves_.back() = moves_[moves_.size() - 2];
    kinds_.back() = kinds_[kinds_.size() - 2];
    outlines_.back() = with_texels_turned(outlines_[outlines_.size() - 2]);
  }
}

Case PolygonScene::case_of(size_t i) const {
  Case c = i % 2 == 0 ? case_ : second_;
  c.vertices = outlines_[i];
  return c;
}

std::string PolygonScene::copies() const {
  std::string text = "as copies of it, moved by";
  for (size_t i = 0; i < std::min(moves_.size(), kMostTold); ++i) {
    text += (i > 0 ? ", (" : " (") + std::to_string(moves_[i].x_px) + ", " +
            std::to_string(moves_[i].y_px) + ")";
    if (kinds_[i] == Kind::kTriangle) text += " as a triangle of it";
    if (kinds_[i] == Kind::kOneQ) text += " with its first q alone";
  }
  text += " px";
  if (moves_.size() > kMostTold) {
    text += ", and " + std::to_string(moves_.size() - kMostTold) + " more";
  }
  if (is_last_turned()) text += ", the last with the (u, v) of each vertex at the one before";
  return text +
         ": every second polygon shows the second texture, some or all of whose texels are "
         "the complement, of " +
         std::to_string(second_.texture_width_texel) + " x " +
         std::to_string(second_.texture_height_texel) + " texels";
}

Picture PolygonScene::picture_of(const Canvas& drawn) const {
  const uint32_t background = blank().pixel(0, 0);
  Picture picture{case_.target_width_px, case_.target_height_px};
  for (int32_t y = 0; y < case_.target_height_px; ++y) {
    for (int32_t x = 0; x < case_.target_width_px; ++x) {
      const uint32_t value = drawn.pixel(x, y);
      picture.pixels.push_back(value == background ? MaybePixel() : value);
    }
  }
  return picture;
}

std::string PolygonScene::describe(const std::optional<uint32_t>& pixel) const {
  if (!pixel) return "nothing";
  if (case_.filter != SELVAGE_FILTER_NEAREST) return describe_colour(*pixel);
  const auto told = [&](uint32_t value) -> std::optional<std::string> {
    const std::optional<Texel> texel = texel_of_folded(case_, value);
    if (!texel) return {};
    return describe_texel(coordinate_texel(texel->s, texel->t));
  };
  if (const auto first = told(*pixel)) return *first + " of the first texture";
  if (const auto second = told(~*pixel & value_bits(case_.format))) {
    return *second + " of the second texture";
  }
  return "value " + std::to_string(*pixel);
}

std::vector<selvage_polygon> PolygonScene::polygons(
    const std::vector<selvage_texture>& textures) const {
  std::vector<selvage_polygon> all;
  for (const auto& outline : outlines_) {
    all.push_back({outline.data(), outline.size(), &textures[all.size() % 2]});
  }
  return all;
}

TexelAt PolygonScene::texels_of(size_t i) const { return texture_of(case_, i % 2 == 1); }

void PolygonScene::put_texture(const Subject& subject, size_t i,
                               std::optional<TextureMemory>* memory) const {
  const TexelAt texel_at = texels_of(i);
  const Case& c = i % 2 == 0 ? case_ : second_;
  const bool fits = case_.texture_width_texel == second_.texture_width_texel &&
                    case_.texture_height_texel == second_.texture_height_texel;
  if (*memory && fits) {
    (*memory)->change(subject, c, texel_at);
  } else {
    memory->emplace(subject, c, texel_at, kSceneBackground);
  }
}

}  // namespace selvage::spec
