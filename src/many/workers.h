// Workers: the only room that knows of threads. share_out.h and band_draw.cpp build on it.
#pragma once

#include <cstddef>
#include <cstdint>

namespace selvage::many {

// As many as `threads` asks for, 0 being as many as the machine runs at a time; 1 in a build
// without oneTBB.
[[nodiscard]] int32_t worker_count(int32_t threads);

using Work = void (*)(void* context, size_t worker);

// Calls work(context, worker), on the caller's thread and at the same time on up to `workers` - 1
// others, as far as the machine has them. `worker` is below `workers`, another one in each call but
// for one that may come twice, and mostly 0 on the caller's thread. Returns when all calls have;
// there is at least one. They see what the caller wrote before, and the caller what they wrote.
// Work must not throw.
void run_workers(int32_t workers, Work work, void* context);

// What a worker calls again and again while it waits for another one: the machine may run others.
void wait_a_little();

}  // namespace selvage::many
