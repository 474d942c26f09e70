#include "reports/peers/subjects/subject.h"

#include <algorithm>
#include <vector>

using namespace selvage::reports;

namespace {

// A clip rectangle may reach beyond the target and be empty or inverted, which few peers can be
// told: the same pixels as a rectangle within it. Which of them are drawn remains the peer's work.
[[nodiscard]] selvage_rect within(const selvage_image& target, const selvage_rect& clip) {
  const selvage_rect both{
      std::clamp(clip.left, 0, target.width), std::clamp(clip.top, 0, target.height),
      std::clamp(clip.right, 0, target.width), std::clamp(clip.bottom, 0, target.height)};
  return {both.left, both.top, std::max(both.left, both.right), std::max(both.top, both.bottom)};
}

}  // namespace

SELVAGE_API const selvage_claims* selvage_subject(void) { return &peer_subject().claims; }

// What is given lies within the claims, so that nothing is left to check.
SELVAGE_API selvage_status selvage_draw(const selvage_image* target, const selvage_rect* clip,
                                        const selvage_vertex* vertices, size_t count,
                                        const selvage_texture* texture,
                                        const selvage_options* options) {
  const std::vector<Polygon> polygons(1, Polygon(vertices, vertices + count));
  Canvas canvas{.target = *target, .texture = *texture, .opaque = false};
  if (options != nullptr) {
    canvas.filter = options->filter;
    canvas.address = options->address;
  }
  if (clip != nullptr) canvas.clip = within(*target, *clip);
  canvas.perspective = std::any_of(vertices, vertices + count, [&](const selvage_vertex& vertex) {
    return vertex.q != vertices[0].q;
  });
  try {
    peer_subject().paint(canvas)->draw(polygons);
  } catch (const Inexpressible&) {
    return SELVAGE_STATUS_BEYOND_CLAIMS;
  }
  return SELVAGE_OK;
}
