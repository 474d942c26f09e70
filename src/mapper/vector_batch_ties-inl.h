// The near-ties of a batch, of however large denominators. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_BATCH_TIES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_BATCH_TIES_INL_H
#undef SELVAGE_VECTOR_BATCH_TIES_INL_H
#else
#define SELVAGE_VECTOR_BATCH_TIES_INL_H
#endif

#include <optional>

#include "mapper/vector_plane_ties-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// What decides them, from the first one on.
class BatchTies {
 public:
  HWY_INLINE BatchTies(const ExactMap& map, const SpanBatch& batch, int spare_bits)
      : map_(map), batch_(batch), spare_bits_(spare_bits) {}

  // Calls decide(ties) with PlaneTies, or with RuledTies.
  template <class Decide>
  HWY_INLINE void with_ties(const Decide& decide) {
    if (!short_ && !long_ && !ruled_) find();
    if (ruled_) {
      decide(&*ruled_);
    } else if (short_) {
      decide(&*short_);
    } else {
      decide(&*long_);
    }
  }

 private:
  HWY_NOINLINE void find() {
    if (map_.is_ruled() && batch_.rows > 1) {
      ruled_.emplace(map_.ruled());
      return;
    }
    const Span first = batch_.span(0);
    const BatchRows rows(map_, first);
    if (rows.are_short(batch_, spare_bits_)) {
      short_ = PlaneTies<OneLimb>(rows, first);
    } else {
      long_ = PlaneTies<TwoLimbs>(rows, first);
    }
  }

  const ExactMap& map_;
  const SpanBatch& batch_;
  int spare_bits_;
  std::optional<PlaneTies<OneLimb>> short_;
  std::optional<PlaneTies<TwoLimbs>> long_;
  std::optional<RuledTies<TwoLimbs>> ruled_;
};

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
