// The options by which commands are told of a library to judge, and of what it claims.
#pragma once

#include <CLI/App.hpp>
#include <string>

#include "cli/subject_options.h"

namespace selvage::cli {

inline constexpr const char* kSubjectGroup = "Another mapper to judge";

// --subject, with `what` it is there for, and --call-limit.
void add_library(CLI::App& command, SubjectOptions& subject, const std::string& what);
// --formats, --filters, ...
void add_claims(CLI::App& command, SubjectOptions& subject);

}  // namespace selvage::cli
