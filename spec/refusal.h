// A valid polygon that a subject answers by an error.
#pragma once

#include "spec/picture.h"

namespace selvage::spec {

// Thrown by a drawing that must be drawn where the subject answers anything but SELVAGE_OK,
// whatever it drew. It is a violation of the law that is being checked (spec/laws.cpp).
struct Refusal {
  selvage_status status = SELVAGE_OK;
  Case shown{};
};

// Throws Refusal where the status is an error and the case one that must be drawn. The draw calls
// of spec/picture.h demand it.
void demand_drawn(selvage_status status, const Case& c);

// The draw calls of spec/picture.h without a look at the answer.
[[nodiscard]] Picture draw_whatever_answered(const Subject& subject, const Case& c);
[[nodiscard]] Picture draw_whatever_answered(const Subject& subject, const Case& c,
                                             const TexelAt& texel_at);

}  // namespace selvage::spec
