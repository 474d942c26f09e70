// selvage_page: the page and the data of its plots, from the JSON of the other steps.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>

#include "cli/error.h"
#include "cli/file.h"
#include "reports/page/again.h"
#include "reports/page/known.h"
#include "reports/page/matrix.h"
#include "reports/page/plots.h"
#include "reports/page/sections.h"
#include "reports/page/worst_cases.h"

namespace {

using namespace selvage;
using namespace selvage::reports;
using json = nlohmann::ordered_json;
namespace fs = std::filesystem;

json read_json(const fs::path& path) {
  const std::string text = cli::read_text_file(path);
  return cli::about(path.string(), [&] {
    try {
      return json::parse(text);
    } catch (const json::parse_error& error) {
      throw cli::UserError(std::string("not JSON: ") + error.what());
    }
  });
}

void write_text(const fs::path& path, const std::string& text) {
  cli::write_file(path, {reinterpret_cast<const uint8_t*>(text.data()), text.size()});
}

void write_plot_data(const fs::path& folder) {
  for (const PlotFile& file : plot_files(read_json(folder / "bench.json")))
    write_text(folder / file.name, file.text);
}

// Returns whether our own mappers keep their promises.
bool write_matrix(const fs::path& folder, const std::string& findings) {
  const fs::path parts = folder / "matrix";
  const json matrix = matrix_of(read_rows(parts), read_json(parts / "laws.json"),
                                findings.empty() ? json::object() : read_json(findings));
  write_text(folder / "matrix.json", matrix.dump(1) + "\n");
  for (const json& subject : matrix.at("subjects")) {
    for (const json& cell : subject.value("cells", json::array())) {
      if (cell.contains("page"))
        write_text(folder / cell["page"].get<std::string>(),
                   counterexample_page(matrix, subject, cell));
    }
  }
  for (const std::string& question : open_questions(matrix)) {
    std::fprintf(stderr, "matrix: %s\n", question.c_str());
  }
  return ours_hold(matrix);
}

// What is tried first on the row `id`, as the directory for `selvage verify --corpus`.
void write_known(const fs::path& folder, const std::string& findings, const std::string& id) {
  const fs::path directory = folder / "matrix" / "known" / id;
  fs::create_directories(directory);
  fs::create_directories(folder / "corpus");
  const auto corpus = cli::read_corpus(folder / "corpus");
  const json examined = findings.empty() ? json::object() : read_json(findings);
  for (const cli::KnownCase& known : known_cases(examined, id, corpus)) {
    cli::write_to_corpus(directory, known);
  }
}

// What was new on other rows, for each row that it has to be tried on, as those directories are.
void write_again(const fs::path& folder, const std::string& findings) {
  const std::vector<MatrixRow> rows = read_rows(folder / "matrix");
  const json examined = findings.empty() ? json::object() : read_json(findings);
  for (const MatrixRow& row : rows) {
    const std::vector<cli::KnownCase> again = to_try_again(rows, examined, row.id);
    const fs::path directory = folder / "matrix" / "again" / row.id;
    if (!again.empty()) fs::create_directories(directory);
    for (const cli::KnownCase& known : again) cli::write_to_corpus(directory, known);
  }
}

void write_page(const fs::path& folder, Results results) {
  results.verify = read_json(folder / "verify.json");
  results.laws = read_json(folder / "laws.json");
  results.gallery = read_json(folder / "gallery.json");
  results.stability = read_json(folder / "stability.json");
  if (fs::exists(folder / "scenes.json")) results.scenes = read_json(folder / "scenes.json");
  if (fs::exists(folder / "bench.json")) results.bench = read_json(folder / "bench.json");
  if (fs::exists(folder / "matrix.json")) results.matrix = read_json(folder / "matrix.json");
  const fs::path mutants = folder / "mutation_score.json";
  if (fs::exists(mutants)) results.mutants = read_json(mutants);
  write_text(folder / "index.html", page(results));
  std::printf("%s\n", summary_line(results).c_str());
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Writes the report's page, or the data of its plots, from the JSON in its folder.");
  app.footer(
      "Examples:\n"
      "  selvage_page plots reports/out\n"
      "  selvage_page worst reports/out\n"
      "  selvage_page html reports/out --revision \"$(git describe --always)\" --command "
      "reports/run\n\n"
      "Exit codes: 0 written, 1 a mapper of ours in the matrix breaks a law, 2 wrong use or a file "
      "that is missing, damaged or unwritable.");
  std::string folder;
  Results results;
  CLI::App* plots =
      app.add_subcommand("plots", "bench.json to the data of each plot, for plane.gp and curve.gp");
  CLI::App* worst = app.add_subcommand(
      "worst", "stability.json to lines: a picture's name, a tab, what selvage draws it with");
  CLI::App* html = app.add_subcommand("html", "the JSON files to index.html");
  CLI::App* matrix = app.add_subcommand(
      "matrix",
      "the verdicts in its folder matrix, which reports/matrix makes, to matrix.json and a "
      "page of each violation");
  std::string findings;
  matrix->add_option("--findings", findings,
                     "JSON: what is known of subjects and their violations");
  CLI::App* known = app.add_subcommand(
      "known",
      "the cases that its matrix tries first on a row, from the findings and from its folder "
      "corpus, to its folder matrix/known/ID");
  CLI::App* again = app.add_subcommand(
      "again",
      "what its matrix has newly found on a row and has to try on others, to matrix/again/ID");
  again->add_option("--findings", findings, "as for matrix");
  std::string row;
  known->add_option("--findings", findings, "as for matrix");
  known->add_option("--row", row, "the row's ID")->required();
  for (CLI::App* command : {plots, worst, html, matrix, known, again})
    command->add_option("folder", folder)->required();
  html->add_option("--revision", results.revision, "what source this is about");
  html->add_option("--unmeasured", results.unmeasured, "why there is no bench.json");
  html->add_option("--command", results.command, "the commands that make the page");
  app.require_subcommand(1);
  try {
    app.parse(argc, argv);
    if (plots->parsed())
      write_plot_data(folder);
    else if (worst->parsed())
      std::cout << worst_case_lines(read_json(fs::path(folder) / "stability.json"));
    else if (matrix->parsed())
      return write_matrix(folder, findings) ? 0 : 1;
    else if (again->parsed())
      write_again(folder, findings);
    else if (known->parsed())
      write_known(folder, findings, row);
    else
      write_page(folder, std::move(results));
    return 0;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "selvage_page: %s\n", error.what());
    return 2;
  }
}
