#include <sstream>

#include "spec/case.h"
#include "spec/profiles.h"

namespace selvage::spec {
namespace {

// value / 2^fraction_bits in decimal, exactly: a binary fraction always ends.
[[nodiscard]] std::string decimal(int64_t value, int fraction_bits) {
  const int64_t one = int64_t{1} << fraction_bits;
  const int64_t magnitude = value < 0 ? -value : value;
  std::string text = value < 0 ? "-" : "";
  text += std::to_string(magnitude / one);
  int64_t rest = magnitude % one;
  if (rest != 0) text += '.';
  for (; rest != 0; rest %= one) {
    rest *= 10;
    text += static_cast<char>('0' + rest / one);
  }
  return text;
}

[[nodiscard]] std::string pixels(int32_t position_fx8) { return decimal(position_fx8, 8); }
[[nodiscard]] std::string texels(int32_t coordinate_fx16) { return decimal(coordinate_fx16, 16); }

[[nodiscard]] const char* format_name(selvage_format format) {
  switch (format) {
    case SELVAGE_INDEX8:
      return "INDEX8";
    case SELVAGE_RGB565:
      return "RGB565";
    case SELVAGE_RGBA8888:
      return "RGBA8888";
    default:
      return "unknown format";
  }
}

[[nodiscard]] const char* filter_name(selvage_filter filter) {
  switch (filter) {
    case SELVAGE_FILTER_FOUR:
      return "four, ";
    case SELVAGE_FILTER_BILINEAR:
      return "bilinear, ";
    case SELVAGE_FILTER_AREA:
      return "area, ";
    default:
      return "";  // nearest goes without saying
  }
}

[[nodiscard]] const char* layout_name(Layout layout) {
  switch (layout) {
    case Layout::kPadded:
      return ", prepared in rows";
    case Layout::kTiled:
      return ", prepared in tiles";
    default:
      return "";
  }
}

void print_image(std::ostream& out, const Case& c, bool flipped) {
  if (c.padding_px > 0) out << ", padding " << c.padding_px << " px a row";
  if (flipped) out << ", bottom row first (negative pitch)";
}

}  // namespace

std::string print(const Case& c) {
  std::ostringstream out;
  out << profile_of(c).name << ", " << format_name(c.format) << ", " << filter_name(c.filter)
      << (c.address == SELVAGE_ADDRESS_WRAP ? "wrap" : "clamp") << ", choice " << c.choice << '\n';
  out << "target   " << c.target_width_px << " x " << c.target_height_px << " px";
  print_image(out, c, c.flip_target);
  out << '\n';
  out << "texture  " << c.texture_width_texel << " x " << c.texture_height_texel << " texels";
  print_image(out, c, c.flip_texture);
  out << layout_name(c.layout) << '\n';
  if (c.has_clip) {
    out << "clip     columns [" << c.clip.left << ", " << c.clip.right << "), rows [" << c.clip.top
        << ", " << c.clip.bottom << ")\n";
  }
  out << c.vertices.size() << (c.vertices.size() == 1 ? " vertex" : " vertices")
      << ": (x, y) px, (u, v) texels, q\n";
  for (const selvage_vertex& vertex : c.vertices) {
    out << "  (" << pixels(vertex.x) << ", " << pixels(vertex.y) << "), (" << texels(vertex.u)
        << ", " << texels(vertex.v) << "), " << vertex.q << '\n';
  }
  return out.str();
}

}  // namespace selvage::spec
