// Where edges cross rows, some rows at once. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_EDGE_LINES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_EDGE_LINES_INL_H
#undef SELVAGE_VECTOR_EDGE_LINES_INL_H
#else
#define SELVAGE_VECTOR_EDGE_LINES_INL_H
#endif

#include "mapper/edge.h"
#include "mapper/span_batch.h"
#include "mapper/vector/kernel-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

using RowTag = hn::CappedTag<double, kMostDoubles>;
using ColumnTag = hn::Rebind<int32_t, RowTag>;
using Columns = hn::Vec<ColumnTag>;
inline constexpr int32_t kRows = static_cast<int32_t>(hn::MaxLanes(RowTag()));

using RowNumbers = hn::Vec<RowTag>;

// An EdgeLine in all lanes. The dividend is a half more, so that a product serves as a quotient: no
// whole number is so near that roundings would reach it (spec/proofs/edge_reciprocal.g).
struct LineVectors {
  RowNumbers dividend, step, reciprocal;

  // Where it crosses rows so far below its first one.
  [[nodiscard]] HWY_INLINE Columns columns(RowNumbers rows_below) const {
    const auto at_row = hn::MulAdd(rows_below, step, dividend);
    return hn::DemoteTo(ColumnTag(), hn::Floor(hn::Mul(at_row, reciprocal)));
  }
};
inline constexpr double kUpToHalf = 0.5;

// Two edges below each other, with a corner between them, which is so many rows below the first.
struct BrokenLine {
  LineVectors upper, lower;
  RowNumbers corner;

  [[nodiscard]] HWY_INLINE Columns columns(RowNumbers rows_below) const {
    const auto is_upper = hn::Lt(rows_below, corner);
    const LineVectors broken = {hn::IfThenElse(is_upper, upper.dividend, lower.dividend),
                                hn::IfThenElse(is_upper, upper.step, lower.step),
                                hn::IfThenElse(is_upper, upper.reciprocal, lower.reciprocal)};
    return broken.columns(rows_below);
  }
};

// A triangle's need no walk along its edges: one of its sides is one edge.
struct TriangleLines {
  LineVectors whole;
  BrokenLine broken;

  [[nodiscard]] HWY_INLINE Columns one_side(RowNumbers rows_below) const {
    return whole.columns(rows_below);
  }
  [[nodiscard]] HWY_INLINE Columns other_side(RowNumbers rows_below) const {
    return broken.columns(rows_below);
  }
};

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
