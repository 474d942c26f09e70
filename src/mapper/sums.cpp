#include "mapper/sums.h"

#include "mapper/channels.h"
#include "mapper/image.h"
#include "mapper/layout.h"

namespace selvage::mapper {
namespace {

void add(ChannelSums& sums, uint32_t texel) {
  for (size_t i = 0; i < sums.size(); ++i) sums[i] += texel >> (8 * i) & 0xFF;
}

}  // namespace

SumsShape SumsShape::of(const selvage_texture& texture) {
  const int64_t row_bytes = (int64_t{texture.width} + 1) * int64_t{sizeof(ChannelSums)};
  return {padded_pitch(row_bytes), int64_t{texture.height} + 1};
}

const void* place_of_sums(const selvage_texture& texture) {
  if (texture.format != SELVAGE_RGBA8888 || texture.pitch < 0) return nullptr;
  const int128 texel_bytes = int128{texture.pitch} * rows_of_bytes(texture).rows;
  if (texel_bytes + SumsShape::of(texture).bytes() > PTRDIFF_MAX) return nullptr;
  return static_cast<const char*>(texture.texels) + static_cast<ptrdiff_t>(texel_bytes);
}

void write_sums(const selvage_texture& texture, void* table) {
  const auto pitch_bytes = static_cast<ptrdiff_t>(SumsShape::of(texture).pitch_bytes);
  const char* const texels = static_cast<const char*>(texture.texels);
  char* row = static_cast<char*>(table);
  std::memset(row, 0, (static_cast<size_t>(texture.width) + 1) * sizeof(ChannelSums));
  for (int32_t t = 0; t < texture.height; ++t, row += pitch_bytes) {
    ChannelSums across{};
    std::memcpy(row + pitch_bytes, &across, sizeof across);
    char* above = row + sizeof across;
    for (int32_t s = 0; s < texture.width; ++s, above += sizeof across) {
      ChannelSums sums;
      std::memcpy(&sums, above, sizeof sums);
      add(across, load_texel(texels + texel_offset(texture, s, t)));
      for (size_t i = 0; i < sums.size(); ++i) sums[i] += across[i];
      std::memcpy(above + pitch_bytes, &sums, sizeof sums);
    }
  }
}

}  // namespace selvage::mapper
