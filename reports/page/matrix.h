// The conformance matrix: rows subjects, columns laws, from the verdicts that reports/matrix
// collects.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace selvage::reports {

// A line of rows.tsv with the verdict beside it.
struct MatrixRow {
  std::string group;               // "ours", "peers", "others"
  std::string id;                  // of its files
  nlohmann::ordered_json verdict;  // `selvage verify --json`; null where there is none,
  std::string error;               // and then why
};

// Rows in the order of matrix/rows.tsv, each with what its second pass found. Throws UserError for
// files that are missing or damaged.
[[nodiscard]] std::vector<MatrixRow> read_rows(const std::filesystem::path& folder);

// The whole matrix as one value. `findings` holds, by the row's id, what is known of a subject: its
// conventions, and for each law that it was seen to break what that means, and on which case.
[[nodiscard]] nlohmann::ordered_json matrix_of(const std::vector<MatrixRow>& rows,
                                               const nlohmann::ordered_json& laws,
                                               const nlohmann::ordered_json& findings);

// A line for each finding whose case no longer fails, and for each violation of a peer that none is
// about.
[[nodiscard]] std::vector<std::string> open_questions(const nlohmann::ordered_json& matrix);

// Whether every one of the project's own mappers keeps what it promises.
[[nodiscard]] bool ours_hold(const nlohmann::ordered_json& matrix);

// The page of a cell with a violation; its name is the cell's "page".
[[nodiscard]] std::string counterexample_page(const nlohmann::ordered_json& matrix,
                                              const nlohmann::ordered_json& subject,
                                              const nlohmann::ordered_json& cell);

// The section of the report, empty where there is no matrix.
[[nodiscard]] std::string matrix_section(const nlohmann::ordered_json& matrix);

}  // namespace selvage::reports
