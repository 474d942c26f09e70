#include "cli/usage_error.h"

#include <string>
#include <string_view>
#include <vector>

namespace selvage::cli {
namespace {

// One letter more, less or another, or two neighbours swapped.
[[nodiscard]] bool is_one_edit_away(std::string_view a, std::string_view b) {
  while (!a.empty() && !b.empty() && a.front() == b.front()) {
    a.remove_prefix(1);
    b.remove_prefix(1);
  }
  while (!a.empty() && !b.empty() && a.back() == b.back()) {
    a.remove_suffix(1);
    b.remove_suffix(1);
  }
  if (a.size() == 2 && b.size() == 2) return a[0] == b[1] && a[1] == b[0];
  return a.size() <= 1 && b.size() <= 1;
}

[[nodiscard]] std::string no_command(const CLI::App& program, const std::string& word) {
  const auto commands = program.get_subcommands([](const CLI::App*) { return true; });
  std::string known, meant;
  for (const CLI::App* command : commands) {
    const std::string& name = command->get_name();
    known += (known.empty() ? "" : command == commands.back() ? " and " : ", ") + name;
    if (is_one_edit_away(word, name)) meant = name;
  }
  return "'" + word + "' is no command; " + known + " are" +
         (meant.empty() ? "" : ". Is '" + meant + "' meant?");
}

[[nodiscard]] std::string unexpected(const std::vector<std::string>& words) {
  std::string text = words.size() == 1 ? "The following argument was not expected:"
                                       : "The following arguments were not expected:";
  for (const std::string& word : words) text += " " + word;
  return text;
}

[[nodiscard]] std::string what_is_wrong(const CLI::App& program, const CLI::ParseError& error) {
  const auto is = [&](CLI::ExitCodes code) {
    return error.get_exit_code() == static_cast<int>(code);
  };
  const std::vector<std::string> words = program.remaining(/*recurse=*/true);
  const bool lacks = is(CLI::ExitCodes::RequiredError);
  if (words.empty() || !(lacks || is(CLI::ExitCodes::ExtrasError))) return error.what();
  if (!program.get_subcommands().empty()) {  // a name that is mistyped is one that is missing
    return (lacks ? error.what() + std::string(". ") : "") + unexpected(words);
  }
  return words.front().starts_with('-') ? unexpected(words) : no_command(program, words.front());
}

}  // namespace

UserError usage_error(const CLI::App& program, const CLI::ParseError& error) {
  const auto chosen = program.get_subcommands();
  const std::string command = chosen.empty() ? "" : " " + chosen.front()->get_name();
  return UserError(what_is_wrong(program, error) + "\nRun 'selvage" + command +
                   " --help' for what is possible.");
}

}  // namespace selvage::cli
