#include "cli/mtl_libraries.h"

#include <algorithm>
#include <set>
#include <utility>

#include "cli/error.h"
#include "cli/statement.h"

namespace selvage::cli {
namespace {

[[nodiscard]] std::string text_of(const std::filesystem::path& library, const ObjLibraries& asked,
                                  const SceneFiles& files) {
  try {
    return files.text(library);
  } catch (const UserError& error) {
    if (asked.words.size() == 1) throw;
    throw UserError(std::string(error.what()) + "; nor is there a file " + quoted(asked.whole));
  }
}

void add_library(const std::filesystem::path& library, const std::string& text,
                 MtlLibraries& libraries) {
  const std::string file = library.string();
  MtlLines lines = check_mtl_lines(file, text);
  for (MtlMaterial& material : lines.materials) {
    const std::string& name = material.name;
    if (const MtlPlace* other = libraries.find(name)) {
      throw UserError(file + ":" + std::to_string(material.line) + ": newmtl: " + quoted(name) +
                      " stands in " + other->file + ":" + std::to_string(other->material.line) +
                      " too; give one of them another name");
    }
    libraries.materials.push_back({file, std::move(material)});
  }
  libraries.texts.push_back(std::move(lines.statements));
}

}  // namespace

const MtlPlace* MtlLibraries::find(const std::string& name) const {
  const auto at = std::ranges::find(
      materials, name,
      [](const MtlPlace& place) -> const std::string& { return place.material.name; });
  return at == materials.end() ? nullptr : &*at;
}

MtlLibraries read_libraries(const std::filesystem::path& obj, std::span<const ObjLibraries> asked,
                            const SceneFiles& files) {
  const std::filesystem::path folder = obj.parent_path();
  MtlLibraries libraries;
  std::set<std::filesystem::path> known;
  for (const ObjLibraries& some : asked) {
    const bool is_one = files.has(folder / some.whole);
    for (const std::string& name : is_one ? std::vector{some.whole} : some.words) {
      const std::filesystem::path library = folder / name;
      if (!known.insert(library.lexically_normal()).second) continue;
      const std::string text = about(obj.string() + ":" + std::to_string(some.line) + ": mtllib",
                                     [&] { return text_of(library, some, files); });
      add_library(library, text, libraries);
    }
  }
  return libraries;
}

}  // namespace selvage::cli
