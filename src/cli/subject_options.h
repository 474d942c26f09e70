// Which mapper is judged, and what it claims: from the command line and from its library.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "spec/subject.h"
#include "testbed/host.h"

namespace selvage::cli {

// As given on the command line; empty means not given, and then the library's own word counts.
struct SubjectOptions {
  std::string library;  // empty: the built-in mapper
  std::string call_limit;
  std::string kernel;  // of the built-in mapper
  std::string output;  // a file for what the subject prints
  std::string name;
  std::string winding;
  std::vector<std::string> formats, filters, addresses;
  std::optional<bool> perspective, clip, negative_pitch, concave, named_errors, any_texture_side,
      outside_texels, outside_vertices;
  std::string longest_side, longest_texture_side, guard_band;  // 0: any
  std::string most_vertices;
  // As a number or a / b.
  std::string accuracy, coverage_accuracy, position_step, coordinate_step;
};

struct ChosenSubject {
  spec::Subject subject;
  std::shared_ptr<testbed::Host> host;  // empty: the built-in mapper
  std::string arguments;  // "--subject ./theirs.so ...": what a replay has to be given again
};

// Loads the library, if there is one. Throws UserError. An empty profile is that of the subject.
[[nodiscard]] ChosenSubject choose_subject(const SubjectOptions& options,
                                           const std::string& profile,
                                           const spec::Subject& built_in);

// Throws UserError where a subject of another profile claims an accuracy, of texels or coverage.
void demand_exact_profile(const spec::Subject& subject);

// The text as one word of a shell's command line.
[[nodiscard]] std::string shell_word(const std::string& text);

}  // namespace selvage::cli
