#include "spec/hostile_lists.h"

#include <limits>
#include <utility>

#include "spec/canvas.h"

namespace selvage::spec {
namespace {

inline constexpr size_t kPolygons = 4;
inline constexpr size_t kNotTold = std::numeric_limits<size_t>::max() - 7;

using Lists = std::vector<HostileList>;

void spoil_list(Lists* lists) {
  lists->push_back({"no polygons", SELVAGE_OK, [](ListArguments& a) {
                      a.polygons_pointer = nullptr;
                      a.count = 0;
                    }});
  lists->push_back({"no list of polygons", SELVAGE_ERROR_POLYGONS_NULL,
                    [](ListArguments& a) { a.polygons_pointer = nullptr; }});
  for (const int32_t negative : {-1, std::numeric_limits<int32_t>::min()}) {
    lists->push_back({"a negative number of threads", SELVAGE_ERROR_THREADS,
                      [=](ListArguments& a) { a.threads = negative; }});
  }
  lists->push_back({"as many threads as the machine has",
                    SELVAGE_OK,
                    [](ListArguments& a) { a.threads = 0; },
                    {},
                    true});
}

void spoil_call(Lists* lists) {
  lists->push_back({"a list without a target", SELVAGE_ERROR_TARGET_NULL,
                    [](ListArguments& a) { a.target_pointer = nullptr; }});
  lists->push_back({"a list by an unknown filter", SELVAGE_ERROR_FILTER,
                    [](ListArguments& a) { a.options.filter = 77; }});
  lists->push_back({"a list by an unknown kernel", SELVAGE_ERROR_KERNEL,
                    [](ListArguments& a) { a.options.kernel = 77; }});
  lists->push_back({"a list within a negative tolerance", SELVAGE_ERROR_TOLERANCE,
                    [](ListArguments& a) { a.options.tolerance = -1; }});
}

// All are checked before the first is drawn, one after another.
void spoil_polygon(Lists* lists, size_t index) {
  const auto add = [&](const char* what, selvage_status wanted, auto spoil) {
    lists->push_back({"of " + std::to_string(kPolygons) + " polygons number " +
                          std::to_string(index) + " (from 0 on) " + what,
                      wanted, spoil, index});
  };
  add("has no vertices", SELVAGE_ERROR_VERTICES_NULL,
      [=](ListArguments& a) { a.polygons[index].vertices = nullptr; });
  add("has two", SELVAGE_ERROR_VERTEX_COUNT,
      [=](ListArguments& a) { a.polygons[index].count = 2; });
  add("has a q of 0", SELVAGE_ERROR_VERTEX_Q,
      [=](ListArguments& a) { a.outlines[index].back().q = 0; });
  add("has no texture", SELVAGE_ERROR_TEXTURE_NULL,
      [=](ListArguments& a) { a.polygons[index].texture = nullptr; });
  add("has no texture, and those behind it no vertices", SELVAGE_ERROR_TEXTURE_NULL,
      [=](ListArguments& a) {
        a.polygons[index].texture = nullptr;
        for (size_t i = index + 1; i < a.polygons.size(); ++i) a.polygons[i].vertices = nullptr;
      });
}

}  // namespace

std::vector<HostileList> hostile_lists(const Case& c) {
  Lists lists;
  spoil_list(&lists);
  spoil_call(&lists);
  spoil_polygon(&lists, c.choice % kPolygons);
  return lists;
}

ListOutcome make(const Subject& subject, const Case& good, const HostileList& list) {
  Canvas target(good.format, good.target_width_px, good.target_height_px, good.padding_px,
                good.flip_target, 0x5A);
  const Canvas texture(good.format, good.texture_width_texel, good.texture_height_texel,
                       good.padding_px, good.flip_texture, 0xEE);
  const Canvas before = target;
  ListArguments a{.target = target.image(),
                  .texture = texture.texture(),
                  .outlines = {kPolygons, good.vertices},
                  .polygons = {},
                  .options = {good.profile, good.filter, good.address, 0, SELVAGE_KERNEL_FASTEST},
                  .threads = 2,
                  .target_pointer = &a.target,
                  .polygons_pointer = nullptr,
                  .count = kPolygons};
  for (const auto& outline : a.outlines) {
    a.polygons.push_back({outline.data(), outline.size(), &a.texture});
  }
  a.polygons_pointer = a.polygons.data();
  list.spoil(a);
  size_t failed = kNotTold;
  try {
    const selvage_status status =
        subject.draw_many(a.target_pointer, good.has_clip ? &good.clip : nullptr,
                          a.polygons_pointer, a.count, &a.options, a.threads, &failed);
    return {status, target == before,
            failed != kNotTold ? std::optional<size_t>(failed) : std::nullopt};
  } catch (SubjectFailure& failure) {
    failure.call = list.what;
    if (!failure.shown) failure.shown = good;
    throw;
  }
}

}  // namespace selvage::spec
