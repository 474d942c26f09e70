// Mutations of what is drawn to and from: sizes, clip, formats, options.
#include <algorithm>
#include <cstdint>

#include "spec/mutate_case.h"

namespace selvage::spec {
namespace {

constexpr int32_t kLongestSide_px = 1024;  // the model looks at every pixel
constexpr int32_t kMostTarget_px = 4096;

// A side that is set keeps the image within what a case may have.
void set_side(Case& c, int32_t Case::*side, int32_t Case::*other, int64_t value, int64_t most) {
  c.*side =
      static_cast<int32_t>(std::clamp<int64_t>(value, 1, std::max<int64_t>(most / c.*other, 1)));
}

void resize_target(Random& random, Case& c) {
  const bool wide = random.percent(65);
  const auto side = wide ? &Case::target_width_px : &Case::target_height_px;
  const auto other = wide ? &Case::target_height_px : &Case::target_width_px;
  const int64_t now = c.*side;
  const int64_t value = random.pick({now + 1, now - 1, 2 * now, 3 * now, now / 2});
  if (value > kLongestSide_px || value * c.*other > kMostTarget_px) return;
  set_side(c, side, other, value, kMaxTargetPx);
}

void resize_texture(Random& random, Case& c) {
  const bool wide = random.percent(50);
  const auto side = wide ? &Case::texture_width_texel : &Case::texture_height_texel;
  const auto other = wide ? &Case::texture_height_texel : &Case::texture_width_texel;
  const int64_t now = c.*side;
  const int64_t value =
      random.pick({now + 1, now - 1, 2 * now, now / 2, int64_t{1}, int64_t{256}, int64_t{5}});
  set_side(c, side, other, value, kMaxTextureTexels);
}

// To a pixel that a vertex lies in, to the target's end, or by one.
void move_clip_side(Random& random, Case& c) {
  if (!c.has_clip) c.clip = {0, 0, c.target_width_px, c.target_height_px};
  c.has_clip = true;
  const bool of_x = random.percent(60), first = random.percent(60);
  int32_t& side =
      of_x ? (first ? c.clip.left : c.clip.right) : (first ? c.clip.top : c.clip.bottom);
  const int32_t end_px = of_x ? c.target_width_px : c.target_height_px;
  int32_t value = random.pick({side + 1, side - 1, 0, end_px, random.in(0, int64_t{end_px} + 1)});
  if (!c.vertices.empty() && random.percent(40)) {
    const selvage_vertex& v = c.vertices[random.below(c.vertices.size())];
    value = ((of_x ? v.x : v.y) >> 8) + random.in(-1, 2);
  }
  side = std::clamp(value, kClipLeast_px, kClipGreatest_px);
}

void drop_clip(Random&, Case& c) {
  c.has_clip = false;
  c.clip = {};
}

void change_choice(Random& random, Case& c) { c.choice = static_cast<uint32_t>(random.bits()); }

void change_format(Random& random, Case& c) {
  c.format = random.pick({SELVAGE_RGBA8888, SELVAGE_RGBA8888, SELVAGE_RGB565, SELVAGE_INDEX8});
}

void change_filter(Random& random, Case& c) {
  if (!can_be_filtered(c)) return;
  c.filter = random.pick(
      {SELVAGE_FILTER_NEAREST, SELVAGE_FILTER_FOUR, SELVAGE_FILTER_BILINEAR, SELVAGE_FILTER_AREA});
}

void change_address(Random&, Case& c) {
  c.address = c.address == SELVAGE_ADDRESS_CLAMP ? SELVAGE_ADDRESS_WRAP : SELVAGE_ADDRESS_CLAMP;
}

void change_memory(Random& random, Case& c) {
  c.layout = random.pick({Layout::kGiven, Layout::kPadded, Layout::kTiled});
  c.padding_px = random.in(0, 16);
  c.flip_target = random.percent(25);
  c.flip_texture = random.percent(25);
}

constexpr Mutation kDrawingMutations[] = {
    {"resize target", resize_target},   {"resize texture", resize_texture},
    {"move clip side", move_clip_side}, {"drop clip", drop_clip},
    {"change choice", change_choice},   {"change choice", change_choice},
    {"change format", change_format},   {"change filter", change_filter},
    {"change address", change_address}, {"change memory", change_memory}};

}  // namespace

std::span<const Mutation> drawing_mutations() { return kDrawingMutations; }

}  // namespace selvage::spec
