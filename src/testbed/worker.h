// The process that draws, and what it notes of its own end.
#pragma once

#include <span>

#include "testbed/arena.h"
#include "testbed/control.h"
#include "testbed/functions.h"

namespace selvage::testbed {

// Carries out call after call until something ends it. An arena of `to_prepare_in`, read-only else,
// can be written while a texture is prepared in it.
[[noreturn]] void work(Control& control, const Functions& functions,
                       std::span<const Arena> to_prepare_in);

}  // namespace selvage::testbed
