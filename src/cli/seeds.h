// Which cases a run is made of, as given on the command line.
#pragma once

#include <cstdint>
#include <string>

namespace selvage::cli {

// The value of --cases: from 1 to 10^9.
[[nodiscard]] uint64_t case_count(const std::string& text);

// The value of --seed, from 0 to 2^64 - 1; a fresh one for an empty text. Fresh seeds stay below
// 2^53, so that every reader of JSON keeps them exact.
[[nodiscard]] uint64_t first_seed(const std::string& text);

}  // namespace selvage::cli
