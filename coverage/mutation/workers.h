// Trials side by side: processes that share a list of mutants.
#pragma once

#include <cstddef>
#include <functional>

#include "coverage/mutation/store.h"
#include "coverage/mutation/trial.h"

namespace selvage::mutation {

// Tries them in so many processes and puts what they came to into the store; calls `tell` after
// each, with how many are done and how many of these live. Throws if a process ends before its
// work does: what came until then is in the store.
void try_all(const std::vector<Mutant>& mutants, int jobs, const Trials& trials, Store* store,
             const std::function<void(size_t done, size_t alive)>& tell);

}  // namespace selvage::mutation
