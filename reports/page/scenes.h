// The section on the shipped scenes, from the JSON of selvage_scenes.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace selvage::reports {

// Their pictures, for the head of the page; empty where there are none.
[[nodiscard]] std::string scenes_head(const nlohmann::ordered_json& scenes);

// All of the section; where there are none, it says why.
[[nodiscard]] std::string scenes_section(const nlohmann::ordered_json& scenes);

// Cost and error of a scene, a row for each filter and tolerance.
[[nodiscard]] std::string tolerance_table(const nlohmann::ordered_json& scene);

// What the table shows, in words: from where on the picture differs, and what it saves.
[[nodiscard]] std::string tolerance_remarks(const nlohmann::ordered_json& scene);

// A line for each trial that breaks a promise; empty if none does.
[[nodiscard]] std::string broken_promises(const nlohmann::ordered_json& scenes);

[[nodiscard]] bool all_timed(const nlohmann::ordered_json& scenes);

// Trials that keep their promises, and all of them.
struct KeptCount {
  size_t kept = 0, all = 0;
};
[[nodiscard]] KeptCount kept_promises(const nlohmann::ordered_json& scenes);

// One of their texts, for HTML.
[[nodiscard]] std::string text_of(const nlohmann::ordered_json& values, const char* key);

}  // namespace selvage::reports
