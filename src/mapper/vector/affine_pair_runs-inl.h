// Affine spans two rows at a time, along them. Included once for each SIMD target.
//
// Windows are found a run ahead: no processor foresees where the rows of a polygon end, and what is
// found by then need not be waited for.
#if defined(SELVAGE_VECTOR_AFFINE_PAIR_RUNS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_AFFINE_PAIR_RUNS_INL_H
#undef SELVAGE_VECTOR_AFFINE_PAIR_RUNS_INL_H
#else
#define SELVAGE_VECTOR_AFFINE_PAIR_RUNS_INL_H
#endif

#include "mapper/vector/affine_window_pairs-inl.h"
#include "mapper/vector/affine_window_runs-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// Pairs of rows from a place on, as far as there is room for what is left of them.
template <class Pixel, int kColumnBits, int32_t kRows>
HWY_NOINLINE void draw_pairs(const AffineSpans& spans, const Surface& surface,
                             const WindowShape& shape, Resume* at, Left* left) {
  const AffineField field = spans.field;
  using Picker = PairPicker<Pixel, kColumnBits, kRows>;
  const Picker by(spans, surface);
  const WindowFinder<typename Picker::Coarse> finder(surface, shape, true);
  const AnchorRun run_u(kLanes * field.step_x.u_fx32), run_v(kLanes * field.step_x.v_fx32);
  const Lane to_anchor = by.to_anchor();
  FoundWindows found[2];
  PairRun runs[2];
  PairWalk walk(spans.batch, *at, FoundWindows::kMost,
                [&](const Span& both) HWY_ATTR { return first_of_line<Pixel>(surface, both); });
  const auto find_next = [&](int32_t i) HWY_ATTR __attribute__((always_inline)) {
    if (!walk.next(&runs[i])) return false;
    const Lane anchor = plus(field.at(runs[i].px, runs[i].upper.row), 1, to_anchor);
    for (int32_t k = 0; k < runs[i].vectors; k += kLanes) {
      finder.find(run_u.from(anchor.u_fx32, k), run_v.from(anchor.v_fx32, k), k, &found[i]);
    }
    return true;
  };
  left->count = 0;
  int32_t i = 0;
  for (bool has_run = find_next(i); has_run; i ^= 1) {
    has_run = find_next(i ^ 1);
    const PairRun& run = runs[i];
    const int32_t drawn = draw_pair_run<Pixel>(by, found[i], run, surface, left);
    if (drawn < run.vectors) {
      *at = {run.index, run.px + drawn * kLanes};
      return;
    }
  }
  *at = walk.at();
}

struct PairRuns {
  const AffineSpans& spans;
  const Surface& surface;
  Resume* at;
  Left* left;

  template <class Pixel, int kColumnBits, int32_t kRows>
  HWY_INLINE void draw(const WindowShape& shape) const {
    draw_pairs<Pixel, kColumnBits, kRows>(spans, surface, shape, at, left);
  }
};

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
