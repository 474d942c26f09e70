// The process that draws, and what it notes of its own end.
#pragma once

#include <span>

#include "testbed/arena.h"
#include "testbed/control.h"
#include "testbed/functions.h"

namespace selvage::testbed {

// Ends this process with its parent, whatever becomes of that.
void die_with(pid_t parent);

// Carries out call after call until something ends it, `keeper` for one. An arena of
// `to_prepare_in`, read-only else, can be written while a texture is prepared in it.
[[noreturn]] void work(Control& control, const Functions& functions, pid_t keeper,
                       std::span<const Arena> to_prepare_in);

}  // namespace selvage::testbed
