#include "reports/bench/runs.h"

#include <algorithm>
#include <chrono>

#include "reports/bench/spans.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace selvage::reports {

namespace {

constexpr int kTurns = 5;

void fill_by_library(std::span<const PixelRun> runs, uint32_t colour) {
  for (const PixelRun& run : runs) std::fill_n(run.first, run.count_px, colour);
}

void fill_by_overlaps(std::span<const PixelRun> runs, uint32_t colour) {
  for (const PixelRun& run : runs) fill_run(run, colour);
}

#if defined(__x86_64__)
// Stores of eight pixels, the last one masked: without a branch where a run has eight or fewer.
[[gnu::target("avx2")]] void fill_by_masks(std::span<const PixelRun> runs, uint32_t colour) {
  constexpr int32_t kStore_px = 8;
  const __m256i eight = _mm256_set1_epi32(static_cast<int32_t>(colour));
  const __m256i iota = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
  for (const PixelRun& run : runs) {
    uint32_t* to = run.first;
    int32_t count_px = run.count_px;
    for (; count_px > kStore_px; count_px -= kStore_px, to += kStore_px)
      _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), eight);
    const __m256i is_pixel = _mm256_cmpgt_epi32(_mm256_set1_epi32(count_px), iota);
    _mm256_maskstore_epi32(reinterpret_cast<int32_t*>(to), is_pixel, eight);
  }
}
#endif

}  // namespace

std::vector<PixelRun> runs_of(const Workload& load, Target& target) {
  std::vector<PixelRun> runs;
  for (const auto& polygon : load.polygons) {
    for_each_span(polygon, target.width_px, target.height_px, [&](const Span& span) {
      runs.push_back({target.row(span.y_px) + span.left_px, span.right_px - span.left_px});
    });
  }
  return runs;
}

std::vector<Fill> fills_here() {
  std::vector<Fill> fills{{"std::fill_n", fill_by_library}, {"overlapping", fill_by_overlaps}};
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) fills.push_back({"masked", fill_by_masks});
#endif
  return fills;
}

Fill fastest_fill(std::span<const PixelRun> runs) {
  using Clock = std::chrono::steady_clock;
  const std::vector<Fill> fills = fills_here();
  std::vector<Clock::duration> least(fills.size(), Clock::duration::max());
  for (int turn = 0; turn < kTurns; ++turn) {
    for (size_t i = 0; i < fills.size(); ++i) {
      const Clock::time_point start = Clock::now();
      fills[i].fill(runs, kUntouched);
      least[i] = std::min(least[i], Clock::now() - start);
    }
  }
  return fills[static_cast<size_t>(std::ranges::min_element(least) - least.begin())];
}

}  // namespace selvage::reports
