#include "spec/hostile_calls.h"

#include <cstdint>
#include <cstdlib>
#include <limits>
#include <utility>

#include "spec/canvas.h"
#include "spec/profiles.h"

namespace selvage::spec {
namespace {

inline constexpr int32_t kInt32Min = std::numeric_limits<int32_t>::min();
inline constexpr int32_t kInt32Max = std::numeric_limits<int32_t>::max();

using Calls = std::vector<HostileCall>;

void spoil_options(Calls* calls) {
  for (const int32_t unknown : {-1, 4, 77, kInt32Min, kInt32Max}) {
    calls->push_back({"an unknown profile", SELVAGE_ERROR_PROFILE,
                      [=](Arguments& a) { a.options.profile = unknown; }});
    calls->push_back({"an unknown filter", SELVAGE_ERROR_FILTER,
                      [=](Arguments& a) { a.options.filter = unknown; }});
    calls->push_back({"an unknown address mode", SELVAGE_ERROR_ADDRESS,
                      [=](Arguments& a) { a.options.address = unknown; }});
  }
  for (const int32_t negative : {-1, kInt32Min}) {
    calls->push_back({"a negative tolerance", SELVAGE_ERROR_TOLERANCE,
                      [=](Arguments& a) { a.options.tolerance = negative; }});
  }
}

// Filters that mix texels: what has colours can be mixed, in the exact profile.
void choose_filters(Calls* calls, const Case& c, ValueSet claimed) {
  const selvage_status allowed = c.profile != SELVAGE_PROFILE_EXACT ? SELVAGE_ERROR_FILTER_PROFILE
                                 : c.format != SELVAGE_RGBA8888     ? SELVAGE_ERROR_FILTER_FORMAT
                                                                    : SELVAGE_OK;
  for (const selvage_filter filter :
       {SELVAGE_FILTER_FOUR, SELVAGE_FILTER_BILINEAR, SELVAGE_FILTER_AREA}) {
    calls->push_back({"filter " + std::to_string(filter),
                      holds(claimed, filter) ? allowed : SELVAGE_ERROR_FILTER,
                      [=](Arguments& a) { a.options.filter = filter; }});
  }
}

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

void spoil_pointers(Calls* calls, selvage_format format, const Capabilities& claims) {
  const auto add = [&](std::string what, selvage_status wanted, auto spoil) {
    calls->push_back({std::move(what), wanted, spoil});
  };
  add("no target", SELVAGE_ERROR_TARGET_NULL, [](Arguments& a) { a.target_pointer = nullptr; });
  add("no pixels", SELVAGE_ERROR_TARGET_NULL, [](Arguments& a) { a.target.pixels = nullptr; });
  add("no texture", SELVAGE_ERROR_TEXTURE_NULL, [](Arguments& a) { a.texture_pointer = nullptr; });
  add("no texels", SELVAGE_ERROR_TEXTURE_NULL, [](Arguments& a) { a.texture.texels = nullptr; });
  add("no vertices", SELVAGE_ERROR_VERTICES_NULL,
      [](Arguments& a) { a.vertices_pointer = nullptr; });
  for (const int32_t unknown : {-1, 2, kInt32Min, kInt32Max}) {
    add("an unknown layout", SELVAGE_ERROR_TEXTURE_LAYOUT,
        [=](Arguments& a) { a.texture.layout = unknown; });
  }
  add("a texture that is the target", SELVAGE_ERROR_OVERLAP, [](Arguments& a) {
    const auto& [pixels, width, height, pitch, image_format] = a.target;
    a.texture = {pixels, width, height, pitch, image_format, SELVAGE_LAYOUT_ROWS, nullptr};
  });
  add("vertices inside the target", SELVAGE_ERROR_OVERLAP, [](Arguments& a) {
    a.vertices_pointer = static_cast<const selvage_vertex*>(a.target.pixels);
  });
  // Which of two errors is named of a format that it does not draw is not claimed.
  const bool all_formats = claims.formats == Capabilities{}.formats;
  if (all_formats)
    add("formats that differ", SELVAGE_ERROR_FORMAT_MISMATCH, [](Arguments& a) {
      a.texture.format = a.texture.format == SELVAGE_INDEX8 ? SELVAGE_RGB565 : SELVAGE_INDEX8;
      a.texture.width = a.texture.height = 1;
      a.texture.pitch = 4;
      a.texture.texels = &a.options;  // aligned for every format
    });
  if (format == SELVAGE_INDEX8) return;
  add("misaligned pixels", SELVAGE_ERROR_TARGET_ALIGNMENT,
      [](Arguments& a) { a.target.pixels = static_cast<char*>(a.target.pixels) + 1; });
  add("misaligned texels", SELVAGE_ERROR_TEXTURE_ALIGNMENT,
      [](Arguments& a) { a.texture.texels = static_cast<const char*>(a.texture.texels) + 1; });
}

void spoil_vertices(Calls* calls, size_t index, const Capabilities& claims) {
  for (const size_t count : {size_t{0}, size_t{1}, size_t{2}}) {
    calls->push_back({"fewer than 3 vertices", SELVAGE_ERROR_VERTEX_COUNT,
                      [=](Arguments& a) { a.count = count; }});
  }
  for (const int32_t far : {SELVAGE_X_MIN - 1, int32_t{SELVAGE_X_END}, kInt32Min, kInt32Max}) {
    calls->push_back({"x out of range", SELVAGE_ERROR_VERTEX_POSITION,
                      [=](Arguments& a) { a.vertices[index].x = far; }});
    calls->push_back({"y out of range", SELVAGE_ERROR_VERTEX_POSITION,
                      [=](Arguments& a) { a.vertices[index].y = far; }});
  }
  for (const int32_t q : {0, -1, SELVAGE_Q_MAX + 1, kInt32Min, kInt32Max}) {
    calls->push_back(
        {"q out of range", SELVAGE_ERROR_VERTEX_Q, [=](Arguments& a) { a.vertices[index].q = q; }});
  }
  // Who takes triangles or convex outlines alone says nothing of others.
  if (!claims.concave || claims.most_vertices < 4) return;
  calls->push_back(
      {"an outline that goes down twice", SELVAGE_ERROR_NOT_MONOTONE, [](Arguments& a) {
         a.vertices = {
             {0, 0, 0, 0, 1}, {256, 512, 0, 0, 1}, {512, 256, 0, 0, 1}, {768, 512, 0, 0, 1}};
         a.vertices_pointer = a.vertices.data();
         a.count = a.vertices.size();
       }});
}

// What the historic profiles refuse and the exact one draws.
void spoil_wholeness(Calls* calls, size_t index) {
  for (const int32_t fraction : {1, 128, 255}) {
    calls->push_back({"x between pixels", SELVAGE_ERROR_VERTEX_FRACTION,
                      [=](Arguments& a) { a.vertices[index].x += fraction; }});
    calls->push_back({"y between pixels", SELVAGE_ERROR_VERTEX_FRACTION,
                      [=](Arguments& a) { a.vertices[index].y += fraction; }});
  }
  calls->push_back({"q that differ", SELVAGE_ERROR_VERTEX_Q_DIFFERS,
                    [=](Arguments& a) { a.vertices[index].q += 1; }});
}

// A texture of three texels that starts so many pixels before the target's first.
void start_before(Arguments& a, ptrdiff_t distance_px) {
  a.target.height = 1;
  a.target.pitch = std::abs(a.target.pitch);
  a.texture.width = 3;
  a.texture.height = 1;
  a.texture.pitch = 1024;
  a.texture.texels =
      static_cast<const char*>(a.target.pixels) - distance_px * bytes_per_pixel(a.target.format);
}

// Rows as given, said to be what they are not.
void spoil_preparation(Calls* calls, const Case& c) {
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
  const ptrdiff_t tile = 16 * bytes_per_pixel(c.format);
  const auto tiled = [=](Arguments& a, ptrdiff_t pitch) {
    alignas(64) static const char texels[16 * 4 * 4 * 4] = {};
    a.texture = {texels + 16 * 4, 8, 5, pitch, c.format, SELVAGE_LAYOUT_TILES, nullptr};
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
  const bool exact = c.profile == SELVAGE_PROFILE_EXACT;
  add("tiles", exact ? SELVAGE_OK : SELVAGE_ERROR_LAYOUT_PROFILE,
      [=](Arguments& a) { tiled(a, 2 * tile); });
}

void share_memory(Calls* calls) {
  calls->push_back({"a texture whose last texel is the target's first pixel", SELVAGE_ERROR_OVERLAP,
                    [](Arguments& a) { start_before(a, 2); }});
  calls->push_back({"a texture that ends where the target begins", SELVAGE_OK,
                    [](Arguments& a) { start_before(a, 3); }});
}

void leave_out(Calls* calls) {
  calls->push_back({"no options: all of them zero", SELVAGE_OK,
                    [](Arguments& a) { a.options_pointer = nullptr; }});
  calls->push_back(
      {"no clip: the whole target", SELVAGE_OK, [](Arguments& a) { a.clip_pointer = nullptr; }});
  for (const int32_t tolerance : {1, int32_t{SELVAGE_SUBTEXELS}, kInt32Max}) {
    calls->push_back(
        {"a tolerance", SELVAGE_OK, [=](Arguments& a) { a.options.tolerance = tolerance; }});
  }
}

}  // namespace

std::vector<HostileCall> hostile_calls(const Case& c, const Subject& subject) {
  std::vector<HostileCall> calls;
  spoil_options(&calls);
  choose_filters(&calls, c, subject.claims.filters);
  spoil_images(&calls, c.format);
  spoil_pointers(&calls, c.format, subject.claims);
  spoil_vertices(&calls, c.choice % 3, subject.claims);
  if (profile_of(c).whole_px) spoil_wholeness(&calls, c.choice % 3);
  if (subject.prepare) spoil_preparation(&calls, c);
  share_memory(&calls);
  leave_out(&calls);
  return calls;
}

HostileOutcome make(const Subject& subject, const Case& c, const HostileCall& call) {
  Canvas target(c.format, c.target_width_px, c.target_height_px, c.padding_px, c.flip_target, 0x5A);
  const Canvas texture(c.format, c.texture_width_texel, c.texture_height_texel, c.padding_px,
                       c.flip_texture, 0xEE);
  const Canvas before = target;
  Arguments a{.target = target.image(),
              .clip = {0, 0, c.target_width_px, c.target_height_px},
              .vertices = {{-256, -256, 0, 0, 1}, {4096, 0, 65536, 0, 2}, {0, 4096, 0, 65536, 3}},
              .texture = texture.texture(),
              .options = {c.profile, SELVAGE_FILTER_NEAREST, SELVAGE_ADDRESS_CLAMP, 0, 0},
              .target_pointer = &a.target,
              .vertices_pointer = nullptr,
              .texture_pointer = &a.texture,
              .clip_pointer = &a.clip,
              .options_pointer = &a.options,
              .count = 3};
  make_acceptable(profile_of(c), subject.claims, a.vertices);
  if (!subject.claims.perspective) {
    for (selvage_vertex& v : a.vertices) v.q = 1;
  }
  make_visible(profile_of(c), subject.claims, &a.vertices);
  if (!subject.claims.clip) a.clip_pointer = nullptr;
  a.vertices_pointer = a.vertices.data();
  call.spoil(a);
  try {
    const selvage_status status = subject.draw(a.target_pointer, a.clip_pointer, a.vertices_pointer,
                                               a.count, a.texture_pointer, a.options_pointer);
    return {status, target == before};
  } catch (SubjectFailure& failure) {
    failure.call = call.what;
    throw;
  }
}

}  // namespace selvage::spec
