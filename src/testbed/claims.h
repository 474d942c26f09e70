// What a library says of itself, checked.
#pragma once

#include "selvage_subject.h"
#include "spec/subject.h"

namespace selvage::testbed {

// Profile and claims alone. Throws LibraryError for what there is not.
[[nodiscard]] spec::Subject claimed(const selvage_claims& claims);

}  // namespace selvage::testbed
