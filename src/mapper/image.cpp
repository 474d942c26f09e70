#include "mapper/image.h"

#include "mapper/sums.h"

namespace selvage::mapper {
namespace {

// Of a pitch, both equal: the columns of bytes of two rectangles never meet.
[[nodiscard]] bool interleave(uintptr_t a_begin, int64_t a_row_bytes, uintptr_t b_begin,
                              int64_t b_row_bytes, uintptr_t stride) {
  const uintptr_t b_column = (b_begin % stride + stride - a_begin % stride) % stride;
  return static_cast<uintptr_t>(a_row_bytes) <= b_column &&
         b_column + static_cast<uintptr_t>(b_row_bytes) <= stride;
}

[[nodiscard]] bool meets_texels(const selvage_image& target, const selvage_texture& texture) {
  const RowsOfBytes size = rows_of_bytes(texture);
  const Memory pixels = memory_of(target);
  const Memory texels = memory_of_rows(texture.texels, size, texture.pitch);
  if (!pixels.meets(texels)) return false;
  const uintptr_t stride = stride_of(target.pitch);
  return stride != stride_of(texture.pitch) ||
         !interleave(pixels.begin, rows_of_bytes(target).row_bytes, texels.begin, size.row_bytes,
                     stride);
}

}  // namespace

uintptr_t end_of_sums(const selvage_texture& texture) {
  return reinterpret_cast<uintptr_t>(texture.prepared) +
         static_cast<uintptr_t>(SumsShape::of(texture).bytes());
}

bool share_bytes(const selvage_image& target, const selvage_texture& texture) {
  if (meets_texels(target, texture)) return true;
  if (texture.prepared == nullptr) return false;
  const Memory sums{reinterpret_cast<uintptr_t>(texture.prepared), end_of_sums(texture)};
  return memory_of(target).meets(sums);
}

}  // namespace selvage::mapper
