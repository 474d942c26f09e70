#include "spec/texture_memory.h"

#include <algorithm>

namespace selvage::spec {
namespace {

inline constexpr size_t kGuardBytes = SELVAGE_PREPARED_ALIGNMENT;

void fill(const Case& c, const TexelAt& texel_at, Canvas* rows) {
  for (int32_t t = 0; t < c.texture_height_texel; ++t) {
    for (int32_t s = 0; s < c.texture_width_texel; ++s) rows->set_pixel(s, t, texel_at({s, t}));
  }
}

}  // namespace

Layout layout_of(const Subject& subject, const Case& c) {
  if (!subject.prepare) return Layout::kGiven;
  const bool tiled = c.layout == Layout::kTiled && c.profile != SELVAGE_PROFILE_EXACT;
  return tiled ? Layout::kPadded : c.layout;
}

TextureMemory::TextureMemory(const Subject& subject, const Case& c, const TexelAt& texel_at,
                             uint8_t outside)
    : outside_(outside),
      given_(c.format, c.texture_width_texel, c.texture_height_texel, c.padding_px, c.flip_texture,
             outside) {
  change(subject, c, texel_at);
}

void TextureMemory::change(const Subject& subject, const Case& c, const TexelAt& texel_at) {
  fill(c, texel_at, &given_);
  view_ = given_.texture();
  lay_out(subject, c);
}

void TextureMemory::lay_out(const Subject& subject, const Case& c) {
  const Layout layout = layout_of(subject, c);
  if (layout == Layout::kGiven) return;
  // Sums are there for the area filter, and change nothing for others.
  const bool with_sums = c.filter == SELVAGE_FILTER_AREA || c.choice % 4 == 0;
  prepare(*subject.prepare, layout == Layout::kTiled ? SELVAGE_LAYOUT_TILES : SELVAGE_LAYOUT_ROWS,
          with_sums && can_be_filtered(c));
}

TextureMemory::~TextureMemory() {
  if (release_) release_();
}

void TextureMemory::prepare(const Prepare& prepare, selvage_layout layout, bool with_sums) {
  const selvage_texture source = view_;
  const size_t bytes = prepare.bytes(&source, layout, with_sums ? 1 : 0);
  if (bytes == SIZE_MAX) {
    status_ = prepare.prepare(&source, layout, with_sums ? 1 : 0, nullptr, 0, &view_);
    return;
  }
  memory_.assign(bytes + 2 * kGuardBytes + SELVAGE_PREPARED_ALIGNMENT, outside_);
  const size_t misaligned =
      reinterpret_cast<uintptr_t>(memory_.data()) % SELVAGE_PREPARED_ALIGNMENT;
  const size_t start = kGuardBytes + SELVAGE_PREPARED_ALIGNMENT - misaligned;
  const Canvas before = given_;
  uint8_t* const given = memory_.data() + start;
  status_ = prepare.prepare(&source, layout, with_sums ? 1 : 0, given, bytes, &view_);
  if (prepare.release) release_ = [release = prepare.release, given] { release(given); };
  const auto is_outside = [&](uint8_t byte) { return byte == outside_; };
  const auto first = memory_.begin() + static_cast<ptrdiff_t>(start);
  if (!std::all_of(memory_.begin(), first, is_outside) ||
      !std::all_of(first + static_cast<ptrdiff_t>(bytes), memory_.end(), is_outside)) {
    fault_ = "preparing the texture wrote beside the memory it was given";
  }
  if (!(given_ == before)) fault_ = "preparing the texture wrote to its source";
}

}  // namespace selvage::spec
