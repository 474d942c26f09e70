// Memory whose end, or whose begin, is that of what may be touched.
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <new>

namespace selvage {

// Bytes that end, or begin, at memory whose touch ends the process.
class FencedBytes {
 public:
  enum class Side { kFirst, kLast };

  FencedBytes(size_t bytes, Side side) {
    const auto page = static_cast<size_t>(sysconf(_SC_PAGESIZE));
    const size_t inside = (bytes + page - 1) / page * page;
    length_ = inside + 2 * page;
    void* const all =
        mmap(nullptr, length_, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (all == MAP_FAILED) throw std::bad_alloc();
    pages_ = static_cast<char*>(all);
    mprotect(pages_ + page, inside, PROT_READ | PROT_WRITE);
    first_ = pages_ + page + (side == Side::kLast ? inside - bytes : 0);
  }
  FencedBytes(const FencedBytes&) = delete;
  FencedBytes& operator=(const FencedBytes&) = delete;
  ~FencedBytes() { munmap(pages_, length_); }

  [[nodiscard]] char* first() const { return first_; }

 private:
  char *pages_, *first_;
  size_t length_;
};

}  // namespace selvage
