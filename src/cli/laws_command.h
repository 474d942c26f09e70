// `selvage laws`.
#pragma once

#include "cli/console.h"

namespace selvage::cli {

// Lists the laws, their statements, and what each profile promises of them. Returns kExitFine.
int run_laws(bool json, const Console& console);

}  // namespace selvage::cli
