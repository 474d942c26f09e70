// The calls of a host: draw_many with scratch memory, prepare with memory that stays where it is.
#include <algorithm>
#include <cstddef>
#include <cstring>

#include "testbed/claims.h"
#include "testbed/fence.h"
#include "testbed/host_state.h"
#include "testbed/printable.h"

namespace selvage::testbed {
namespace {

[[nodiscard]] spec::SubjectFailure failure(Function function, std::string happened) {
  return {std::move(happened), false, name_of(function)};
}

[[nodiscard]] Range range_at(uintptr_t begin, size_t bytes) { return {begin, begin + bytes}; }

// An arena that no prepared texture lies in.
[[nodiscard]] const Arena& free_arena(const Arenas& arenas, const std::vector<Placed>& taken) {
  for (const Arena& arena : arenas.prepared) {
    const auto is_in = [&](const Placed& block) { return arena.range().holds(block.range()); };
    if (std::ranges::none_of(taken, is_in)) return arena;
  }
  throw spec::NotClaimed{"more textures prepared at a time than can be handed on"};
}

// What was prepared at `placed`, as its caller sees it.
[[nodiscard]] selvage_texture seen_by_caller(const selvage_texture& texture, const Placed& placed) {
  const Range given = placed.range();
  const auto moved = [&](const void* pointer, const char* what) -> const void* {
    const auto address = reinterpret_cast<uintptr_t>(pointer);
    if (address < given.begin || address >= given.end) {
      throw failure(Function::kPrepare, std::string("prepared a texture whose ") + what +
                                            " lie outside of the memory that it was given");
    }
    return reinterpret_cast<const void*>(address - given.begin + placed.from.begin);
  };
  selvage_texture seen = texture;
  seen.texels = moved(texture.texels, "texels");
  if (texture.prepared != nullptr) seen.prepared = moved(texture.prepared, "sums");
  return seen;
}

}  // namespace

selvage_status Host::draw(const selvage_image* target, const selvage_rect* clip,
                          const selvage_vertex* vertices, size_t count,
                          const selvage_texture* texture, const selvage_options* options) {
  const selvage_polygon polygon{vertices, count, texture};
  return call(
             {.target = target, .clip = clip, .polygons = &polygon, .count = 1, .options = options})
      .status;
}

selvage_status Host::choose(const selvage_image* target, const selvage_rect* clip,
                            const selvage_vertex* vertices, size_t count,
                            const selvage_texture* texture, const selvage_options* options,
                            selvage_choice* choice) {
  const selvage_polygon polygon{vertices, count, texture};
  return call({.function = Function::kChoose,
               .target = target,
               .clip = clip,
               .polygons = &polygon,
               .count = 1,
               .options = options,
               .choice = choice})
      .status;
}

selvage_status Host::draw_many(const selvage_image* target, const selvage_rect* clip,
                               const selvage_polygon* polygons, size_t count,
                               const selvage_options* options, int32_t threads, size_t* failed) {
  const size_t bytes = call({.function = Function::kDrawManyBytes, .count = count}).bytes;
  const Range room = arenas().scratch.range();
  const auto at = Packer(room, at_end_).place(bytes, 0, alignof(std::max_align_t));
  if (!at) throw spec::NotClaimed{"more scratch memory than can be handed on"};
  const Fence fence(room, range_at(*at, bytes));
  const Answer answer = call({.function = Function::kDrawMany,
                              .target = target,
                              .clip = clip,
                              .polygons = polygons,
                              .count = count,
                              .options = options,
                              .threads = threads,
                              .memory = reinterpret_cast<void*>(*at),
                              .bytes = bytes,
                              .failed = failed});
  const std::string fault = fence.fault("scratch memory");
  if (!fault.empty()) throw failure(Function::kDrawMany, fault);
  return answer.status;
}

size_t Host::prepare_bytes(const selvage_texture* source, selvage_layout layout,
                           int32_t with_sums) {
  const selvage_polygon polygon{nullptr, 0, source};
  const size_t bytes = call({.function = Function::kPrepareBytes,
                             .polygons = &polygon,
                             .count = 1,
                             .layout = layout,
                             .with_sums = with_sums})
                           .bytes;
  if (bytes != SIZE_MAX && bytes > arenas().prepared[0].range().bytes()) {
    throw spec::NotClaimed{"more memory to prepare in than can be handed on"};
  }
  return bytes;
}

selvage_status Host::prepare(const selvage_texture* source, selvage_layout layout,
                             int32_t with_sums, void* memory, size_t bytes,
                             selvage_texture* prepared) {
  const selvage_polygon polygon{nullptr, 0, source};
  selvage_texture found = *prepared;
  Call call{.function = Function::kPrepare,
            .polygons = &polygon,
            .count = 1,
            .layout = layout,
            .with_sums = with_sums,
            .memory = memory,
            .bytes = bytes,
            .prepared = &found};
  if (memory == nullptr) return this->call(call).status;
  release(memory);
  const Range room = free_arena(arenas(), blocks_->placed).range();
  const Range from = range_at(reinterpret_cast<uintptr_t>(memory), bytes);
  const auto at =
      Packer(room, blocks_->at_end).place(bytes, from.begin, SELVAGE_PREPARED_ALIGNMENT);
  if (!at) throw spec::NotClaimed{"more memory to prepare in than can be handed on"};
  blocks_->at_end = !blocks_->at_end;
  const Placed placed{from, *at};
  const Fence fence(room, placed.range());
  call.memory = reinterpret_cast<void*>(*at);
  std::memcpy(call.memory, memory, bytes);
  const Answer answer = this->call(call);
  std::memcpy(memory, call.memory, bytes);
  const std::string fault = fence.fault("memory to prepare in");
  if (!fault.empty()) throw failure(Function::kPrepare, fault);
  if (answer.status != SELVAGE_OK) return answer.status;
  *prepared = seen_by_caller(found, placed);
  blocks_->placed.push_back(placed);
  return answer.status;
}

void Host::release(const void* memory) {
  std::erase_if(blocks_->placed, [address = reinterpret_cast<uintptr_t>(memory)](
                                     const Placed& block) { return block.from.begin == address; });
}

spec::Subject Host::subject(const std::shared_ptr<Host>& host) {
  const Control& control = host->control();
  spec::Subject subject;
  try {
    if (control.has_claims) subject = claimed(control.claims);
  } catch (const LibraryError& error) {
    throw LibraryError("cannot use '" + printable(host->name_) + "' as a subject: " + error.what());
  }
  subject.name = control.name[0] != '\0'
                     ? control.name.data()
                     : printable(std::filesystem::path(host->name_).filename().string());
  if (control.version[0] != '\0') subject.name += " " + std::string(control.version.data());
  subject.draw = [host](auto... arguments) { return host->draw(arguments...); };
  subject.begin_case = [host] { host->begin_case(); };
  subject.start_anew = [host] { host->start_anew(); };
  const auto has = [&](Function function) { return (control.exported & bit_of(function)) != 0; };
  if (has(Function::kDrawMany)) {
    subject.draw_many = [host](auto... arguments) { return host->draw_many(arguments...); };
  }
  if (has(Function::kChoose)) {
    subject.choose = [host](auto... arguments) { return host->choose(arguments...); };
  }
  if (has(Function::kPrepare)) {
    subject.prepare = {
        .prepare = [host](auto... arguments) { return host->prepare(arguments...); },
        .bytes = [host](auto... arguments) { return host->prepare_bytes(arguments...); },
        .release = [host](const void* memory) { host->release(memory); }};
  }
  return subject;
}

}  // namespace selvage::testbed
