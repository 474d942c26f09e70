// Audits of verifiers: does a law look at every pixel that it should, and say so?
//
// A law that looks at too little passes every mapper. So the audit counts by itself the pixels that
// are due, and then draws once for each of them with a mapper that is wrong in that pixel alone:
// the law must say that it judged so many, and reject every one of these mappers.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "spec/laws.h"

namespace selvage::spec {

struct AuditedPixel {
  int32_t x_px, y_px;
};

struct Audit {
  uint64_t due_px = 0;                 // pixels that the law has to judge, by the audit's own count
  uint64_t judged_px = 0;              // as the law says, of a mapper that is right
  bool rejects_right = false;          // that mapper
  std::vector<AuditedPixel> missed{};  // pixels in which a wrong mapper was not noticed

  [[nodiscard]] bool is_passed() const {
    return due_px > 0 && judged_px == due_px && !rejects_right && missed.empty();
  }
};

// The laws that hold each pixel against the model, and so can be audited pixel by pixel. The others
// compare two drawings of the same mapper.
[[nodiscard]] std::span<const std::string_view> audited_laws();

// Of a verifier that claims to check the named law, which is one of these, by a valid case of the
// exact profile with a small target: it draws twice for each pixel.
[[nodiscard]] Audit audit(std::string_view law, Judgement (*check)(const Subject&, const Case&),
                          const Case& c);

}  // namespace selvage::spec
