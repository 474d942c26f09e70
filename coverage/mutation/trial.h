// One mutant's trial: a process of its own, in which the items run until one is broken.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "coverage/mutation/items.h"

namespace selvage::mutation {

struct Mutant {
  int number = 0, site = 0;  // site: the number of its first alternative
  std::string name, text;    // made of what is changed to what; of its file's text
  std::string path;
};

struct Outcome {
  // killed, crashed, hung, survived; "not reached": no item runs its site; "does not apply": the
  // operands' types lack the operator
  std::string what;
  std::string killer{}, on{};  // of the last item that ran
  size_t tried = 0;            // items

  [[nodiscard]] bool lived() const { return what == "survived" || what == "not reached"; }
  [[nodiscard]] bool was_tried() const { return what != "does not apply"; }
};

// Runs every item once with no mutant, each in a process of its own, noting what it reaches and
// costs; removes those that cost more than most_s, and puts the cheap ones first. Names those that
// are broken although nothing is mutated.
[[nodiscard]] std::vector<std::string> record(std::vector<Item>* items, double most_s);

// Mutants one after another. The item that killed the last one comes first for the next: mutants
// beside each other die of the same.
class Trials {
 public:
  // The items after record(). A mutant that lives for so much processor time survives.
  Trials(std::vector<Item> items, double most_s);

  // `killed_by`: what did so in an earlier run, which is tried first; or nothing.
  [[nodiscard]] Outcome of(const Mutant& mutant, const Outcome* killed_by);

 private:
  void put_first(size_t item);

  std::vector<Item> items_;
  std::vector<size_t> order_;  // in which they are tried
  double most_s_;
};

}  // namespace selvage::mutation
