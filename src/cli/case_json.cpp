#include "cli/case_json.h"

#include <array>
#include <cstddef>

#include "spec/profiles.h"

namespace selvage::cli {
namespace {

using nlohmann::ordered_json;

// By value, in the order of selvage.h and spec/case.h.
constexpr std::array kFormatNames = {"index8", "rgb565", "rgba8888"};
constexpr std::array kFilterNames = {"nearest", "four", "bilinear", "area"};
constexpr std::array kAddressNames = {"clamp", "wrap"};
constexpr std::array kLayoutNames = {"given", "rows", "tiles"};

template <class Names, class Value>
[[nodiscard]] const char* name_of(const Names& names, Value value) {
  return names.at(static_cast<size_t>(value));
}

[[nodiscard]] ordered_json image_json(int32_t width, int32_t height, bool flipped,
                                      int32_t padding) {
  return {{"width", width}, {"height", height}, {"padding", padding}, {"bottom_first", flipped}};
}

}  // namespace

ordered_json case_json(const spec::Case& c) {
  ordered_json values = {
      {"profile", spec::profile_of(c).name},       {"format", name_of(kFormatNames, c.format)},
      {"filter", name_of(kFilterNames, c.filter)}, {"address", name_of(kAddressNames, c.address)},
      {"layout", name_of(kLayoutNames, c.layout)}, {"choice", c.choice}};
  values["target_px"] =
      image_json(c.target_width_px, c.target_height_px, c.flip_target, c.padding_px);
  values["texture_texel"] =
      image_json(c.texture_width_texel, c.texture_height_texel, c.flip_texture, c.padding_px);
  if (c.has_clip) {
    values["clip_px"] = {c.clip.left, c.clip.top, c.clip.right, c.clip.bottom};
  }
  values["vertices"] = ordered_json::array();
  for (const selvage_vertex& v : c.vertices) {
    values["vertices"].push_back(
        {{"x_fx8", v.x}, {"y_fx8", v.y}, {"u_fx16", v.u}, {"v_fx16", v.v}, {"q", v.q}});
  }
  return values;
}

}  // namespace selvage::cli
