#include "coverage/mutation/store.h"

#include <cstdio>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace selvage::mutation {

Store::Store(const std::string& path, Made made, const std::vector<Mutant>& mutants)
    : made_(std::move(made)) {
  std::map<std::string, Entry> all;
  std::ifstream before(path);
  for (std::string line; std::getline(before, line);) {
    std::istringstream words(line);
    const auto word = [&] {
      std::string text;
      std::getline(words, text, '\t');
      return text;
    };
    const std::string name = word();
    Entry entry{word(), word(), word(), {word(), word(), word()}};
    if (words >> entry.outcome.tried) all[name] = std::move(entry);  // not half a line
  }
  const std::string anew = path + ".new";
  file_.open(anew);
  for (const Mutant& mutant : mutants) {
    const auto found = all.find(mutant.name);
    if (found == all.end()) continue;
    write(mutant.name, found->second);
    entries_.insert(all.extract(found));
  }
  file_.flush();
  if (!file_ || std::rename(anew.c_str(), path.c_str()) != 0) {
    throw std::runtime_error(path + " cannot be written");
  }
}

const Outcome* Store::held(const Mutant& mutant) const {
  const auto found = entries_.find(mutant.name);
  if (found == entries_.end()) return nullptr;
  const Entry& entry = found->second;
  const bool lived = entry.outcome.lived() || !entry.outcome.was_tried();
  const bool same = entry.program == made_.program ||
                    (lived && entry.text == mutant.text && entry.judges == made_.judges);
  return same ? &entry.outcome : nullptr;
}

const Outcome* Store::killer_of(const Mutant& mutant) const {
  const auto found = entries_.find(mutant.name);
  return found == entries_.end() || found->second.outcome.killer.empty() ? nullptr
                                                                         : &found->second.outcome;
}

void Store::add(const Mutant& mutant, const Outcome& outcome) {
  const Entry& entry = entries_[mutant.name] = {made_.program, mutant.text, made_.judges, outcome};
  write(mutant.name, entry);
  file_.flush();
}

void Store::write(const std::string& name, const Entry& entry) {
  const Outcome& outcome = entry.outcome;
  file_ << name << '\t' << entry.program << '\t' << entry.text << '\t' << entry.judges << '\t'
        << outcome.what << '\t' << outcome.killer << '\t' << outcome.on << '\t' << outcome.tried
        << '\n';
}

}  // namespace selvage::mutation
