// The parts of the page, each from the JSON of the step that found it out.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace selvage::reports {

struct Results {
  nlohmann::ordered_json verify;     // selvage verify --json
  nlohmann::ordered_json laws;       // selvage laws --json
  nlohmann::ordered_json gallery;    // selvage_gallery
  nlohmann::ordered_json scenes;     // selvage_scenes; null where it was not built
  nlohmann::ordered_json stability;  // selvage stability --json
  nlohmann::ordered_json bench;      // selvage bench --json; null where nothing was measured
  nlohmann::ordered_json matrix;     // selvage_page matrix; null where none was made
  nlohmann::ordered_json mutants;    // coverage/mutants: its score; null where it has not been run
  std::string revision;              // of the source
  std::string command;               // that made the page
  std::string unmeasured;            // why, where bench is null
};

// What a law demands, from `selvage laws --json`; empty where there is no such law.
[[nodiscard]] std::string statement_of(const nlohmann::ordered_json& laws, const std::string& name);

// For a terminal.
[[nodiscard]] std::string summary_line(const Results& results);
[[nodiscard]] std::string summary_section(const Results& results);
[[nodiscard]] std::string verdict_section(const Results& results);
[[nodiscard]] std::string gallery_section(const Results& results);
[[nodiscard]] std::string stability_section(const Results& results);
[[nodiscard]] std::string measurement_section(const Results& results);
[[nodiscard]] std::string method_section(const Results& results);

// HTML of ours around a body, with nothing from outside. Title and body are HTML.
[[nodiscard]] std::string document(const std::string& title, const std::string& body);

// The whole document.
[[nodiscard]] std::string page(const Results& results);

}  // namespace selvage::reports
