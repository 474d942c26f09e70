#include "spec/picture.h"

#include <array>
#include <cstring>

#include "spec/canvas.h"
#include "spec/model.h"

namespace selvage::spec {
namespace {

// Complementary, so that no value a subject may write equals both, or comes from outside the
// texture both times.
inline constexpr std::array<uint8_t, 2> kBackgrounds = {0x5A, 0xA5};
inline constexpr std::array<uint8_t, 2> kOutsideTexture = {0xEE, 0x11};

// How many bits of s and of t a format's coordinate texel holds.
[[nodiscard]] int coordinate_bits(selvage_format format) {
  return format == SELVAGE_INDEX8 ? 4 : format == SELVAGE_RGB565 ? 8 : 16;
}

[[nodiscard]] Canvas coordinate_texture(const Case& c, uint8_t outside) {
  Canvas texture(c.format, c.texture_width_texel, c.texture_height_texel, c.padding_px,
                 c.flip_texture, outside);
  for (int32_t t = 0; t < c.texture_height_texel; ++t) {
    for (int32_t s = 0; s < c.texture_width_texel; ++s) {
      texture.set_pixel(s, t, coordinate_texel(c.format, s, t));
    }
  }
  return texture;
}

struct Drawn {
  Canvas canvas;
  selvage_status status;
};

template <class T>
[[nodiscard]] std::vector<uint8_t> bytes_of(const T& value) {
  std::vector<uint8_t> bytes(sizeof value);
  std::memcpy(bytes.data(), &value, sizeof value);
  return bytes;
}

// One drawing over one background; notes in *fault what no mapper may touch and this one did.
[[nodiscard]] Drawn draw_over(const Subject& subject, const Case& c, const Canvas& texture,
                              uint8_t background, std::string* fault) {
  Canvas canvas(c.format, c.target_width_px, c.target_height_px, c.padding_px, c.flip_target,
                background);
  const Canvas texture_before = texture;
  std::vector<selvage_vertex> vertices = c.vertices;
  vertices.reserve(1);  // no vertices are not NULL vertices
  const selvage_image image = canvas.image();
  const selvage_texture view = texture.texture();
  const selvage_options options{c.profile, SELVAGE_FILTER_NEAREST, c.address,
                                /*tolerance=*/0, SELVAGE_KERNEL_FASTEST};
  const selvage_rect clip = c.clip;
  const auto arguments = [&] {
    return std::vector{bytes_of(image), bytes_of(view), bytes_of(options), bytes_of(clip)};
  };
  const auto arguments_before = arguments();

  const selvage_status status = subject.draw(&image, c.has_clip ? &clip : nullptr, vertices.data(),
                                             vertices.size(), &view, &options);

  if (!canvas.guards_are_intact()) *fault = "a byte outside the target's pixels was written";
  if (!(texture == texture_before)) *fault = "the texture was written";
  const bool vertices_changed =
      !vertices.empty() && std::memcmp(vertices.data(), c.vertices.data(),
                                       vertices.size() * sizeof(selvage_vertex)) != 0;
  if (vertices_changed || arguments() != arguments_before) *fault = "an argument was written";
  return {std::move(canvas), status};
}

[[nodiscard]] Picture blank(const Case& c) {
  Picture picture{.width_px = c.target_width_px, .height_px = c.target_height_px};
  picture.pixels.resize(static_cast<size_t>(c.target_width_px) *
                        static_cast<size_t>(c.target_height_px));
  return picture;
}

}  // namespace

uint32_t coordinate_texel(selvage_format format, int32_t s, int32_t t) {
  const int bits = coordinate_bits(format);
  const uint32_t mask = (1U << bits) - 1;
  return (static_cast<uint32_t>(s) & mask) | (static_cast<uint32_t>(t) & mask) << bits;
}

int32_t texel_mask(selvage_format format) { return (1 << coordinate_bits(format)) - 1; }

Texel texel_bits(selvage_format format, uint32_t value) {
  const auto mask = static_cast<uint32_t>(texel_mask(format));
  return {static_cast<int32_t>(value & mask),
          static_cast<int32_t>(value >> coordinate_bits(format) & mask)};
}

uint32_t addressed_value(const Case& c, Texel texel) {
  return coordinate_texel(c.format, address_texel(texel.s, c.texture_width_texel, c.address),
                          address_texel(texel.t, c.texture_height_texel, c.address));
}

std::string describe_texel(selvage_format format, uint32_t value) {
  const int bits = coordinate_bits(format);
  const uint32_t mask = (1U << bits) - 1;
  return "texel (" + std::to_string(value & mask) + ", " + std::to_string(value >> bits & mask) +
         ")" + (bits == 16 ? "" : " mod " + std::to_string(mask + 1));
}

Picture draw(const Subject& subject, const Case& c) {
  Picture picture = blank(c);
  const Drawn first = draw_over(subject, c, coordinate_texture(c, kOutsideTexture[0]),
                                kBackgrounds[0], &picture.memory_fault);
  const Drawn second = draw_over(subject, c, coordinate_texture(c, kOutsideTexture[1]),
                                 kBackgrounds[1], &picture.memory_fault);
  picture.status = first.status;
  if (second.status != first.status) picture.memory_fault = "the status depends on the target";

  const Canvas untouched[] = {Canvas(c.format, 1, 1, 0, false, kBackgrounds[0]),
                              Canvas(c.format, 1, 1, 0, false, kBackgrounds[1])};
  size_t index = 0;
  for (int32_t y = 0; y < c.target_height_px; ++y) {
    for (int32_t x = 0; x < c.target_width_px; ++x, ++index) {
      const uint32_t a = first.canvas.pixel(x, y), b = second.canvas.pixel(x, y);
      if (a == untouched[0].pixel(0, 0) && b == untouched[1].pixel(0, 0)) continue;
      picture.pixels[index] = a;
      if (a != b) {
        picture.memory_fault =
            "a pixel depends on the target's past or on memory beside the texture";
      }
    }
  }
  return picture;
}

Picture expected(const Case& c) {
  Picture picture = blank(c);
  picture.status = validity(c);
  if (picture.status != SELVAGE_OK) return picture;
  size_t index = 0;
  for (int32_t y = 0; y < c.target_height_px; ++y) {
    const ModelRow row(c, y);
    for (int32_t x = 0; x < c.target_width_px; ++x, ++index) {
      const bool clipped = c.has_clip && (x < c.clip.left || c.clip.right <= x || y < c.clip.top ||
                                          c.clip.bottom <= y);
      const std::optional<Texel> texel = clipped ? std::nullopt : row.texel(x);
      if (texel) picture.pixels[index] = addressed_value(c, *texel);
    }
  }
  return picture;
}

}  // namespace selvage::spec
