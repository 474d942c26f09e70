#include "spec/hostile_calls.h"

#include <cstdint>
#include <limits>
#include <utility>

#include "spec/canvas.h"
#include "spec/hostile_images.h"
#include "spec/profiles.h"

namespace selvage::spec {
namespace {

void spoil_options(Calls* calls) {
  for (const int32_t unknown : {-1, 4, 77, kInt32Min, kInt32Max}) {
    calls->push_back({"an unknown profile", SELVAGE_ERROR_PROFILE,
                      [=](Arguments& a) { a.options.profile = unknown; }});
    calls->push_back({"an unknown filter", SELVAGE_ERROR_FILTER,
                      [=](Arguments& a) { a.options.filter = unknown; }});
    calls->push_back({"an unknown address mode", SELVAGE_ERROR_ADDRESS,
                      [=](Arguments& a) { a.options.address = unknown; }});
  }
  for (const int32_t unknown : {-1, SELVAGE_KERNEL_NEON + 1, 77, kInt32Min, kInt32Max}) {
    calls->push_back({"an unknown kernel", SELVAGE_ERROR_KERNEL,
                      [=](Arguments& a) { a.options.kernel = unknown; }});
  }
  for (const int32_t negative : {-1, kInt32Min}) {
    calls->push_back({"a negative tolerance", SELVAGE_ERROR_TOLERANCE,
                      [=](Arguments& a) { a.options.tolerance = negative; }});
  }
}

struct NamedFilter {
  selvage_filter filter;
  const char* name;
};
inline constexpr NamedFilter kMixing[] = {{SELVAGE_FILTER_FOUR, "four"},
                                          {SELVAGE_FILTER_BILINEAR, "bilinear"},
                                          {SELVAGE_FILTER_AREA, "area"}};

// Filters that mix texels: what has colours can be mixed, in the exact profile.
void choose_filters(Calls* calls, const Case& c, ValueSet claimed) {
  const selvage_status allowed = c.profile != SELVAGE_PROFILE_EXACT ? SELVAGE_ERROR_FILTER_PROFILE
                                 : c.format != SELVAGE_RGBA8888     ? SELVAGE_ERROR_FILTER_FORMAT
                                                                    : SELVAGE_OK;
  for (const auto& [filter, name] : kMixing) {
    const bool is_claimed = holds(claimed, filter);
    calls->push_back({std::string("filter ") + name +
                          (is_claimed ? ", which it does not say that it lacks"
                                      : ", which it does not claim to have"),
                      is_claimed ? allowed : SELVAGE_ERROR_FILTER,
                      [=](Arguments& a) { a.options.filter = filter; }});
  }
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

void leave_out(Calls* calls, const Case& c, const Capabilities& claims) {
  // Zeros are the exact profile and clamp.
  if (c.profile == SELVAGE_PROFILE_EXACT && holds(claims.addresses, SELVAGE_ADDRESS_CLAMP)) {
    calls->push_back({"no options: all of them zero", SELVAGE_OK,
                      [](Arguments& a) { a.options_pointer = nullptr; }});
  }
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
  if (subject.prepare) spoil_preparation(&calls, c, subject.claims);
  share_memory(&calls, c, subject.claims);
  leave_out(&calls, c, subject.claims);
  return calls;
}

Case good_drawing(const Subject& subject, const Case& c) {
  Case good = c;
  good.filter = SELVAGE_FILTER_NEAREST;
  good.layout = Layout::kGiven;
  good.has_clip = subject.claims.clip;
  good.clip = {0, 0, c.target_width_px, c.target_height_px};
  good.vertices = {{-256, -256, 0, 0, 1}, {4096, 0, 65536, 0, 2}, {0, 4096, 0, 65536, 3}};
  make_acceptable(profile_of(c), subject.claims, good.vertices);
  if (!subject.claims.perspective) {
    for (selvage_vertex& v : good.vertices) v.q = 1;
  }
  make_visible(profile_of(c), subject.claims, &good.vertices);
  return good;
}

HostileOutcome make(const Subject& subject, const Case& good, const HostileCall& call) {
  Canvas target(good.format, good.target_width_px, good.target_height_px, good.padding_px,
                good.flip_target, 0x5A);
  const Canvas texture(good.format, good.texture_width_texel, good.texture_height_texel,
                       good.padding_px, good.flip_texture, 0xEE);
  const Canvas before = target;
  Arguments a{.target = target.image(),
              .clip = good.clip,
              .vertices = good.vertices,
              .texture = texture.texture(),
              .options = {good.profile, good.filter, good.address, 0, SELVAGE_KERNEL_FASTEST},
              .target_pointer = &a.target,
              .vertices_pointer = nullptr,
              .texture_pointer = &a.texture,
              .clip_pointer = good.has_clip ? &a.clip : nullptr,
              .options_pointer = &a.options,
              .count = good.vertices.size()};
  a.vertices_pointer = a.vertices.data();
  call.spoil(a);
  try {
    const selvage_status status = subject.draw(a.target_pointer, a.clip_pointer, a.vertices_pointer,
                                               a.count, a.texture_pointer, a.options_pointer);
    return {status, target == before};
  } catch (SubjectFailure& failure) {
    failure.call = call.what;
    if (!failure.shown) failure.shown = good;
    throw;
  }
}

}  // namespace selvage::spec
