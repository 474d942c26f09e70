// The laws as functions; spec/laws.cpp lists them.
#pragma once

#include "spec/laws.h"

namespace selvage::spec {

[[nodiscard]] Judgement check_cov(const Subject& subject, const Case& c);
[[nodiscard]] Judgement check_part(const Subject& subject, const Case& c);
[[nodiscard]] Judgement check_pinwheel(const Subject& subject, const Case& c);
[[nodiscard]] Judgement check_clip(const Subject& subject, const Case& c);
[[nodiscard]] Judgement check_vert(const Subject& subject, const Case& c);
[[nodiscard]] Judgement check_map(const Subject& subject, const Case& c);
[[nodiscard]] Judgement check_dda(const Subject& subject, const Case& c);
[[nodiscard]] Judgement check_gamut(const Subject& subject, const Case& c);
[[nodiscard]] Judgement check_shift(const Subject& subject, const Case& c);
[[nodiscard]] Judgement check_order(const Subject& subject, const Case& c);
[[nodiscard]] Judgement check_mirror(const Subject& subject, const Case& c);
[[nodiscard]] Judgement check_split(const Subject& subject, const Case& c);
[[nodiscard]] Judgement check_identity(const Subject& subject, const Case& c);
[[nodiscard]] Judgement check_affine(const Subject& subject, const Case& c);
[[nodiscard]] Judgement check_filter(const Subject& subject, const Case& c);
[[nodiscard]] Judgement check_tolerance(const Subject& subject, const Case& c);
[[nodiscard]] Judgement check_mem(const Subject& subject, const Case& c);
[[nodiscard]] Judgement check_total(const Subject& subject, const Case& c);
[[nodiscard]] Judgement check_same(const Subject& subject, const Case& c);
// Parts of law SAME.
[[nodiscard]] Judgement check_same_layouts(const Subject& subject, const Case& c);
[[nodiscard]] Judgement check_same_again(const Subject& subject, const Case& c);
[[nodiscard]] Judgement check_same_place(const Subject& subject, const Case& c);
[[nodiscard]] Judgement check_same_texture(const Subject& subject, const Case& c);
[[nodiscard]] Judgement check_oracle(const Subject& subject, const Case& c);

}  // namespace selvage::spec
