// The near-ties of a batch, of however large denominators. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_BATCH_TIES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_BATCH_TIES_INL_H
#undef SELVAGE_VECTOR_BATCH_TIES_INL_H
#else
#define SELVAGE_VECTOR_BATCH_TIES_INL_H
#endif

#include <cmath>
#include <optional>

#include "mapper/vector_plane_ties-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// What decides them, from the first one on.
class BatchTies {
 public:
  // Of a ruled map of more than one row, denominators are no greater than most_ruled.
  HWY_INLINE BatchTies(const ExactMap& map, const SpanBatch& batch, int spare_bits,
                       double most_ruled = HUGE_VAL)
      : map_(map), batch_(batch), spare_bits_(spare_bits), most_ruled_(most_ruled) {}

  // Calls decide(ties) with PlaneTies, or with RuledTies.
  template <class Decide>
  HWY_INLINE void with_ties(const Decide& decide) {
    if (!is_found_) find();
    if (short_) return decide(&*short_);
    if (upper_) return decide(&*upper_);
    if (long_) return decide(&*long_);
    if (ruled_) return decide(&*ruled_);
    decide(&*long_ruled_);
  }

 private:
  HWY_NOINLINE void find() {
    is_found_ = true;
    if (map_.is_ruled() && batch_.rows > 1) {
      if (are_enough(UpperLimb::kBits, most_ruled_, spare_bits_)) {
        ruled_.emplace(map_.ruled());
      } else {
        long_ruled_.emplace(map_.ruled());
      }
      return;
    }
    const Span first = batch_.span(0);
    const ExactRows rows = map_.rows_from(first.left_px, first.row);
    const double most = most_denominator(rows, batch_);
    if (are_enough(OneLimb::kBits, most, spare_bits_)) {
      short_.emplace(rows, first);
    } else if (are_enough(UpperLimb::kBits, most, spare_bits_)) {
      upper_.emplace(rows, first);
    } else {
      long_.emplace(rows, first);
    }
  }

  const ExactMap& map_;
  const SpanBatch& batch_;
  int spare_bits_;
  double most_ruled_;
  bool is_found_ = false;
  // One of them, if it is:
  std::optional<PlaneTies<OneLimb>> short_;
  std::optional<PlaneTies<UpperLimb>> upper_;
  std::optional<PlaneTies<TwoLimbs>> long_;
  std::optional<RuledTies<UpperLimb>> ruled_;
  std::optional<RuledTies<TwoLimbs>> long_ruled_;
};

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
