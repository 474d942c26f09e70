// The near-ties of a batch, of however large denominators. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_BATCH_TIES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_BATCH_TIES_INL_H
#undef SELVAGE_VECTOR_BATCH_TIES_INL_H
#else
#define SELVAGE_VECTOR_BATCH_TIES_INL_H
#endif

#include <optional>

#include "mapper/near_tie_bits.h"
#include "mapper/to_double.h"
#include "mapper/vector/plane_ties-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// What decides those of rows of one map, or of one row, from the first one on.
template <template <class> class DivisorWalk>
class BatchTies {
 public:
  HWY_INLINE BatchTies(const ExactMap& map, const SpanBatch& batch, int spare_bits)
      : map_(map), batch_(batch), spare_bits_(spare_bits) {}

  // Calls decide(ties) with Ties.
  template <class Decide>
  HWY_INLINE void with_ties(const Decide& decide) {
    if (!short_ && !upper_ && !long_) find();
    if (short_) return decide(&*short_);
    if (upper_) return decide(&*upper_);
    decide(&*long_);
  }

 private:
  template <class Number>
  using Ties = PlaneTies<Number, DivisorWalk>;

  HWY_NOINLINE void find() {
    const Span first = batch_.span(0);
    const ExactRows rows = map_.rows_from(first.left_px, first.row);
    const uint128 down = rows.below.d.start - rows.row.d.start;
    const double most_denominator = to_double(most_in_box(rows.row.d, down, batch_));
    if (are_enough(OneLimb::kBits, most_denominator, spare_bits_)) {
      short_.emplace(rows, first);
    } else if (are_enough(UpperLimb::kBits, most_denominator, spare_bits_)) {
      upper_.emplace(rows, first);
    } else {
      long_.emplace(rows, first);
    }
  }

  const ExactMap& map_;
  const SpanBatch& batch_;
  int spare_bits_;
  // One of them, once there are any:
  std::optional<Ties<OneLimb>> short_;
  std::optional<Ties<UpperLimb>> upper_;
  std::optional<Ties<TwoLimbs>> long_;
};
using AffineBatchTies = BatchTies<ConstantWalk>;
using PlaneBatchTies = BatchTies<PlaneWalk>;

// Whether the low 64 bits of rows that each have a map of their own decide near-ties.
[[nodiscard]] HWY_INLINE bool is_one_limb_enough(const RuledMap& map, double most_denominator,
                                                 int spare_bits) {
  return are_enough(OneLimb::kBits, most_denominator, spare_bits) && is_directed(map);
}

// What decides those of rows that each have a map of their own.
class RuledBatchTies {
 public:
  // How often: to find out whether one limb is enough costs as much as it saves in some rows.
  enum class Asked { kSeldom, kOften };
  RuledBatchTies(const RuledMap& map, double most_denominator, int spare_bits,
                 Asked asked = Asked::kSeldom) {
    if (asked == Asked::kOften && is_one_limb_enough(map, most_denominator, spare_bits)) {
      short_.emplace(map);
    } else if (are_enough(UpperLimb::kBits, most_denominator, spare_bits)) {
      upper_.emplace(map);
    } else {
      long_.emplace(map);
    }
  }

  // Calls decide(ties) with RuledTies.
  template <class Decide>
  HWY_INLINE void with_ties(const Decide& decide) {
    if (short_) return decide(&*short_);
    if (upper_) return decide(&*upper_);
    decide(&*long_);
  }

 private:
  // One of them:
  std::optional<RuledTies<OneLimb>> short_;
  std::optional<RuledTies<UpperLimb>> upper_;
  std::optional<RuledTies<TwoLimbs>> long_;
};

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
