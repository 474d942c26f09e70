// Wrong mappers: many polygons in one call.
#include <algorithm>
#include <vector>

#include "coverage/catalogue.h"
#include "coverage/many_recipe.h"
#include "spec/subject.h"

namespace selvage::coverage {
namespace {

// In every profile: bands are cut in all of them alike.
template <class Spoil>
void add(Catalogue* catalogue, std::string_view name, std::string_view bug, Spoil spoil,
         std::string_view killer = "SAME") {
  for (const spec::Profile& profile : spec::profiles()) {
    ManyRecipe recipe;
    spoil(recipe);
    spec::Subject subject = spec::built_in(profile.id);
    subject.draw_many = draw_many_by(std::move(recipe), subject);
    subject.name = std::string(profile.name) + "_" + std::string(name);
    catalogue->add(killer, bug, std::move(subject));
  }
}

// One kernel of the mapper's draws other bytes than the others: all pixels one further left.
void add_kernel_that_differs(Catalogue* catalogue) {
  spec::Subject subject = spec::built_in();
  subject.draw = [](const selvage_image* target, const selvage_rect* clip,
                    const selvage_vertex* vertices, size_t count, const selvage_texture* texture,
                    const selvage_options* options) {
    std::vector<selvage_vertex> moved(vertices, vertices + (vertices != nullptr ? count : 0));
    if (options == nullptr || options->kernel != SELVAGE_KERNEL_SCALAR || moved.empty()) {
      return selvage_draw(target, clip, vertices, count, texture, options);
    }
    for (selvage_vertex& v : moved) v.x = std::max<int32_t>(v.x - SELVAGE_SUBPIXELS, SELVAGE_X_MIN);
    return selvage_draw(target, clip, moved.data(), count, texture, options);
  };
  subject.name = "one_kernel_differs";
  catalogue->add("SAME", "one kernel draws a pixel off", std::move(subject));
}

void add_of_bands(Catalogue* catalogue) {
  add(catalogue, "order_reversed_in_bands", "a band draws its polygons last to first",
      [](ManyRecipe& r) { r.order = [](auto& polygons) { std::ranges::reverse(polygons); }; });
  add(catalogue, "bands_lose_a_row", "the last row of a band is taken for the next one's",
      [](ManyRecipe& r) {
        r.cut = [right = r.cut](int32_t height_px, int32_t threads) {
          std::vector<BandRows> bands = right(height_px, threads);
          for (BandRows& band : bands) band.end -= band.end < height_px ? 1 : 0;
          return bands;
        };
      });
  add(catalogue, "rows_in_a_byte", "where a band begins is kept in a byte", [](ManyRecipe& r) {
    r.cut = [right = r.cut](int32_t height_px, int32_t threads) {
      std::vector<BandRows> bands = right(height_px, threads);
      for (BandRows& band : bands) {
        const int32_t rows = band.end - band.first;
        band.first %= 256;
        band.end = band.first + rows;
      }
      return bands;
    };
  });
  add(catalogue, "rows_left_over", "rows that the threads do not divide evenly are not drawn",
      [](ManyRecipe& r) {
        r.cut = [](int32_t height_px, int32_t threads) {
          std::vector<BandRows> bands;
          const int32_t rows = height_px / threads;
          for (int32_t i = 0; i < threads; ++i) bands.push_back({i * rows, (i + 1) * rows});
          return bands;
        };
      });
  add(catalogue, "one_band_a_polygon", "a polygon is drawn only in the band in which it begins",
      [](ManyRecipe& r) {
        r.reaches = [](size_t first, size_t end, size_t band) {
          return first == band && first < end;
        };
      });
}

void add_of_lists(Catalogue* catalogue) {
  add(catalogue, "first_polygon_lost", "the first polygon of the list is not drawn",
      [](ManyRecipe& r) {
        r.prepare = [](auto& polygons) {
          if (!polygons.empty()) polygons.erase(polygons.begin());
        };
      });
  add(catalogue, "no_more_than_eight", "of a long list the polygons from the ninth on are lost",
      [](ManyRecipe& r) {
        r.prepare = [](auto& polygons) {
          if (polygons.size() > 8) polygons.resize(8);
        };
      });
  add(catalogue, "one_count_for_all", "all polygons of a list have as few vertices as one of them",
      [](ManyRecipe& r) {
        r.prepare = [](auto& polygons) {
          if (polygons.empty()) return;
          const size_t least = std::ranges::min(polygons, {}, &selvage_polygon::count).count;
          for (selvage_polygon& p : polygons) p.count = least;
        };
      });
}

// What is made of a list's arguments.
void add_of_arguments(Catalogue* catalogue) {
  add(
      catalogue, "draws_until_one_is_refused", "polygons are drawn until one is refused",
      [](ManyRecipe& r) { r.checks_first = false; }, "TOTAL");
  add(
      catalogue, "tells_the_next_one", "of a polygon that is refused the next one's index is told",
      [](ManyRecipe& r) { r.tell = [](size_t i) { return i + 1; }; }, "TOTAL");
  add(
      catalogue, "no_threads_draw_nothing", "with as many threads as there are nothing is drawn",
      [](ManyRecipe& r) {
        r.all_threads = 0;
        r.cut = [right = r.cut](int32_t height_px, int32_t threads) {
          return threads == 0 ? std::vector<BandRows>() : right(height_px, threads);
        };
      },
      "SAME");
}

}  // namespace

void add_wrong_many(Catalogue* catalogue) {
  add_kernel_that_differs(catalogue);
  add_of_bands(catalogue);
  add_of_lists(catalogue);
  add_of_arguments(catalogue);
}

}  // namespace selvage::coverage
