// The C interface to one polygon: every argument is checked here, then the profile's mapper draws.
#include "selvage.h"

#include "draw_call.h"
#include "historic/classroom.h"
#include "historic/two_stage.h"
#include "mapper/draw.h"
#include "mapper/image_check.h"
#include "mapper/kernel.h"
#include "mapper/kernel_choice.h"
#include "mapper/nearest_rounding.h"
#include "mapper/polygon.h"

namespace selvage {
namespace {

[[nodiscard]] selvage_status check_options(const selvage_options& options) {
  if (options.profile < SELVAGE_PROFILE_EXACT || options.profile > SELVAGE_PROFILE_DKIT) {
    return SELVAGE_ERROR_PROFILE;
  }
  if (options.filter < SELVAGE_FILTER_NEAREST || options.filter > SELVAGE_FILTER_AREA) {
    return SELVAGE_ERROR_FILTER;
  }
  if (options.address != SELVAGE_ADDRESS_CLAMP && options.address != SELVAGE_ADDRESS_WRAP) {
    return SELVAGE_ERROR_ADDRESS;
  }
  if (options.tolerance < 0) return SELVAGE_ERROR_TOLERANCE;
  if (!mapper::is_usable(options.kernel)) return SELVAGE_ERROR_KERNEL;
  const bool filtered = options.filter != SELVAGE_FILTER_NEAREST;
  return filtered && options.profile != SELVAGE_PROFILE_EXACT ? SELVAGE_ERROR_FILTER_PROFILE
                                                              : SELVAGE_OK;
}

}  // namespace

selvage_status check_call(const selvage_options& options, const selvage_image* target) {
  const selvage_status status = check_options(options);
  return status == SELVAGE_OK ? mapper::check_target(target) : status;
}

selvage_status check_source(const selvage_options& options, const selvage_image& target,
                            const selvage_texture* texture) {
  selvage_status status = mapper::check_texture(texture);
  if (status == SELVAGE_OK) status = mapper::check_pair(target, *texture);
  if (status != SELVAGE_OK) return status;
  if (options.filter != SELVAGE_FILTER_NEAREST && target.format != SELVAGE_RGBA8888) {
    return SELVAGE_ERROR_FILTER_FORMAT;
  }
  // The historic profiles read rows themselves.
  return options.profile != SELVAGE_PROFILE_EXACT && texture->layout != SELVAGE_LAYOUT_ROWS
             ? SELVAGE_ERROR_LAYOUT_PROFILE
             : SELVAGE_OK;
}

void draw_checked(const mapper::Surface& surface, const selvage_rect& visible,
                  const mapper::Polygon& polygon, const selvage_options& options,
                  const mapper::Kernels& kernels) {
  const auto& [target, texture, address] = surface;
  switch (options.profile) {
    case SELVAGE_PROFILE_ABRASH56:
      return historic::draw_two_stage(target, visible, polygon, texture, address,
                                      historic::Prestep::kNone);
    case SELVAGE_PROFILE_ABRASH57:
      return historic::draw_two_stage(target, visible, polygon, texture, address,
                                      historic::Prestep::kHalf);
    case SELVAGE_PROFILE_DKIT:
      return historic::draw_classroom(target, visible, polygon, texture, address);
    default:
      return mapper::draw(surface, visible, polygon, options, kernels);
  }
}

namespace {

// All arguments of a call but the clip, of which every one is good. In one piece: a call would cost
// as much as some of the checks do.
[[nodiscard, gnu::flatten]] selvage_status check_one(const selvage_options& options,
                                                     const selvage_image* target,
                                                     const selvage_vertex* vertices, size_t count,
                                                     const selvage_texture* texture,
                                                     mapper::Polygon* polygon) {
  selvage_status status = check_call(options, target);
  if (status == SELVAGE_OK) status = check_source(options, *target, texture);
  if (status == SELVAGE_OK)
    status = mapper::check_vertices(mapper::memory_of(*target), vertices, count);
  if (status == SELVAGE_OK) status = check_outline(options, {vertices, count}, polygon);
  return status;
}

}  // namespace
}  // namespace selvage

selvage_status selvage_draw(const selvage_image* target, const selvage_rect* clip,
                            const selvage_vertex* vertices, size_t count,
                            const selvage_texture* texture, const selvage_options* options) {
  using namespace selvage;
  const selvage_options chosen = options != nullptr ? *options : selvage_options{};
  mapper::Polygon polygon;

  const selvage_status status = check_one(chosen, target, vertices, count, texture, &polygon);
  if (status != SELVAGE_OK) return status;

  const mapper::NearestRounding rounding;
  // By value: descriptors that lie inside the target must not change while it is drawn on.
  const mapper::Surface surface{*target, *texture, chosen.address};
  draw_checked(surface, mapper::visible_rect(surface.target, clip), polygon, chosen,
               mapper::kernels_for(chosen, surface.texture, polygon));
  return SELVAGE_OK;
}

selvage_status selvage_choose(const selvage_image* target, const selvage_rect* clip,
                              const selvage_vertex* vertices, size_t count,
                              const selvage_texture* texture, const selvage_options* options,
                              selvage_choice* choice) {
  using namespace selvage;
  const selvage_options chosen = options != nullptr ? *options : selvage_options{};
  mapper::Polygon polygon;
  const selvage_status status = check_one(chosen, target, vertices, count, texture, &polygon);
  if (status != SELVAGE_OK) return status;
  if (choice == nullptr) return SELVAGE_ERROR_CHOICE_NULL;
  const mapper::NearestRounding rounding;
  *choice = chosen.profile == SELVAGE_PROFILE_EXACT
                ? mapper::choose({*target, *texture, chosen.address},
                                 mapper::visible_rect(*target, clip), polygon, chosen)
                : selvage_choice{SELVAGE_METHOD_HISTORIC, 0, 0};
  return SELVAGE_OK;
}

int32_t selvage_has_kernel(selvage_kernel kernel) {
  return selvage::mapper::is_usable(kernel) ? 1 : 0;
}

const char* selvage_version(void) { return SELVAGE_VERSION; }
