// A mapper in a shared library, run in a process of its own: what it does to itself, or to memory
// that is not its own, ends its call and nothing else. This is no sandbox: it may still delete
// files.
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>

#include "selvage.h"
#include "spec/subject.h"

namespace selvage::testbed {

struct Answer;
struct Arenas;
struct Call;
struct Control;
class Placement;

// The library cannot be used; what() tells why and what would be right.
class LibraryError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Its calls are made in the other process, which is forked anew if the last one ended it. They
// throw spec::SubjectFailure; what was drawn until then is in the target.
class Host {
 public:
  // Loads the library; loading, too, must end within the limit. Throws LibraryError.
  Host(const std::filesystem::path& library, std::chrono::nanoseconds call_limit);
  ~Host();
  Host(const Host&) = delete;
  Host& operator=(const Host&) = delete;

  [[nodiscard]] selvage_status draw(const selvage_image* target, const selvage_rect* clip,
                                    const selvage_vertex* vertices, size_t count,
                                    const selvage_texture* texture, const selvage_options* options);

  // These are there to be called where the library exports them.
  [[nodiscard]] selvage_status draw_many(const selvage_image* target, const selvage_rect* clip,
                                         const selvage_polygon* polygons, size_t count,
                                         const selvage_options* options, int32_t threads,
                                         size_t* failed);
  [[nodiscard]] selvage_status choose(const selvage_image* target, const selvage_rect* clip,
                                      const selvage_vertex* vertices, size_t count,
                                      const selvage_texture* texture,
                                      const selvage_options* options, selvage_choice* choice);
  [[nodiscard]] size_t prepare_bytes(const selvage_texture* source, selvage_layout layout,
                                     int32_t with_sums);
  // The memory is the caller's, and so is what is prepared in it; drawing goes by a copy that the
  // subject alone sees, until it is released.
  [[nodiscard]] selvage_status prepare(const selvage_texture* source, selvage_layout layout,
                                       int32_t with_sums, void* memory, size_t bytes,
                                       selvage_texture* prepared);
  void release(const void* memory);

  // Images end at a guard and begin at one in turn; from here on the next call's end there.
  void begin_case();
  // The next call is in a process that nothing has been drawn in.
  void start_anew();

  // What the library says of itself, or else its file's name and all of the exact profile; its
  // calls are this host's. Throws LibraryError where it claims what there is not.
  [[nodiscard]] static spec::Subject subject(const std::shared_ptr<Host>& host);

  // Whether it exports selvage_subject.
  [[nodiscard]] bool tells_claims() const;
  // The beginning of what it has printed so far, at most 1 MiB.
  [[nodiscard]] std::string printed() const;

 private:
  struct Keeper;
  struct Blocks;  // that textures were prepared in
  [[nodiscard]] std::string load();
  void have_worker(const Call& call, const Placement& placement);
  [[nodiscard]] Answer call(const Call& call);
  [[nodiscard]] const Arenas& arenas() const;
  [[nodiscard]] const Control& control() const;

  std::unique_ptr<Keeper> keeper_;
  std::unique_ptr<Blocks> blocks_;
  std::string name_;
  std::chrono::nanoseconds call_limit_;
  bool at_end_ = true;
};

}  // namespace selvage::testbed
