// Wrong mappers: where in memory they look for the texels of a prepared texture, and for its sums.
#include <algorithm>
#include <cstring>

#include "coverage/catalogue.h"
#include "coverage/recipe.h"

namespace selvage::coverage {
namespace {

template <class Spoil>
void add(Catalogue* catalogue, std::string_view name, std::string_view killer, std::string_view bug,
         Spoil spoil) {
  Recipe recipe;
  recipe.prepare = [=](Job& job) {
    if (job.texture.layout == SELVAGE_LAYOUT_TILES) spoil(job);
  };
  spec::Subject subject = subject_of(std::string(name), std::move(recipe));
  subject.prepare = spec::built_in().prepare;
  catalogue->add(killer, bug, std::move(subject));
}

void spoil_tiles(Catalogue* catalogue) {
  add(catalogue, "tile_turned", "MAP", "the texels of a tile are taken column by column",
      [](Job& job) {
        job.place = [](const selvage_texture& texture, spec::Texel texel) {
          const spec::Texel in_tile{texel.t % 4, texel.s % 4};
          return place_of(texture,
                          {texel.s - in_tile.t + in_tile.s, texel.t - in_tile.s + in_tile.t});
        };
      });
  add(catalogue, "tile_pitch_in_texels", "MAP", "the pitch between rows of tiles counts texels",
      [](Job& job) {
        job.place = [](selvage_texture texture, spec::Texel texel) {
          texture.pitch /= bytes_per_texel(texture.format);
          return place_of(texture, texel);
        };
      });
  add(catalogue, "clamps_to_whole_tiles", "MEM", "the texture is as large as its tiles",
      [](Job& job) {
        job.texture.width = (job.texture.width + 3) / 4 * 4;
        job.texture.height = (job.texture.height + 3) / 4 * 4;
      });
  add(catalogue, "tiles_a_texel_off", "SAME", "from tiles, every texel is its right neighbour",
      [](Job& job) {
        for (selvage_vertex& v : job.vertices) {
          v.u =
              static_cast<int32_t>(std::min<int64_t>(int64_t{v.u} + SELVAGE_SUBTEXELS, INT32_MAX));
        }
      });
}

// The table moved up by one row, as if it had no row of zeros.
void move_up(const selvage_texture& prepared, const char* end) {
  char* const table = static_cast<char*>(const_cast<void*>(prepared.prepared));
  const auto bytes = static_cast<size_t>(end - table);
  const size_t row = bytes / (static_cast<size_t>(prepared.height) + 1);
  std::memmove(table, table + row, bytes - row);
}

void spoil_sums(Catalogue* catalogue) {
  spec::Subject subject = spec::built_in();
  subject.name = "sums_a_row_off";
  subject.prepare->prepare = [](const selvage_texture* source, selvage_layout layout,
                                int32_t with_sums, void* memory, size_t bytes,
                                selvage_texture* prepared) {
    const selvage_status status =
        selvage_prepare(source, layout, with_sums, memory, bytes, prepared);
    if (status == SELVAGE_OK && with_sums != 0) {
      move_up(*prepared, static_cast<const char*>(memory) + bytes);
    }
    return status;
  };
  catalogue->add("FILTER", "sums count from the second row of texels on", std::move(subject));
}

}  // namespace

void add_wrong_layouts(Catalogue* catalogue) {
  spoil_tiles(catalogue);
  spoil_sums(catalogue);
}

}  // namespace selvage::coverage
