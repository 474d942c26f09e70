#include "cli/junit.h"

#include <algorithm>
#include <cstdio>
#include <string_view>
#include <vector>

#include "selvage.h"
#include "testbed/printable.h"

namespace selvage::cli {
namespace {

// A character as XML has it.
[[nodiscard]] std::string_view reference(std::string_view character) {
  if (character == "&") return "&amp;";
  if (character == "<") return "&lt;";
  if (character == ">") return "&gt;";
  if (character == "\"") return "&quot;";
  return character;
}

// What may not be shown becomes U+FFFD, but for the ends of lines.
[[nodiscard]] std::string xml_escaped(std::string_view text) {
  std::string xml;
  while (!text.empty()) {
    const auto [bytes, is_printable] = testbed::first_character(text);
    const std::string_view character = text.substr(0, bytes);
    if (character == "\n") {
      xml += "&#10;";
    } else {
      xml += is_printable ? reference(character) : testbed::kReplacement;
    }
    text.remove_prefix(bytes);
  }
  return xml;
}

[[nodiscard]] std::string attribute(std::string_view name, std::string_view value) {
  return " " + std::string(name) + "=\"" + xml_escaped(value) + "\"";
}

[[nodiscard]] std::string seconds_text(int64_t time_ns) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3f", static_cast<double>(time_ns) * 1e-9);
  return text;
}

[[nodiscard]] std::string property(std::string_view name, std::string_view value) {
  return "    <property" + attribute("name", name) + attribute("value", value) + "/>\n";
}

// Lines stay lines where they are text and no attribute.
[[nodiscard]] std::string lines(const std::string& text) {
  std::string xml;
  size_t from = 0;
  for (size_t end; (end = text.find('\n', from)) != std::string::npos; from = end + 1) {
    xml += xml_escaped(std::string_view(text).substr(from, end - from)) + "\n";
  }
  return xml + xml_escaped(std::string_view(text).substr(from));
}

[[nodiscard]] std::string what_failed(const VerifyRun& run, const Verdict& verdict) {
  if (!verdict.found.violation) return "the law judged nothing, which shows nothing";
  std::string text = spec::explain(*verdict.found.violation);
  if (!text.ends_with('\n')) text += '\n';
  for (const std::string& note : notes_on(verdict)) text += "note: " + note + "\n";
  text += "replay: " + replay_line(run, verdict) + "\n";
  if (!verdict.picture.empty()) text += "picture: " + verdict.picture + "\n";
  return text;
}

[[nodiscard]] bool is_failure(const VerifyRun& run, const Verdict& verdict) {
  return verdict.found.violation ||
         (outcome(verdict) == "judged nothing" && !run.replay && run.shard.count == 1);
}

[[nodiscard]] std::string test_case(const VerifyRun& run, const Verdict& verdict) {
  const spec::LawVerdict& found = verdict.found;
  std::string xml = "    <testcase" + attribute("name", found.law->name) +
                    attribute("classname", run.subject) +
                    attribute("time", seconds_text(verdict.time_ns)) + ">\n";
  if (is_failure(run, verdict)) {
    const std::string message = found.violation ? found.violation->what : "judged nothing";
    xml += "      <failure" + attribute("message", message) + attribute("type", outcome(verdict)) +
           ">" + lines(what_failed(run, verdict)) + "</failure>\n";
  }
  if (outcome(verdict) == "not judged") {
    xml += "      <skipped" + attribute("message", "not judged: the time was over") + "/>\n";
  }
  if (outcome(verdict) == "not promised") {
    xml +=
        "      <skipped" + attribute("message", "not promised: " + verdict.not_promised) + "/>\n";
  }
  xml += "      <system-out>" + xml_escaped(found.law->statement) + ": " +
         std::to_string(found.cases) + " cases, " + std::to_string(found.judged_px) +
         " pixels judged" + (margin_text(verdict).empty() ? "" : ", " + margin_text(verdict)) +
         (verdict.in_part.empty() ? "" : "; in part: " + xml_escaped(verdict.in_part)) +
         "</system-out>\n";
  return xml + "    </testcase>\n";
}

[[nodiscard]] std::string skipped(const VerifyRun& run, const NotPromised& law) {
  return "    <testcase" + attribute("name", law.law) + attribute("classname", run.subject) +
         attribute("time", "0") + ">\n      <skipped" +
         attribute("message", "not promised: " + law.why) + "/>\n    </testcase>\n";
}

}  // namespace

std::string junit_xml(const VerifyRun& run) {
  int64_t time_ns = 0;
  size_t failures = 0;
  std::vector<NotPromised> left_out = run.not_promised;
  std::erase_if(left_out, [&](const NotPromised& law) {
    return std::ranges::any_of(
        run.verdicts, [&](const Verdict& verdict) { return verdict.found.law->name == law.law; });
  });
  size_t skips = left_out.size();
  std::string cases;
  for (const Verdict& verdict : run.verdicts) {
    time_ns += verdict.time_ns;
    failures += is_failure(run, verdict) ? 1 : 0;
    skips += outcome(verdict) == "not judged" || outcome(verdict) == "not promised" ? 1 : 0;
    cases += test_case(run, verdict);
  }
  for (const NotPromised& law : left_out) cases += skipped(run, law);
  const std::string counts =
      attribute("tests", std::to_string(run.verdicts.size() + left_out.size())) +
      attribute("failures", std::to_string(failures)) + attribute("errors", "0") +
      attribute("skipped", std::to_string(skips)) + attribute("time", seconds_text(time_ns));
  std::string properties =
      property("selvage", selvage_version()) + property("profile", run.profile) +
      property("accuracy_fx16", std::to_string(run.accuracy_fx16)) +
      property("coverage_accuracy_fx16", std::to_string(run.coverage_accuracy_fx16)) +
      property("arguments", run.arguments);
  std::string missing;
  for (const auto& [function, law] : run.not_exported) {
    missing += (missing.empty() ? "" : ", ") + function;
  }
  if (!missing.empty()) properties += property("not exported", missing);
  if (!run.replay) {
    properties += property("seed", std::to_string(run.seed));
    properties += property("cases", std::to_string(run.cases));
  }
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites" + counts + ">\n  <testsuite" +
         attribute("name", "selvage verify: " + run.subject) + counts + ">\n    <properties>\n" +
         properties + "    </properties>\n" + cases + "  </testsuite>\n</testsuites>\n";
}

}  // namespace selvage::cli
