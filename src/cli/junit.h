// A run of `selvage verify` as the JUnit XML that CI systems read: a test case for each law.
#pragma once

#include <string>

#include "cli/verdict.h"

namespace selvage::cli {

[[nodiscard]] std::string junit_xml(const VerifyRun& run);

}  // namespace selvage::cli
