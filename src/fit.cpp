#include <array>

#include "selvage.h"

namespace {

inline constexpr int32_t kMaxSize_texel = 32767;

[[nodiscard]] bool fits(int32_t size_texel) {
  return 1 <= size_texel && size_texel <= kMaxSize_texel;
}

}  // namespace

selvage_status selvage_fit(const selvage_vertex* corners, size_t count, size_t doubled,
                           int32_t width_texel, int32_t height_texel, selvage_vertex fitted[4]) {
  if (corners == nullptr || fitted == nullptr) return SELVAGE_ERROR_FIT_NULL;
  if (count != 3 && count != 4) return SELVAGE_ERROR_FIT_COUNT;
  if (count == 3 && doubled > 2) return SELVAGE_ERROR_FIT_DOUBLED;
  if (!fits(width_texel) || !fits(height_texel)) return SELVAGE_ERROR_FIT_SIZE;

  std::array<selvage_vertex, 4> around{};
  for (size_t i = 0; i < 4; ++i) {
    const bool after_doubled = count == 3 && i > doubled;
    around[i] = corners[after_doubled ? i - 1 : i];
    around[i].u = i >= 2 ? width_texel * SELVAGE_SUBTEXELS : 0;
    around[i].v = i == 1 || i == 2 ? height_texel * SELVAGE_SUBTEXELS : 0;
  }
  for (size_t i = 0; i < 4; ++i) fitted[i] = around[i];
  return SELVAGE_OK;
}
