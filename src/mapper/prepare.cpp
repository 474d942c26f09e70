#include "mapper/prepare.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "mapper/image.h"
#include "mapper/layout.h"
#include "mapper/sums.h"

namespace selvage::mapper {
namespace {

void copy_texels(const selvage_texture& from, const selvage_texture& to, char* memory) {
  const auto texel_bytes = static_cast<size_t>(bytes_per_pixel(from.format));
  const char* const source = static_cast<const char*>(from.texels);
  for (int32_t t = 0; t < from.height; ++t) {
    for (int32_t s = 0; s < from.width;) {
      const int32_t count =
          std::min(run_texel(from.layout, s, from.width), run_texel(to.layout, s, to.width));
      std::memcpy(memory + texel_offset(to, s, t), source + texel_offset(from, s, t),
                  static_cast<size_t>(count) * texel_bytes);
      s += count;
    }
  }
}

}  // namespace

Preparation preparation(const selvage_texture& source, selvage_layout layout, bool with_sums) {
  const RowsOfBytes size = rows_of_bytes(layout, source.format, source.width, source.height);
  const int64_t pitch_bytes = padded_pitch(size.row_bytes);
  const int128 sum_bytes = with_sums ? SumsShape::of(source).bytes() : 0;
  const int128 bytes = int128{pitch_bytes} * size.rows + sum_bytes;
  return {layout, with_sums, static_cast<ptrdiff_t>(pitch_bytes),
          bytes <= PTRDIFF_MAX ? static_cast<size_t>(bytes) : SIZE_MAX};
}

selvage_texture prepare(const selvage_texture& source, const Preparation& plan, void* memory) {
  selvage_texture prepared = source;
  prepared.texels = memory;
  prepared.pitch = plan.pitch_bytes;
  prepared.layout = plan.layout;
  prepared.prepared = nullptr;
  char* const texels = static_cast<char*>(memory);
  copy_texels(source, prepared, texels);
  if (plan.with_sums) {
    char* const sums = texels + plan.pitch_bytes * rows_of_bytes(prepared).rows;
    write_sums(prepared, sums);
    prepared.prepared = sums;
  }
  return prepared;
}

}  // namespace selvage::mapper
