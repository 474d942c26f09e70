#include "testbed/arena.h"

#include <sys/mman.h>
#include <unistd.h>

#include <new>

namespace selvage::testbed {

Arena::Arena(size_t bytes) {
  const auto page = static_cast<size_t>(sysconf(_SC_PAGESIZE));
  const size_t whole = (bytes + page - 1) / page * page;
  void* all = mmap(nullptr, whole + 2 * kGuardBytes, PROT_NONE,
                   MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (all == MAP_FAILED) throw std::bad_alloc();
  range_.begin = reinterpret_cast<uintptr_t>(all) + kGuardBytes;
  range_.end = range_.begin + whole;
  void* shared = mmap(reinterpret_cast<void*>(range_.begin), whole, PROT_READ | PROT_WRITE,
                      MAP_SHARED | MAP_ANONYMOUS | MAP_FIXED, -1, 0);
  if (shared != MAP_FAILED) return;
  munmap(all, whole + 2 * kGuardBytes);
  throw std::bad_alloc();
}

Arena::~Arena() {
  munmap(reinterpret_cast<void*>(guarded().begin), range_.bytes() + 2 * kGuardBytes);
}

void Arena::make_read_only() const {
  mprotect(reinterpret_cast<void*>(range_.begin), range_.bytes(), PROT_READ);
}

uintptr_t Arena::at_end(size_t bytes, uintptr_t like, size_t unit) const {
  const uintptr_t nearest = range_.end - bytes;
  return nearest - ((nearest - like) & (unit - 1));
}

uintptr_t Arena::at_begin(uintptr_t like, size_t unit) const {
  return range_.begin + ((like - range_.begin) & (unit - 1));
}

}  // namespace selvage::testbed
