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

void Arena::make_writable() const {
  mprotect(reinterpret_cast<void*>(range_.begin), range_.bytes(), PROT_READ | PROT_WRITE);
}

std::optional<uintptr_t> Packer::place(size_t bytes, uintptr_t like, size_t unit) {
  if (bytes > room_.bytes()) return std::nullopt;
  const uintptr_t nearest = from_end_ ? room_.end - bytes : room_.begin;
  const uintptr_t shift = from_end_ ? (nearest - like) & (unit - 1) : (like - nearest) & (unit - 1);
  if (shift > room_.bytes() - bytes) return std::nullopt;
  const uintptr_t at = from_end_ ? nearest - shift : nearest + shift;
  (from_end_ ? room_.end : room_.begin) = from_end_ ? at : at + bytes;
  return at;
}

}  // namespace selvage::testbed
