// What a library exports of the C interface.
#pragma once

#include <string>

#include "selvage.h"
#include "testbed/control.h"

namespace selvage::testbed {

// Null where it does not export one.
struct Functions {
  decltype(&selvage_draw) draw = nullptr;
  decltype(&selvage_draw_many) draw_many = nullptr;
  decltype(&selvage_draw_many_bytes) draw_many_bytes = nullptr;
  decltype(&selvage_prepare) prepare = nullptr;
  decltype(&selvage_prepare_bytes) prepare_bytes = nullptr;
  decltype(&selvage_choose) choose = nullptr;
};

// Those of the library that selvage_draw comes out of: of what that one is linked with, none.
// `library` is a handle of dlopen.
[[nodiscard]] Functions find_functions(void* library);

// Why these cannot be used; empty if they can.
[[nodiscard]] std::string fault_of(const Functions& functions);

// Sum of bit_of().
[[nodiscard]] uint32_t exported(const Functions& functions);

[[nodiscard]] Answer carry_out(const Functions& functions, const Call& call);

}  // namespace selvage::testbed
