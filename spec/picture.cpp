#include "spec/picture.h"

#include <array>
#include <cstring>
#include <utility>

#include "spec/canvas.h"
#include "spec/drawings.h"
#include "spec/model.h"
#include "spec/refusal.h"
#include "spec/texture_memory.h"

namespace selvage::spec {
namespace {

// Complementary, so that no value a subject may write equals both, or comes from outside the
// texture both times.
inline constexpr std::array<uint8_t, 2> kBackgrounds = {0x5A, 0xA5};
inline constexpr std::array<uint8_t, 2> kOutsideTexture = {0xEE, 0x11};

template <class T>
[[nodiscard]] std::vector<uint8_t> bytes_of(const T& value) {
  std::vector<uint8_t> bytes(sizeof value);
  std::memcpy(bytes.data(), &value, sizeof value);
  return bytes;
}

[[nodiscard]] Canvas canvas_of(const Case& c, uint8_t background) {
  return {c.format, c.target_width_px, c.target_height_px, c.padding_px, c.flip_target, background};
}

// One drawing over one background; notes in *fault what no mapper may touch and this one did.
[[nodiscard]] selvage_status draw_over(const Subject& subject, const Case& c,
                                       const TextureMemory& texture, Canvas& canvas,
                                       std::string* fault) {
  if (!texture.fault().empty()) *fault = texture.fault();
  if (texture.status() != SELVAGE_OK) return texture.status();
  const TextureMemory::Bytes texture_before = texture.bytes();
  std::vector<selvage_vertex> vertices = c.vertices;
  vertices.reserve(1);  // no vertices are not NULL vertices
  const selvage_image image = canvas.image();
  const selvage_texture view = texture.view();
  const selvage_options options{c.profile, c.filter, c.address, /*tolerance=*/0,
                                SELVAGE_KERNEL_FASTEST};
  const selvage_rect clip = c.clip;
  const auto arguments = [&] {
    return std::vector{bytes_of(image), bytes_of(view), bytes_of(options), bytes_of(clip)};
  };
  const auto arguments_before = arguments();

  const selvage_status status = subject.draw(&image, c.has_clip ? &clip : nullptr, vertices.data(),
                                             vertices.size(), &view, &options);

  if (!canvas.guards_are_intact()) *fault = "a byte outside the target's pixels was written";
  if (!(texture.bytes() == texture_before)) *fault = "the texture was written";
  const bool vertices_changed =
      !vertices.empty() && std::memcmp(vertices.data(), c.vertices.data(),
                                       vertices.size() * sizeof(selvage_vertex)) != 0;
  if (vertices_changed || arguments() != arguments_before) *fault = "an argument was written";
  return status;
}

// What was drawn over the two backgrounds, pixel by pixel.
void read_pixels(const Case& c, const std::array<Canvas, 2>& canvases, Picture* picture) {
  const Canvas untouched[] = {Canvas(c.format, 1, 1, 0, false, kBackgrounds[0]),
                              Canvas(c.format, 1, 1, 0, false, kBackgrounds[1])};
  size_t index = 0;
  for (int32_t y = 0; y < c.target_height_px; ++y) {
    for (int32_t x = 0; x < c.target_width_px; ++x, ++index) {
      const uint32_t a = canvases[0].pixel(x, y), b = canvases[1].pixel(x, y);
      if (a == untouched[0].pixel(0, 0) && b == untouched[1].pixel(0, 0)) continue;
      picture->pixels[index] = a;
      if (a != b) {
        picture->memory_fault =
            "a pixel depends on the target's past, on memory beside the texture or on where they "
            "lie";
      }
    }
  }
}

[[nodiscard]] bool is_clipped(const Case& c, int32_t x_px, int32_t y_px) {
  return c.has_clip &&
         (x_px < c.clip.left || c.clip.right <= x_px || y_px < c.clip.top || c.clip.bottom <= y_px);
}

[[nodiscard]] Picture blank(const Case& c) {
  Picture picture{.width_px = c.target_width_px, .height_px = c.target_height_px};
  picture.pixels.resize(static_cast<size_t>(c.target_width_px) *
                        static_cast<size_t>(c.target_height_px));
  return picture;
}

// The answers of the drawings over the two backgrounds.
using Answers = std::array<selvage_status, 2>;

// Does the one, and then the other, whether or not a call has failed.
template <class First, class Then>
void whatever_fails(First first, Then then) {
  try {
    first();
  } catch (const SubjectFailure&) {
    then();
    throw;
  }
  then();
}

// Where a call fails, what was drawn until then is in *picture.
[[nodiscard]] Answers draw_twice(const Subject& subject, const Case& c, const TexelAt& texel_at,
                                 Picture* picture) {
  Answers answers{};
  *picture = blank(c);
  std::array<Canvas, 2> canvases = {canvas_of(c, kBackgrounds[0]), canvas_of(c, kBackgrounds[1])};
  const auto draw_with = [&](size_t i) {
    return with_shown(c, [&] {
      const TextureMemory texture(subject, c, texel_at, kOutsideTexture[i]);
      return draw_over(subject, c, texture, canvases[i], &picture->memory_fault);
    });
  };
  whatever_fails(
      [&] {
        for (size_t i = 0; i < canvases.size(); ++i) answers[i] = draw_with(i);
      },
      [&] { read_pixels(c, canvases, picture); });
  picture->status = answers.front();
  if (answers.back() != picture->status) {
    picture->memory_fault = "the status depends on the target";
  }
  return answers;
}

// The first digit makes the picture, the others are added to its pixels.
void add_digit(const Case& c, int digit, const Picture& drawn, Picture* whole) {
  if (digit == 0) *whole = drawn;
  if (!drawn.memory_fault.empty()) whole->memory_fault = drawn.memory_fault;
  if (drawn.status != whole->status) whole->memory_fault = "the status depends on the texels";
  for (size_t i = 0; i < whole->pixels.size(); ++i) {
    std::optional<uint32_t>& pixel = whole->pixels[i];
    if (pixel.has_value() != drawn.pixels[i].has_value()) {
      whole->memory_fault = "whether a pixel is drawn depends on the texels";
      pixel.reset();
    }
    if (!pixel) continue;
    const uint32_t part = coordinate_part(c.format, digit, *drawn.pixels[i]);
    pixel = digit == 0 ? part : *pixel | part;
  }
}

[[nodiscard]] Answers draw_digits(const Subject& subject, const Case& c, Picture* whole) {
  Answers answers{};
  for (int digit = 0; digit < digits(c); ++digit) {
    Picture drawn;
    whatever_fails(
        [&] { answers = draw_twice(subject, c, digit_texture(c.format, digit), &drawn); },
        [&] { add_digit(c, digit, drawn, whole); });
    if (answers != Answers{}) break;
  }
  return answers;
}

// Notes the picture that `draw` fills in, as one of the texture `texel_at`.
template <class Draw>
[[nodiscard]] Picture noted(const Subject& subject, const Case& c, const TexelAt& texel_at,
                            Draw draw) {
  demand_claimed(subject, c);
  Picture picture = blank(c);
  whatever_fails([&] { draw(&picture); },
                 [&] {
                   if (subject.noted_in != nullptr) subject.noted_in->note(c, texel_at, picture);
                 });
  return picture;
}

[[nodiscard]] Picture draw_coordinates(const Subject& subject, const Case& c, Answers* answers) {
  return noted(subject, c, coordinate_texture(),
               [&](Picture* picture) { *answers = draw_digits(subject, c, picture); });
}

[[nodiscard]] Picture draw_texture(const Subject& subject, const Case& c, const TexelAt& texel_at,
                                   Answers* answers) {
  return noted(subject, c, texel_at,
               [&](Picture* picture) { *answers = draw_twice(subject, c, texel_at, picture); });
}

[[nodiscard]] Picture demanded(const Case& c, const Answers& answers, Picture picture) {
  for (const selvage_status answer : answers) demand_drawn(answer, c);
  return picture;
}

}  // namespace

void demand_drawn(selvage_status status, const Case& c) {
  if (status != SELVAGE_OK && is_valid(c)) throw Refusal{status, c};
}

Picture draw(const Subject& subject, const Case& c) {
  Answers answers{};
  Picture picture = draw_coordinates(subject, c, &answers);
  return demanded(c, answers, std::move(picture));
}

Picture draw(const Subject& subject, const Case& c, const TexelAt& texel_at) {
  Answers answers{};
  Picture picture = draw_texture(subject, c, texel_at, &answers);
  return demanded(c, answers, std::move(picture));
}

Picture draw_whatever_answered(const Subject& subject, const Case& c) {
  Answers answers{};
  return draw_coordinates(subject, c, &answers);
}

Picture draw_whatever_answered(const Subject& subject, const Case& c, const TexelAt& texel_at) {
  Answers answers{};
  return draw_texture(subject, c, texel_at, &answers);
}

Weights filter_weights(const Case& c, int32_t x_px, int32_t y_px, const Sample& point) {
  const BoxSides sides = c.filter == SELVAGE_FILTER_AREA
                             ? box_sides(gradient(c.vertices, x_px, y_px).value())
                             : BoxSides{};
  return {
      addressed(taps(c.filter, point.u, sides.u_fx8), c.texture_width_texel, c.address),
      addressed(taps(c.filter, point.v, sides.v_fx8), c.texture_height_texel, c.address),
  };
}

namespace {

[[nodiscard]] std::optional<uint32_t> pixel_of(const Case& c, const ModelRow& row, int32_t x,
                                               int32_t y, const TexelAt& texel_at) {
  if (is_clipped(c, x, y)) return std::nullopt;
  const std::optional<Texel> texel = row.texel(x);
  if (!texel) return std::nullopt;
  if (c.filter == SELVAGE_FILTER_NEAREST) {
    return texel_at({address_texel(texel->s, c.texture_width_texel, c.address),
                     address_texel(texel->t, c.texture_height_texel, c.address)});
  }
  const auto [columns, rows] = filter_weights(c, x, y, *row.coordinates(x));
  return weighted_mean(columns, rows, texel_at);
}

}  // namespace

Picture expected(const Case& c) { return expected(c, coordinate_texture()); }

Picture expected(const Case& c, const TexelAt& texel_at) {
  Picture picture = blank(c);
  picture.status = validity(c);
  if (picture.status != SELVAGE_OK) return picture;
  size_t index = 0;
  for (int32_t y = 0; y < c.target_height_px; ++y) {
    const ModelRow row(c, y);
    for (int32_t x = 0; x < c.target_width_px; ++x, ++index) {
      picture.pixels[index] = pixel_of(c, row, x, y, texel_at);
    }
  }
  return picture;
}

std::optional<uint32_t> expected_pixel(const Case& c, int32_t x_px, int32_t y_px) {
  return pixel_of(c, ModelRow(c, y_px), x_px, y_px, coordinate_texture());
}

}  // namespace selvage::spec
