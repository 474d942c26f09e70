#include <unistd.h>

#include <csignal>
#include <iostream>

#include "cli/command_line.h"
#include "spec/subject.h"

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // writing beyond the user's limit fails, and is told as that
  const selvage::cli::Console console{std::cout, std::cerr, isatty(STDERR_FILENO) != 0,
                                      isatty(STDOUT_FILENO) != 0};
  return selvage::cli::run_program({argv + 1, argv + argc}, selvage::spec::built_in(), console);
}
