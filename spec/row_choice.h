// What a mapper may tell that it draws a row by (selvage_choose): what is wrong with it.
#pragma once

#include <string>

#include "spec/case.h"
#include "spec/exact.h"
#include "spec/subject.h"

namespace selvage::spec {

// Not one that is exact: it has a bound.
[[nodiscard]] bool is_stepped(const selvage_choice& choice);

// Of a row of the case, which is drawn with nearest within a tolerance, or without one; empty if
// nothing is wrong. `line` is that of the row, empty if no edge crosses it.
[[nodiscard]] std::string fault_of(const selvage_choice& choice, const Capabilities& claims,
                                   const Case& c, const std::optional<ScanLine>& line, int32_t y_px,
                                   int32_t tolerance_fx16);

// Of a whole case that is drawn with another filter.
[[nodiscard]] std::string fault_of_filtered(const selvage_choice& choice,
                                            const Capabilities& claims, const Case& c);

// What is told of some rows, and of one more.
[[nodiscard]] selvage_choice together(const selvage_choice& some, const selvage_choice& row);

[[nodiscard]] bool same(const selvage_choice& a, const selvage_choice& b);
[[nodiscard]] std::string text_of(const selvage_choice& choice);

}  // namespace selvage::spec
