// A subject within a tolerance: what it draws, and what it says that it would draw by.
#pragma once

#include <cstdint>
#include <string>

#include "spec/canvas.h"
#include "spec/case.h"
#include "spec/subject.h"

namespace selvage::spec {

// Kernels need not draw the same within a tolerance: a case is drawn by one of them, or by the
// fastest where the subject has no such one.
struct Tolerance {
  int32_t fx16;
  selvage_kernel kernel;
};

[[nodiscard]] Subject tolerating(const Subject& subject, const Tolerance& tolerance);

// Asks a subject what it would draw a case by.
class AskedChoice {
 public:
  AskedChoice(const Subject& subject, const Case& c, const Tolerance& tolerance);

  [[nodiscard]] selvage_choice all();
  [[nodiscard]] selvage_choice row(int32_t y_px);
  // What was wrong with an answer, apart from the choice; empty if nothing.
  [[nodiscard]] const std::string& fault() const { return fault_; }

 private:
  [[nodiscard]] selvage_choice by_clip(const selvage_rect* clip);

  const Subject& subject_;
  const Case& case_;
  selvage_options options_;
  Canvas target_, untouched_, texture_;
  std::string fault_;
};

}  // namespace selvage::spec
