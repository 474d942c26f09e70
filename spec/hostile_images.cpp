#include "spec/hostile_images.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>
#include <utility>

#include "spec/canvas.h"

namespace selvage::spec {
namespace {

// The errors that a target and a texture share.
struct ImageErrors {
  std::string name;
  selvage_status null, format, size, pitch, alignment;
};

// Spoils either image through the accessor `of`, a function from Arguments& to the image.
template <class Of>
void spoil_image(Calls* calls, const ImageErrors& errors, selvage_format format, Of of) {
  const auto add = [&](std::string what, selvage_status wanted, auto spoil) {
    calls->push_back({errors.name + " with " + what, wanted, [=](Arguments& a) { spoil(of(a)); }});
  };
  for (const int32_t unknown : {-1, 3, kInt32Min, kInt32Max}) {
    add("an unknown format", errors.format, [=](auto& image) { image.format = unknown; });
  }
  for (const int32_t empty : {0, -1, kInt32Min}) {
    add("no width", errors.size, [=](auto& image) { image.width = empty; });
    add("no height", errors.size, [=](auto& image) { image.height = empty; });
  }
  const ptrdiff_t pixel = bytes_per_pixel(format);
  add("a pitch short of a row", errors.pitch,
      [=](auto& image) { image.pitch = (image.width - 1) * pixel; });
  add("a negative pitch short of a row", errors.pitch,
      [=](auto& image) { image.pitch = -(image.width - 1) * pixel; });
  add("rows longer than the pitch", errors.pitch, [](auto& image) { image.width = kInt32Max; });
  add("more bytes than an address can tell", errors.pitch, [=](auto& image) {
    image.height = kInt32Max;
    image.pitch = std::numeric_limits<ptrdiff_t>::max() / 4 / pixel * pixel;
  });
  add("a second row that ends beyond the last address", errors.pitch, [=](auto& image) {
    image.height = 2;
    image.pitch = std::numeric_limits<ptrdiff_t>::max() / pixel * pixel;
  });
  add("the least of all pitches", errors.pitch, [](auto& image) {
    image.height = 2;
    image.pitch = std::numeric_limits<ptrdiff_t>::min();
  });
  if (pixel == 1) return;
  add("a pitch that splits a pixel", errors.pitch,
      [](auto& image) { image.pitch += image.pitch > 0 ? 1 : -1; });
}

// A texture of two texels that starts so many pixels before the target's first.
void start_before(Arguments& a, ptrdiff_t distance_px) {
  a.target.height = 1;
  a.target.pitch = std::abs(a.target.pitch);
  a.texture.width = 2;
  a.texture.height = 1;
  a.texture.pitch = 1024;
  a.texture.texels =
      static_cast<const char*>(a.target.pixels) - distance_px * bytes_per_pixel(a.target.format);
}

// One bitmap of two columns: the target is the left one, and the texture is beside it or meets it.
// Of so many rows, but the one that comes last in memory.
void share_rows(Arguments& a, int32_t column_px, int32_t rows) {
  const ptrdiff_t pixel = bytes_per_pixel(a.target.format);
  char* const first =
      static_cast<char*>(a.target.pixels) + (a.target.pitch < 0 ? a.target.pitch : 0);
  a.target.width = 1;
  a.texture = {first + column_px * pixel, 1,      rows, a.target.pitch, a.target.format,
               SELVAGE_LAYOUT_ROWS,       nullptr};
}

}  // namespace

void spoil_images(Calls* calls, selvage_format format) {
  spoil_image(
      calls,
      {"a target", SELVAGE_ERROR_TARGET_NULL, SELVAGE_ERROR_TARGET_FORMAT,
       SELVAGE_ERROR_TARGET_SIZE, SELVAGE_ERROR_TARGET_PITCH, SELVAGE_ERROR_TARGET_ALIGNMENT},
      format, [](Arguments& a) -> selvage_image& { return a.target; });
  spoil_image(
      calls,
      {"a texture", SELVAGE_ERROR_TEXTURE_NULL, SELVAGE_ERROR_TEXTURE_FORMAT,
       SELVAGE_ERROR_TEXTURE_SIZE, SELVAGE_ERROR_TEXTURE_PITCH, SELVAGE_ERROR_TEXTURE_ALIGNMENT},
      format, [](Arguments& a) -> selvage_texture& { return a.texture; });
}

void spoil_preparation(Calls* calls, const Case& c, const Capabilities& claims) {
  const auto add = [&](std::string what, selvage_status wanted, auto spoil) {
    calls->push_back({std::move(what), wanted, spoil});
  };
  add("sums that are not behind the texels", SELVAGE_ERROR_TEXTURE_PREPARED,
      [](Arguments& a) { a.texture.prepared = &a; });
  add("sums a row too far behind the texels", SELVAGE_ERROR_TEXTURE_PREPARED, [](Arguments& a) {
    if (a.texture.pitch < 0) {
      const auto* const last_row = static_cast<const char*>(a.texture.texels);
      a.texture.texels = last_row + a.texture.pitch * (ptrdiff_t{a.texture.height} - 1);
      a.texture.pitch = -a.texture.pitch;
    }
    a.texture.prepared = static_cast<const char*>(a.texture.texels) +
                         a.texture.pitch * (ptrdiff_t{a.texture.height} + 1);
  });
  constexpr int32_t kTiled_texel = 8;
  const ptrdiff_t tile = 16 * bytes_per_pixel(c.format);
  const auto tiled = [=](Arguments& a, ptrdiff_t pitch) {
    alignas(64) static const char texels[16 * 4 * 4 * 4] = {};
    a.texture = {texels + 16 * 4, kTiled_texel,         kTiled_texel / 2, pitch,
                 c.format,        SELVAGE_LAYOUT_TILES, nullptr};
  };
  add("tiles at a pitch short of a row of them", SELVAGE_ERROR_TEXTURE_PITCH,
      [=](Arguments& a) { tiled(a, tile); });
  add("tiles at a pitch that splits a tile", SELVAGE_ERROR_TEXTURE_PITCH,
      [=](Arguments& a) { tiled(a, 2 * tile + tile / 4); });
  add("tiles bottom row first", SELVAGE_ERROR_TEXTURE_PITCH,
      [=](Arguments& a) { tiled(a, -2 * tile); });
  add("tiles that start within a tile", SELVAGE_ERROR_TEXTURE_ALIGNMENT, [=](Arguments& a) {
    tiled(a, 2 * tile);
    a.texture.texels = static_cast<const char*>(a.texture.texels) + tile / 4;
  });
  if (claims.longest_side_texel < kTiled_texel) return;
  const bool exact = c.profile == SELVAGE_PROFILE_EXACT;
  add("tiles", exact ? SELVAGE_OK : SELVAGE_ERROR_LAYOUT_PROFILE,
      [=](Arguments& a) { tiled(a, 2 * tile); });
}

void share_memory(Calls* calls, const Case& c, const Capabilities& claims) {
  calls->push_back({"a texture whose last texel is the target's first pixel", SELVAGE_ERROR_OVERLAP,
                    [](Arguments& a) { start_before(a, 1); }});
  if (claims.longest_side_texel >= 2) {
    calls->push_back({"a texture that ends where the target begins", SELVAGE_OK,
                      [](Arguments& a) { start_before(a, 2); }});
  }
  if (c.target_height_px < 2 || c.target_width_px + c.padding_px < 2) return;
  const int32_t most = std::min(c.target_height_px - 1, claims.longest_side_texel);
  const auto rows = static_cast<int32_t>(std::bit_floor(static_cast<uint32_t>(most)));
  calls->push_back({"a texture in other columns of the target's bitmap", SELVAGE_OK,
                    [=](Arguments& a) { share_rows(a, 1, rows); }});
  calls->push_back({"a texture in the target's own columns of one bitmap", SELVAGE_ERROR_OVERLAP,
                    [=](Arguments& a) { share_rows(a, 0, rows); }});
}

}  // namespace selvage::spec
