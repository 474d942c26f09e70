// Tasks with numbers, shared out among workers.
#pragma once

#include <cstddef>
#include <cstdint>

namespace selvage::many {

using Task = void (*)(const void* context, size_t index);

// Calls task(context, i) once for each i in [0, count). Each of several workers begins with i that
// are neighbours, with the same ones in each call of as many of both. Returns when all calls have;
// what they wrote is then seen by the caller. A task must not throw.
void share_out(size_t count, int32_t workers, Task task, const void* context);

// The same for anything that can be called with an index.
template <class Body>
void share_out(size_t count, int32_t workers, const Body& body) {
  const Task task = [](const void* context, size_t index) {
    (*static_cast<const Body*>(context))(index);
  };
  share_out(count, workers, task, &body);
}

}  // namespace selvage::many
