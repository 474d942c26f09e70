// Bytes -> the one-line form of a case. What is accepted must come back as the same case.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "spec/case.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  namespace spec = selvage::spec;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const std::optional<spec::Case> parsed = spec::from_hex(text);
  const bool well_formed =
      size % 2 == 0 && text.find_first_not_of("0123456789abcdefABCDEF") == std::string_view::npos;
  if (parsed.has_value() != well_formed) std::abort();
  if (!parsed) return 0;
  if (spec::from_hex(spec::to_hex(*parsed)) != parsed) std::abort();
  if (spec::print(*parsed).empty()) std::abort();
  return 0;
}
