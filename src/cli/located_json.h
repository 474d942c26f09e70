// The program's strict reader of JSON: it knows where everything stands, and errors say so.
#pragma once

#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/error.h"

namespace selvage::cli {

// A file's text, parsed. Keys that stand twice, and nesting deeper than kMaxJsonDepth, are refused.
struct LocatedJson {
  std::string file;
  nlohmann::json value;
  std::map<std::string, int> lines;  // by JSON pointer (RFC 6901): of keys, objects and arrays
};
inline constexpr int kMaxJsonDepth = 8;

[[nodiscard]] LocatedJson parse_located(std::string file, std::string_view text);

// A value in it. What is asked for and is not there is a UserError "FILE:LINE: KEY: what is wrong".
class JsonNode {
 public:
  explicit JsonNode(const LocatedJson& source) : JsonNode(source, source.value, "", "") {}

  [[nodiscard]] std::string place() const;  // "FILE:LINE: KEY", as errors begin
  [[noreturn]] void fail(const std::string& what) const;
  [[noreturn]] void fail_for(const std::string& needed) const;  // "NEEDED is needed, not ..."

  // Calls `action`; a UserError that leaves it is this node's.
  template <typename Action>
  auto about(Action&& action) const {
    try {
      return std::forward<Action>(action)();
    } catch (const UserError& error) {
      fail(error.what());
    }
  }

  // The members of an object, all of which must be known.
  void expect_keys(const std::vector<std::string>& known) const;
  [[nodiscard]] bool has(const std::string& key) const { return value_.contains(key); }
  [[nodiscard]] JsonNode at(const std::string& key) const;
  // Of an array; messages call them "NAME 1", "NAME 2" and so on.
  [[nodiscard]] std::vector<JsonNode> elements(const std::string& name) const;
  [[nodiscard]] std::vector<std::pair<std::string, JsonNode>> members() const;

  [[nodiscard]] const nlohmann::json& value() const { return value_; }
  [[nodiscard]] double number() const;
  [[nodiscard]] bool boolean() const;
  [[nodiscard]] const std::string& text() const;
  [[nodiscard]] std::array<double, 3> vector() const;  // [x, y, z]

 private:
  JsonNode(const LocatedJson& source, const nlohmann::json& value, std::string path,
           std::string where)
      : source_(source), value_(value), path_(std::move(path)), where_(std::move(where)) {}

  [[nodiscard]] int line() const;

  const LocatedJson& source_;
  const nlohmann::json& value_;
  std::string path_, where_;  // as a JSON pointer; in words, ": KEY: NAME 1"
};

// Error texts may quote what was given, but not megabytes of it.
[[nodiscard]] std::string excerpt(const nlohmann::json& value);

}  // namespace selvage::cli
