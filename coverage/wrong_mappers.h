// The catalogue of wrong mappers: each breaks one thing that real mappers have got wrong. A law
// that lets its wrong mapper pass is no law.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "spec/subject.h"

namespace selvage::coverage {

// Within so many cases its killer has rejected each.
inline constexpr uint64_t kKillerCases = 1500;

struct WrongMapper {
  std::string name;
  std::string_view bug;     // what it does wrong, in one sentence
  std::string_view killer;  // a law that must reject it; others may too
  spec::Subject subject;
};

[[nodiscard]] std::span<const WrongMapper> wrong_mappers();

// The same recipe with nothing wrong in it: must pass every law that its profile promises, or the
// catalogue proves nothing.
[[nodiscard]] spec::Subject right_mapper(selvage_profile profile);

}  // namespace selvage::coverage
