#include "testbed/functions.h"

#include <dlfcn.h>
#include <link.h>

namespace selvage::testbed {
namespace {

// The library that an address lies in; null if in none.
[[nodiscard]] const link_map* library_of(void* address) {
  Dl_info info{};
  link_map* library = nullptr;
  const int found = dladdr1(address, &info, reinterpret_cast<void**>(&library), RTLD_DL_LINKMAP);
  return found != 0 ? library : nullptr;
}

template <class Pointer>
[[nodiscard]] Pointer find(void* library, Function function, const link_map* in) {
  void* address = dlsym(library, name_of(function));
  const bool counts = address != nullptr && (in == nullptr || library_of(address) == in);
  return counts ? reinterpret_cast<Pointer>(address) : nullptr;
}

}  // namespace

Functions find_functions(void* library) {
  Functions found;
  found.draw = find<decltype(found.draw)>(library, Function::kDraw, nullptr);
  if (found.draw == nullptr) return found;
  const link_map* in = library_of(reinterpret_cast<void*>(found.draw));
  const auto take = [&]<class Pointer>(Function function, Pointer* pointer) {
    *pointer = find<Pointer>(library, function, in);
  };
  take(Function::kDrawMany, &found.draw_many);
  take(Function::kDrawManyBytes, &found.draw_many_bytes);
  take(Function::kPrepare, &found.prepare);
  take(Function::kPrepareBytes, &found.prepare_bytes);
  take(Function::kChoose, &found.choose);
  return found;
}

std::string fault_of(const Functions& functions) {
  if (functions.draw == nullptr) {
    return "it exports no selvage_draw: the function of selvage.h, with C linkage and default "
           "visibility";
  }
  const auto fault = [](bool has, bool has_bytes, Function function, Function bytes) {
    if (has == has_bytes) return std::string();
    return std::string("it exports ") + name_of(has ? function : bytes) + " and no " +
           name_of(has ? bytes : function) + "; both are needed, or neither";
  };
  const std::string many =
      fault(functions.draw_many != nullptr, functions.draw_many_bytes != nullptr,
            Function::kDrawMany, Function::kDrawManyBytes);
  return !many.empty() ? many
                       : fault(functions.prepare != nullptr, functions.prepare_bytes != nullptr,
                               Function::kPrepare, Function::kPrepareBytes);
}

uint32_t exported(const Functions& functions) {
  const auto bit = [](bool has, Function function) { return has ? bit_of(function) : 0; };
  return bit(functions.draw != nullptr, Function::kDraw) |
         bit(functions.draw_many != nullptr, Function::kDrawMany) |
         bit(functions.draw_many_bytes != nullptr, Function::kDrawManyBytes) |
         bit(functions.prepare != nullptr, Function::kPrepare) |
         bit(functions.prepare_bytes != nullptr, Function::kPrepareBytes) |
         bit(functions.choose != nullptr, Function::kChoose);
}

Answer carry_out(const Functions& functions, const Call& call) {
  const selvage_polygon one = call.polygons != nullptr ? call.polygons[0] : selvage_polygon{};
  switch (call.function) {
    case Function::kDraw:
      return {functions.draw(call.target, call.clip, one.vertices, one.count, one.texture,
                             call.options)};
    case Function::kChoose:
      return {functions.choose(call.target, call.clip, one.vertices, one.count, one.texture,
                               call.options, call.choice)};
    case Function::kDrawMany:
      return {functions.draw_many(call.target, call.clip, call.polygons, call.count, call.options,
                                  call.threads, call.memory, call.bytes, call.failed)};
    case Function::kDrawManyBytes:
      return {.bytes = functions.draw_many_bytes(call.count)};
    case Function::kPrepare:
      return {functions.prepare(one.texture, call.layout, call.with_sums, call.memory, call.bytes,
                                call.prepared)};
    case Function::kPrepareBytes:
      return {.bytes = functions.prepare_bytes(one.texture, call.layout, call.with_sums)};
  }
  return {};
}

}  // namespace selvage::testbed
