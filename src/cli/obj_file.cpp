#include "cli/obj_file.h"

#include <tiny_obj_loader.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <span>
#include <sstream>

#include "cli/error.h"
#include "cli/file.h"
#include "cli/obj_lines.h"
#include "cli/picture_file.h"

namespace selvage::cli {
namespace {

// Material libraries beside the OBJ file. What is wrong with one is kept, not thrown through the
// parser.
class LibraryReader : public tinyobj::MaterialReader {
 public:
  explicit LibraryReader(std::filesystem::path folder) : folder_(std::move(folder)) {}

  bool operator()(const std::string& name, std::vector<tinyobj::material_t>* materials,
                  std::map<std::string, int>* indices, std::string* warnings,
                  std::string* errors) override {
    ++read_;
    try {
      std::istringstream text(read_text_file(folder_ / name));
      tinyobj::LoadMtl(indices, materials, &text, warnings, errors);
      return true;
    } catch (const UserError& error) {
      if (problem.empty()) {
        problem = error.what();
        problem_library = read_ - 1;
      }
      return false;
    }
  }

  std::string problem;
  size_t problem_library = 0;  // the how manieth mtllib

 private:
  std::filesystem::path folder_;
  size_t read_ = 0;
};

struct Parsed {
  tinyobj::attrib_t attributes;
  std::vector<tinyobj::shape_t> shapes;
  std::vector<tinyobj::material_t> materials;
};

[[nodiscard]] Parsed parse(const std::filesystem::path& path, const std::string& text,
                           const ObjLines& lines) {
  Parsed parsed;
  LibraryReader libraries(path.parent_path());
  std::istringstream stream(text);
  std::string warnings, errors;
  const bool fine =
      tinyobj::LoadObj(&parsed.attributes, &parsed.shapes, &parsed.materials, &warnings, &errors,
                       &stream, &libraries, /*triangulate=*/false);
  if (!libraries.problem.empty()) {
    const size_t last = lines.libraries.size() - 1;
    throw UserError(path.string() + ":" +
                    std::to_string(lines.libraries[std::min(libraries.problem_library, last)]) +
                    ": " + libraries.problem);
  }
  if (!fine) throw UserError(path.string() + ": " + errors);
  return parsed;
}

void expect_materials(const Parsed& parsed, const std::string& file, const ObjLines& lines) {
  for (const auto& [line, name] : lines.materials) {
    const bool known =
        std::any_of(parsed.materials.begin(), parsed.materials.end(),
                    [&, &wanted = name](const auto& material) { return material.name == wanted; });
    if (known) continue;
    throw UserError(file + ":" + std::to_string(line) + ": usemtl " + name +
                    ": there is no such material");
  }
}

[[nodiscard]] uint8_t level(double part) {
  return static_cast<uint8_t>(std::floor(255 * std::clamp(part, 0.0, 1.0) + 0.5));
}

[[nodiscard]] scene::TextureImage read_texture(const std::filesystem::path& path, bool clamp) {
  Raster raster = read_picture(path);
  return {raster.width_px, raster.height_px, std::move(raster.rgba),
          clamp ? SELVAGE_ADDRESS_CLAMP : SELVAGE_ADDRESS_WRAP};
}

[[nodiscard]] scene::Material material_of(const tinyobj::material_t& source,
                                          const std::filesystem::path& folder,
                                          const TextureFiles& textures, scene::Scene& scene) {
  scene::Material material;
  material.name = source.name;
  material.colour = {level(source.diffuse[0]), level(source.diffuse[1]), level(source.diffuse[2])};
  material.shading = source.illum >= 1 ? scene::Shading::kDiffuse : scene::Shading::kFlat;
  if (!source.diffuse_texname.empty()) {
    const auto other = textures.find(source.name);
    const std::filesystem::path path =
        other == textures.end() ? folder / source.diffuse_texname : other->second;
    material.texture = scene.textures.size();
    scene.textures.push_back(about("material '" + source.name + "'", [&] {
      return read_texture(path, source.diffuse_texopt.clamp);
    }));
  }
  return material;
}

// Texels; where the texture wraps, whole periods are taken off so that the face begins in the
// first.
void set_texture(scene::Face& face, const std::vector<scene::Vector2>& uv,
                 const scene::TextureImage& image) {
  const scene::Vector2 size(image.width_texel, image.height_texel);
  scene::Vector2 least = uv.front();
  for (const scene::Vector2& corner : uv) least = least.cwiseMin(corner);
  const bool wraps = image.address == SELVAGE_ADDRESS_WRAP;
  const scene::Vector2 periods =
      wraps ? scene::Vector2(least.array().floor()) : scene::Vector2(scene::Vector2::Zero());
  for (size_t i = 0; i < uv.size(); ++i) {
    face.corners[i].texture_texel = (uv[i] - periods).cwiseProduct(size);
  }
}

[[nodiscard]] bool is_index(int index, size_t numbers, size_t of) {
  return index >= 0 && static_cast<size_t>(index) < numbers / of;
}

[[nodiscard]] scene::Face face_of(const Parsed& parsed, std::span<const tinyobj::index_t> corners,
                                  const std::optional<size_t>& texture, const scene::Scene& scene) {
  scene::Face face;
  std::vector<scene::Vector2> uv;
  for (const tinyobj::index_t& corner : corners) {
    if (!is_index(corner.vertex_index, parsed.attributes.vertices.size(), 3)) {
      throw UserError("there is no such vertex");
    }
    face.corners.push_back({static_cast<size_t>(corner.vertex_index), {0, 0}});
    if (!texture) continue;
    if (!is_index(corner.texcoord_index, parsed.attributes.texcoords.size(), 2)) {
      throw UserError("its material has a texture, and a corner no texture coordinates");
    }
    const double* at = &parsed.attributes.texcoords[static_cast<size_t>(corner.texcoord_index) * 2];
    uv.emplace_back(at[0], 1 - at[1]);
  }
  if (texture) set_texture(face, uv, scene.textures[*texture]);
  return face;
}

void add_faces(const Parsed& parsed, const std::string& file, const ObjLines& lines,
               const scene::Scene& scene, scene::Object& object) {
  size_t count = 0;
  for (const tinyobj::shape_t& shape : parsed.shapes) {
    size_t first = 0;
    for (size_t i = 0; i < shape.mesh.num_face_vertices.size(); ++i, ++count) {
      const size_t corners = shape.mesh.num_face_vertices[i];
      const int material = shape.mesh.material_ids[i];
      const std::string line =
          count < lines.faces.size() ? std::to_string(lines.faces[count]) : "?";
      about(file + ":" + line, [&] {
        const size_t used =
            material < 0 ? object.materials.size() - 1 : static_cast<size_t>(material);
        scene::Face face = face_of(parsed, std::span(shape.mesh.indices).subspan(first, corners),
                                   object.materials[used].texture, scene);
        face.material = used;
        if (!is_convex(object, face)) throw UserError("the face is not convex; cut it into such");
        object.faces.push_back(std::move(face));
      });
      first += corners;
    }
  }
  if (object.faces.empty()) throw UserError(file + ": there is no face in it");
}

}  // namespace

scene::Object read_obj(const std::filesystem::path& path, const TextureFiles& textures,
                       scene::Scene& scene) {
  const std::string text = read_text_file(path), file = path.string();
  const ObjLines lines = check_obj_lines(file, text);
  const Parsed parsed = parse(path, text, lines);
  expect_materials(parsed, file, lines);
  scene::Object object;
  object.name = path.stem().string();
  const std::vector<double>& v = parsed.attributes.vertices;
  for (size_t i = 0; i + 2 < v.size(); i += 3)
    object.vertices.emplace_back(v[i], v[i + 1], v[i + 2]);
  for (const tinyobj::material_t& material : parsed.materials) {
    object.materials.push_back(
        about(file, [&] { return material_of(material, path.parent_path(), textures, scene); }));
  }
  object.materials.emplace_back();  // of faces before any usemtl
  object.materials.back().colour = {204, 204, 204};
  add_faces(parsed, file, lines, scene, object);
  return object;
}

}  // namespace selvage::cli
