// Stepped rows show their lanes as they are, so that windows must hold all texels of a step that is
// a unit beside a whole texel, and of lanes on a texel's very edge.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mapper/stepped.h"
#include "mapper/vector/kernel.h"
#include "tests/kernel_support.h"
#include "tests/lane_units.h"

namespace selvage::mapper {
namespace {

inline constexpr int32_t kSteppedWidth_px = 64;
inline constexpr int64_t kUnit_fx16 = 1 << kStepShift;

template <class Pixel>
[[nodiscard]] std::vector<Pixel> texels() {
  std::vector<Pixel> texels(size_t{kRowTexture_texel} * kRowTexture_texel);
  for (size_t i = 0; i < texels.size(); ++i) {
    texels[i] = static_cast<Pixel>(static_cast<uint32_t>(i) * 2654435761U >> 7);
  }
  return texels;
}

// A row whose lanes, without any error, start and go on by so much.
template <class Pixel>
[[nodiscard]] std::vector<Pixel> drawn_stepped(const Kernels& kernels, Lane start, Lane step,
                                               selvage_format format, selvage_address address) {
  static const std::vector<Pixel> from = texels<Pixel>();
  std::vector<Pixel> row(kSteppedWidth_px);
  const auto line = [](int64_t start_fx32, int64_t step_fx32) {
    return ProjectiveField::Form{static_cast<double>(start_fx32), static_cast<double>(step_fx32),
                                 0};
  };
  const ProjectiveField field{
      0, 0, line(start.u_fx32, step.u_fx32), line(start.v_fx32, step.v_fx32), {1, 0, 0}, 0};
  constexpr ptrdiff_t kBytes = sizeof(Pixel);
  const Surface surface{{row.data(), kSteppedWidth_px, 1, kSteppedWidth_px * kBytes, format},
                        {from.data(), kRowTexture_texel, kRowTexture_texel,
                         kRowTexture_texel * kBytes, format, SELVAGE_LAYOUT_ROWS, nullptr},
                        address};
  const SpanBatch span = one_span({0, 0, kSteppedWidth_px});
  kernels.draw_stepped({span, span, field, &kSteppedWidth_px}, surface);
  return row;
}

template <class Pixel>
void expect_steps_alike(Lane start, Lane step, selvage_format format) {
  for (const selvage_address address : {SELVAGE_ADDRESS_CLAMP, SELVAGE_ADDRESS_WRAP}) {
    const auto by = [&](const Kernels& kernels) {
      return drawn_stepped<Pixel>(kernels, start, step, format, address);
    };
    const std::vector<Pixel> scalar = by(scalar_kernels(SELVAGE_FILTER_NEAREST));
    for (const selvage_kernel kernel : usable_kernels()) {
      if (kernel == SELVAGE_KERNEL_SCALAR) continue;
      ASSERT_EQ(by(*vector_kernels(kernel, SELVAGE_FILTER_NEAREST)), scalar)
          << "kernel " << kernel << ", u " << start.u_fx32 << " + i " << step.u_fx32 << ", v "
          << start.v_fx32 << " + i " << step.v_fx32 << ", address " << address;
    }
  }
}

TEST(StepWindows, HoldAllTexelsOfStepsBesideWholeOnes) {
  std::vector<int64_t> starts_fx32, steps_fx32;
  for (const int64_t texel : {-2, 0, 20, 63}) {
    for (const int64_t beside : {-1, 0, 1}) {
      starts_fx32.push_back(texel * kTexel_fx32 + beside * kUnit_fx16);
    }
  }
  for (const int64_t step : {int64_t{0}, kTexel_fx32 / 8, kTexel_fx32 / 2, kTexel_fx32}) {
    for (const int64_t beside : {-1, 0, 1}) {
      steps_fx32.push_back(step + beside);
      steps_fx32.push_back(-step + beside);
    }
  }
  for (const int64_t u : starts_fx32) {
    for (const int64_t step_u : steps_fx32) {
      for (const int64_t step_v : steps_fx32) {
        const Lane start{u, u + kTexel_fx32}, step{step_u, step_v};
        ASSERT_NO_FATAL_FAILURE(expect_steps_alike<uint32_t>(start, step, SELVAGE_RGBA8888));
        ASSERT_NO_FATAL_FAILURE(expect_steps_alike<uint16_t>(start, step, SELVAGE_RGB565));
        ASSERT_NO_FATAL_FAILURE(expect_steps_alike<uint8_t>(start, step, SELVAGE_INDEX8));
      }
    }
  }
}

}  // namespace
}  // namespace selvage::mapper
