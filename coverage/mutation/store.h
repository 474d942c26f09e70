// What mutants came to, kept from run to run: a file to which a line is added for each.
//
// A mutant is known by its name, which is made of its text, so that it stays the same when sources
// change elsewhere. What it came to holds as long as
//   - nothing has changed at all, or
//   - it lived, and neither its own file nor the laws, the tests or what they may cost have
//   changed.
// Otherwise it is tried again; one that died, first by what killed it.
#pragma once

#include <fstream>
#include <map>
#include <string>

#include "coverage/mutation/trial.h"

namespace selvage::mutation {

// Of what the outcomes are: hashes, words without spaces.
struct Made {
  std::string program;  // all sources and tests, and what they may cost
  std::string judges;   // all of these but the mapper
};

class Store {
 public:
  // Reads the file, if it is there, and writes it anew without what no mutant has any more.
  Store(const std::string& path, Made made, const std::vector<Mutant>& mutants);

  // What still holds of a mutant; nothing if it is to be tried.
  [[nodiscard]] const Outcome* held(const Mutant& mutant) const;
  // What killed it once; nothing if nothing did.
  [[nodiscard]] const Outcome* killer_of(const Mutant& mutant) const;

  void add(const Mutant& mutant, const Outcome& outcome);
  [[nodiscard]] bool is_good() const { return static_cast<bool>(file_); }

 private:
  struct Entry {
    std::string program, text, judges;  // text: of the mutant's file
    Outcome outcome;
  };
  void write(const std::string& name, const Entry& entry);

  Made made_;
  std::map<std::string, Entry> entries_;  // by the mutants' names
  std::ofstream file_;
};

}  // namespace selvage::mutation
