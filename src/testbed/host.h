// A mapper in a shared library, run in a process of its own: what it does to itself, or to memory
// that is not its own, ends its call and nothing else. This is no sandbox: it may still delete
// files.
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>

#include "selvage.h"
#include "spec/subject.h"

namespace selvage::testbed {

// The library cannot be used; what() tells why and what would be right.
class LibraryError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class Host {
 public:
  // Loads the library; loading, too, must end within the limit. Throws LibraryError.
  Host(const std::filesystem::path& library, std::chrono::nanoseconds call_limit);
  ~Host();
  Host(const Host&) = delete;
  Host& operator=(const Host&) = delete;

  // Draws in the other process, which is forked anew if the last call ended it. Throws
  // spec::SubjectFailure; what was drawn until then is in the target.
  [[nodiscard]] selvage_status draw(const selvage_image* target, const selvage_rect* clip,
                                    const selvage_vertex* vertices, size_t count,
                                    const selvage_texture* texture, const selvage_options* options);

  // Images end at a guard and begin at one in turn; from here on the next call's end there.
  void begin_case();

  // What the library says of itself, or else its file's name and all of the exact profile; its
  // draw() is this host's. Throws LibraryError where it claims what there is not.
  [[nodiscard]] static spec::Subject subject(const std::shared_ptr<Host>& host);

  // The beginning of what it has printed so far, at most 1 MiB.
  [[nodiscard]] std::string printed() const;

 private:
  struct Keeper;
  void load();  // in a process of its own; throws LibraryError

  std::unique_ptr<Keeper> keeper_;
  std::string name_;
  std::chrono::nanoseconds call_limit_;
  bool at_end_ = true;
};

}  // namespace selvage::testbed
