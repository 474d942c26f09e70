#include "cli/located_json.h"

#include <algorithm>
#include <cstdlib>
#include <iterator>

#include "testbed/printable.h"

namespace selvage::cli {
namespace {

using nlohmann::json;

constexpr size_t kMostNamed = 60;  // letters of a key

// Counts the lines that the parser has taken.
class CountingIterator {
 public:
  using iterator_category = std::forward_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountingIterator(const char* at, int& line) : at_(at), line_(&line) {}
  reference operator*() const { return *at_; }
  CountingIterator& operator++() {
    *line_ += *at_ == '\n';
    ++at_;
    return *this;
  }
  CountingIterator operator++(int) {
    const CountingIterator before = *this;
    ++*this;
    return before;
  }
  friend bool operator==(const CountingIterator& a, const CountingIterator& b) {
    return a.at_ == b.at_;
  }

 private:
  const char* at_;
  int* line_;
};

[[noreturn]] void fail_at(const std::string& file, int line, const std::string& what) {
  throw UserError(file + ":" + std::to_string(line) + ": " + what);
}

// "/key", as in a JSON pointer.
[[nodiscard]] std::string pointer_token(std::string key) {
  return (json::json_pointer() / std::move(key)).to_string();
}

// Follows the parser and notes the lines. Of plain values none is kept: the parser may have read
// the character behind a number already.
class Lines {
 public:
  Lines(LocatedJson& located, const int& line) : located_(located), line_(line) {}

  bool operator()(int depth, json::parse_event_t event, const json& parsed) {
    using Event = json::parse_event_t;
    if (depth > kMaxJsonDepth) fail_at(located_.file, line_, "nested deeper than any file here is");
    if (event == Event::key) note_key(parsed.get_ref<const std::string&>());
    if (event == Event::object_start || event == Event::array_start) {
      const std::string path = next_path();
      located_.lines.emplace(path, line_);
      frames_.push_back({path, "", event == Event::array_start, 0});
    }
    if (event == Event::object_end || event == Event::array_end) frames_.pop_back();
    if (event == Event::value) (void)next_path();
    return true;
  }

 private:
  struct Frame {
    std::string path, key;
    bool is_array;
    size_t next;
  };

  void note_key(const std::string& key) {
    Frame& frame = frames_.back();
    frame.key = frame.path + pointer_token(key);
    if (!located_.lines.emplace(frame.key, line_).second) {
      fail_at(located_.file, line_, "the key " + excerpt(key) + " stands twice");
    }
  }

  [[nodiscard]] std::string next_path() {
    if (frames_.empty()) return "";
    Frame& frame = frames_.back();
    return frame.is_array ? frame.path + "/" + std::to_string(frame.next++) : frame.key;
  }

  LocatedJson& located_;
  const int& line_;
  std::vector<Frame> frames_;
};

// "[json.exception.parse_error.101] parse error at line 3, column 5: explanation", or another
// "[name] explanation" of what was just read.
[[noreturn]] void fail_as_parser(const std::string& file, int line, const std::string& told) {
  const size_t bracket = told.find("] ");
  std::string what = told.substr(bracket == std::string::npos ? 0 : bracket + 2);
  const std::string at = "parse error at line ";
  if (what.rfind(at, 0) == 0) {
    line = std::atoi(what.c_str() + at.size());
    const size_t column = what.find(", ");
    if (column != std::string::npos) what.erase(0, column + 2);
  }
  fail_at(file, std::max(line, 1), "not JSON: " + testbed::printable(what));
}

}  // namespace

std::string excerpt(const json& value) {
  const std::string text = value.dump(-1, ' ', true, json::error_handler_t::replace);
  return text.size() <= 60 ? text : text.substr(0, 57) + "...";
}

LocatedJson parse_located(std::string file, std::string_view text) {
  LocatedJson located{std::move(file), {}, {}};
  int line = 1, end_line = 1;
  try {
    located.value =
        json::parse(CountingIterator(text.data(), line),
                    CountingIterator(text.data() + text.size(), end_line), Lines(located, line));
  } catch (const json::exception& error) {
    fail_as_parser(located.file, line, error.what());
  }
  return located;
}

int JsonNode::line() const {
  for (std::string path = path_;; path = path.substr(0, path.rfind('/'))) {
    const auto found = source_.lines.find(path);
    if (found != source_.lines.end()) return found->second;
    if (path.empty()) return 1;
  }
}

std::string JsonNode::place() const { return source_.file + ":" + std::to_string(line()) + where_; }

void JsonNode::fail(const std::string& what) const { throw UserError(place() + ": " + what); }

void JsonNode::fail_for(const std::string& needed) const {
  fail(needed + " is needed, not " + excerpt(value_));
}

void JsonNode::expect_keys(const std::vector<std::string>& known) const {
  if (!value_.is_object()) fail_for("an object");
  std::string list;
  for (const std::string& key : known) list += (list.empty() ? "" : ", ") + key;
  for (const auto& item : value_.items()) {
    if (std::find(known.begin(), known.end(), item.key()) == known.end()) {
      const JsonNode unknown(source_, item.value(), path_ + pointer_token(item.key()), where_);
      unknown.fail("unknown key " + excerpt(item.key()) + "; known here: " + list);
    }
  }
}

JsonNode JsonNode::at(const std::string& key) const {
  if (!value_.is_object()) fail_for("an object");
  if (!has(key)) fail("'" + key + "' is missing");
  const std::string named = key.size() <= kMostNamed ? key : key.substr(0, kMostNamed) + "...";
  return {source_, value_[key], path_ + pointer_token(key), where_ + ": " + named};
}

std::vector<JsonNode> JsonNode::elements(const std::string& name) const {
  if (!value_.is_array()) fail_for("an array");
  std::vector<JsonNode> all;
  for (size_t i = 0; i < value_.size(); ++i) {
    all.push_back({source_, value_[i], path_ + "/" + std::to_string(i),
                   where_ + ": " + name + " " + std::to_string(i + 1)});
  }
  return all;
}

std::vector<std::pair<std::string, JsonNode>> JsonNode::members() const {
  if (!value_.is_object()) fail_for("an object");
  std::vector<std::pair<std::string, JsonNode>> all;
  for (const auto& item : value_.items()) all.emplace_back(item.key(), at(item.key()));
  return all;
}

double JsonNode::number() const {
  if (!value_.is_number()) fail_for("a number");
  return value_.get<double>();
}

bool JsonNode::boolean() const {
  if (!value_.is_boolean()) fail_for("true or false");
  return value_.get<bool>();
}

const std::string& JsonNode::text() const {
  if (!value_.is_string()) fail_for("a text");
  return value_.get_ref<const std::string&>();
}

std::array<double, 3> JsonNode::vector() const {
  if (!value_.is_array() || value_.size() != 3) fail_for("[x, y, z]");
  const std::vector<JsonNode> parts = elements("number");
  return {parts[0].number(), parts[1].number(), parts[2].number()};
}

}  // namespace selvage::cli
