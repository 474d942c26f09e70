#include "reports/scenes/judge.h"

#include <algorithm>
#include <cstdio>
#include <cstring>

#include "scene/paints.h"

namespace selvage::reports {
namespace {

using spec::Rational;

[[nodiscard]] std::string show(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

[[nodiscard]] uint32_t value_of(const cli::Raster& raster, int32_t x_px, int32_t y_px) {
  uint32_t value = 0;
  const size_t at =
      static_cast<size_t>(y_px) * static_cast<size_t>(raster.width_px) + static_cast<size_t>(x_px);
  std::memcpy(&value, raster.rgba.data() + at * sizeof value, sizeof value);
  return value;
}

[[nodiscard]] uint32_t value_of(const scene::Colour& colour) {
  uint32_t value = 0;
  const uint8_t bytes[] = {colour.red, colour.green, colour.blue, colour.alpha};
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

[[nodiscard]] double larger(const Rational& a, const Rational& b) {
  return std::max(Rational(abs(a)).get_d(), Rational(abs(b)).get_d());
}

// One scene, drawn by one plan.
class Judge {
 public:
  Judge(const scene::Scene& scene, const scene::Drawing& drawing, const ExactView& exact,
        const RowChoices& choices, const Drawn& drawn)
      : drawing_(drawing),
        exact_(exact),
        choices_(choices),
        drawn_(drawn),
        background_(value_of(scene.background)),
        paints_(scene) {
    for (size_t i = 0; i < drawing.view.faces.size(); ++i)
      vertices_.push_back(vertices_to_draw(drawing.view.faces[i], drawing.plans[i]));
  }

  [[nodiscard]] JudgedPixel pixel(int32_t x_px, int32_t y_px) {
    const ExactPixel& exact = exact_.pixel(x_px, y_px);
    JudgedPixel judged;
    judged.x_px = x_px;
    judged.y_px = y_px;
    if (exact.face) {
      const RowChoice& choice = choices_.at(*exact.face, y_px);
      judged.choice = choice.choice;
      judged.bound_texel = choice.bound_texel;
    }
    const bool textured = exact.at.has_value();
    const bool nearest =
        textured && drawing_.plans[*exact.face].options.filter == SELVAGE_FILTER_NEAREST;
    const uint32_t place =
        drawn_.places[static_cast<size_t>(y_px) * static_cast<size_t>(exact_.size.width_px) +
                      static_cast<size_t>(x_px)];
    judged.right_surface = nearest == (place != kNoPlace);
    if (!judged.right_surface) return judged;
    if (!textured)
      plain(exact, judged);
    else if (nearest)
      by_place(exact, place, judged);
    else
      by_filter(exact, judged);
    return judged;
  }

 private:
  void plain(const ExactPixel& exact, JudgedPixel& judged) const {
    const uint32_t due =
        exact.face ? value_of(drawing_.view.faces[*exact.face].paint.colour) : background_;
    judged.right_colour = value_of(drawn_.picture, judged.x_px, judged.y_px) == due;
  }

  void by_place(const ExactPixel& exact, uint32_t place, JudgedPixel& judged) {
    const selvage_texture texture = texture_of(exact);
    const selvage_address address = drawing_.plans[*exact.face].options.address;
    const spec::Texel texel{static_cast<int32_t>(place & 0xFFFF),
                            static_cast<int32_t>(place >> 16)};
    judged.wrong_texel =
        texel != spec::nearest_texel(*exact.at, texture.width, texture.height, address);
    judged.measured_texel = std::max(distance_texel(exact.at->u, texel.s, texture.width, address),
                                     distance_texel(exact.at->v, texel.t, texture.height, address));
    judged.right_colour =
        value_of(drawn_.picture, judged.x_px, judged.y_px) == texel_of(texture, texel);
  }

  void by_filter(const ExactPixel& exact, JudgedPixel& judged) {
    const scene::Plan& plan = drawing_.plans[*exact.face];
    const std::vector<selvage_vertex>& vertices = vertices_[*exact.face];
    const spec::Sample at =
        plan.affine ? spec::sample(vertices, judged.x_px, judged.y_px).value() : *exact.at;
    judged.measured_texel = larger(at.u - exact.at->u, at.v - exact.at->v);
    judged.right_colour =
        value_of(drawn_.picture, judged.x_px, judged.y_px) ==
        model_colour(vertices, at, judged.x_px, judged.y_px, texture_of(exact), plan.options);
  }

  [[nodiscard]] selvage_texture texture_of(const ExactPixel& exact) {
    return paints_.texture(drawing_.view.faces[*exact.face].paint);
  }

  const scene::Drawing& drawing_;
  const ExactView& exact_;
  const RowChoices& choices_;
  const Drawn& drawn_;
  uint32_t background_;
  scene::Paints paints_;
  std::vector<std::vector<selvage_vertex>> vertices_;  // as drawn, of each face
};

// A texture whose texels are their own places.
[[nodiscard]] std::vector<uint32_t> places(const scene::TextureImage& image) {
  std::vector<uint32_t> texels;
  for (int32_t t = 0; t < image.height_texel; ++t) {
    for (int32_t s = 0; s < image.width_texel; ++s)
      texels.push_back(static_cast<uint32_t>(t) << 16 | static_cast<uint32_t>(s));
  }
  return texels;
}

}  // namespace

double distance_texel(const Rational& u, int32_t texel, int32_t size_texel,
                      selvage_address address) {
  Rational from = u - texel;  // in [0, 1) where the texel is right
  if (address == SELVAGE_ADDRESS_WRAP) {
    const Rational turns = (from + size_texel / 2) / size_texel;
    from -= Rational(spec::floor(turns)) * size_texel;
  } else if ((u < 0 && texel == 0) || (u >= size_texel && texel == size_texel - 1)) {
    return 0;
  }
  return std::max({0.0, Rational(-from).get_d(), Rational(from - 1).get_d()});
}

std::optional<std::string> breach(const JudgedPixel& p) {
  const std::string here = "pixel (" + std::to_string(p.x_px) + ", " + std::to_string(p.y_px) +
                           "), " + std::string(style_of(p.choice).id) + ": ";
  if (!p.right_surface) return here + "the texture drawn is not that of the face that shows there";
  if (!p.right_colour) return here + "the colour is not that of what it was drawn by";
  if (!(p.measured_texel <= p.bound_texel)) {
    return here + "measured " + show(p.measured_texel) + " texel is above the bound, " +
           show(p.bound_texel) + " texel";
  }
  if (!(p.bound_texel <= p.tolerance_texel)) {
    return here + "the bound, " + show(p.bound_texel) + " texel, is above the tolerance, " +
           show(p.tolerance_texel) + " texel";
  }
  if (p.bound_texel == 0 && p.wrong_texel)
    return here + "a texel beside the exact one, where the bound is 0";
  return std::nullopt;
}

Drawn draw_both(const scene::Scene& scene, const scene::Drawing& drawing, const scene::Size& size) {
  const ptrdiff_t pitch = static_cast<ptrdiff_t>(size.width_px) * 4;
  Drawn drawn{cli::filled(size.width_px, size.height_px, {}), {}};
  const selvage_image image{drawn.picture.rgba.data(), size.width_px, size.height_px, pitch,
                            SELVAGE_RGBA8888};
  selvage_status status = scene::draw(scene, drawing, image);
  drawn.places.assign(drawn.picture.rgba.size() / 4, kNoPlace);
  const selvage_image of_places{drawn.places.data(), size.width_px, size.height_px, pitch,
                                SELVAGE_RGBA8888};
  std::vector<std::vector<uint32_t>> textures;
  for (const scene::TextureImage& texture : scene.textures) textures.push_back(places(texture));
  for (const scene::Piece& piece : drawing.pieces) {
    const scene::ScreenFace& face = drawing.view.faces[piece.face];
    const scene::Plan& plan = drawing.plans[piece.face];
    if (!face.paint.texture || plan.options.filter != SELVAGE_FILTER_NEAREST) continue;
    const scene::TextureImage& of = scene.textures[*face.paint.texture];
    const selvage_texture texture{textures[*face.paint.texture].data(),
                                  of.width_texel,
                                  of.height_texel,
                                  static_cast<ptrdiff_t>(of.width_texel) * 4,
                                  SELVAGE_RGBA8888,
                                  SELVAGE_LAYOUT_ROWS,
                                  nullptr};
    const std::vector<selvage_vertex> vertices = vertices_to_draw(face, plan);
    if (status == SELVAGE_OK)
      status = selvage_draw(&of_places, &piece.clip, vertices.data(), vertices.size(), &texture,
                            &plan.options);
  }
  if (status != SELVAGE_OK) throw std::runtime_error(selvage_status_text(status));
  return drawn;
}

Verdict judge(const scene::Scene& scene, const scene::Drawing& drawing, const ExactView& exact,
              const RowChoices& choices, const Drawn& drawn, double tolerance_texel) {
  Verdict verdict;
  Judge judge(scene, drawing, exact, choices, drawn);
  for (int32_t y_px = 0; y_px < exact.size.height_px; ++y_px) {
    for (int32_t x_px = 0; x_px < exact.size.width_px; ++x_px) {
      JudgedPixel pixel = judge.pixel(x_px, y_px);
      pixel.tolerance_texel = tolerance_texel;
      const ExactPixel& due = exact.pixel(x_px, y_px);
      if (due.face) ++verdict.choice_px[static_cast<size_t>(pixel.choice)];
      verdict.textured_px += due.at.has_value();
      verdict.wrong_texels += pixel.wrong_texel;
      verdict.sum_texel += pixel.measured_texel;
      verdict.largest_texel = std::max(verdict.largest_texel, pixel.measured_texel);
      verdict.bound_texel = std::max(verdict.bound_texel, pixel.bound_texel);
      const std::optional<std::string> broken = breach(pixel);
      if (broken && verdict.breaches++ == 0) verdict.first_breach = *broken;
    }
  }
  return verdict;
}

}  // namespace selvage::reports
