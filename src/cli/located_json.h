// JSON that knows where it stands: errors name file and line.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "scene/vectors.h"

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
  explicit JsonNode(const LocatedJson& source) : JsonNode(source, source.value, "") {}

  [[noreturn]] void fail(const std::string& what) const;

  // The members of an object, all of which must be known.
  void expect_keys(const std::vector<std::string>& known) const;
  [[nodiscard]] bool has(const std::string& key) const { return value_.contains(key); }
  [[nodiscard]] JsonNode at(const std::string& key) const;
  [[nodiscard]] std::vector<JsonNode> elements() const;
  [[nodiscard]] std::vector<std::pair<std::string, JsonNode>> members() const;

  [[nodiscard]] double number() const;
  [[nodiscard]] bool boolean() const;
  [[nodiscard]] const std::string& text() const;
  [[nodiscard]] scene::Vector3 vector() const;  // [x, y, z]

 private:
  JsonNode(const LocatedJson& source, const nlohmann::json& value, std::string path)
      : source_(source), value_(value), path_(std::move(path)) {}

  [[nodiscard]] int line() const;

  const LocatedJson& source_;
  const nlohmann::json& value_;
  std::string path_;
};

}  // namespace selvage::cli
