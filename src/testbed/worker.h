// The process that draws, and what it notes of its own end.
#pragma once

#include "testbed/control.h"

namespace selvage::testbed {

using DrawFunction = selvage_status (*)(const selvage_image*, const selvage_rect*,
                                        const selvage_vertex*, size_t, const selvage_texture*,
                                        const selvage_options*);

// Draws call after call until something ends it.
[[noreturn]] void work(Control& control, DrawFunction draw);

}  // namespace selvage::testbed
