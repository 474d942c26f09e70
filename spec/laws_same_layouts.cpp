// Law SAME, of layouts: how a texture lies in memory does not show in the picture.
#include <optional>
#include <string>

#include "spec/filter_texture.h"
#include "spec/law_list.h"
#include "spec/law_tools.h"
#include "spec/status_name.h"
#include "spec/texture_memory.h"

namespace selvage::spec {
namespace {

[[nodiscard]] const char* sentence(Layout layout) {
  return layout == Layout::kTiled ? "a texture prepared in tiles draws what rows as given draw"
                                  : "a texture prepared in rows draws what rows as given draw";
}

// A layout may be beyond a subject that has the other.
[[nodiscard]] std::optional<Picture> draw_if_claimed(const Subject& subject, const Case& c,
                                                     const TexelAt& texel_at,
                                                     Judgement* judgement) {
  try {
    return draw(subject, c, texel_at);
  } catch (const NotClaimed& not_claimed) {
    judgement->not_claimed = not_claimed.what;
    return std::nullopt;
  }
}

}  // namespace

Judgement check_same_layouts(const Subject& subject, const Case& c) {
  Judgement judgement;
  if (!subject.prepare || !is_valid(c)) return judgement;
  const TexelAt texel_at = filter_texture(c);
  const auto laid_out = [&](Layout layout) {
    Case shown = c;
    shown.layout = layout;
    return shown;
  };
  const Picture given = draw(subject, laid_out(Layout::kGiven), texel_at);
  for (const Layout layout : {Layout::kPadded, Layout::kTiled}) {
    const Case shown = laid_out(layout);
    const std::optional<Picture> drawn = draw_if_claimed(subject, shown, texel_at, &judgement);
    if (!drawn) continue;
    const Picture& picture = *drawn;
    if (picture.status != given.status) {
      judgement.violation =
          violation_of_call("SAME", sentence(layout), shown, "status " + status_name(given.status),
                            "status " + status_name(picture.status));
      return judgement;
    }
    const auto wanted = [&](int32_t x, int32_t y) { return must_be(given.at(x, y)); };
    OtherDrawing other = drawing_of(subject, "rows as given show it");
    other.shows_texels = false;
    if (add(&judgement, compare("SAME", sentence(layout), shown, picture, other, wanted))) break;
  }
  return judgement;
}

}  // namespace selvage::spec
