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
#include "cli/mtl_libraries.h"
#include "cli/obj_lines.h"
#include "cli/picture_file.h"
#include "cli/statement.h"
#include "scene/face_shape.h"
#include "scene/problem.h"

namespace selvage::cli {
namespace {

// Gives the parser a library for each "mtllib NUMBER".
class LibraryReader : public tinyobj::MaterialReader {
 public:
  explicit LibraryReader(const std::vector<std::string>& texts) : texts_(texts) {}

  bool operator()(const std::string& number, std::vector<tinyobj::material_t>* materials,
                  std::map<std::string, int>* indices, std::string* warnings,
                  std::string* errors) override {
    std::istringstream text(texts_.at(std::stoul(number)));
    tinyobj::LoadMtl(indices, materials, &text, warnings, errors);
    return true;
  }

 private:
  const std::vector<std::string>& texts_;
};

struct Parsed {
  tinyobj::attrib_t attributes;
  std::vector<tinyobj::shape_t> shapes;
  std::vector<tinyobj::material_t> materials;
};

[[nodiscard]] Parsed parse(const std::string& file, const ObjLines& lines,
                           const MtlLibraries& libraries) {
  Parsed parsed;
  LibraryReader reader(libraries.texts);
  std::string statements;  // a material may be used before its library stands in the file
  for (size_t i = 0; i < libraries.texts.size(); ++i) {
    statements += "mtllib " + std::to_string(i) + '\n';
  }
  std::istringstream stream(statements + lines.statements);
  std::string warnings, errors;
  if (!tinyobj::LoadObj(&parsed.attributes, &parsed.shapes, &parsed.materials, &warnings, &errors,
                        &stream, &reader, /*triangulate=*/false)) {
    throw UserError(file + ": " + errors);
  }
  return parsed;
}

void expect_materials(const MtlLibraries& libraries, const std::string& file,
                      const ObjLines& lines) {
  for (const auto& [line, name] : lines.materials) {
    if (libraries.find(name) != nullptr) continue;
    throw UserError(file + ":" + std::to_string(line) + ": usemtl: " + quoted(name) +
                    ": there is no such material");
  }
}

[[nodiscard]] uint8_t level(double part) {
  return static_cast<uint8_t>(std::floor(255 * std::clamp(part, 0.0, 1.0) + 0.5));
}

[[nodiscard]] scene::TextureImage read_texture(const std::filesystem::path& path, bool clamp,
                                               const SceneFiles& files) {
  const std::vector<uint8_t> bytes = files.bytes(path);
  Raster raster = about("'" + path.string() + "'", [&] { return decode_picture(bytes); });
  return {raster.width_px, raster.height_px, std::move(raster.rgba),
          clamp ? SELVAGE_ADDRESS_CLAMP : SELVAGE_ADDRESS_WRAP};
}

[[nodiscard]] scene::Material material_of(const tinyobj::material_t& source, const MtlPlace& place,
                                          const SceneFiles& files, const OtherPictures& others,
                                          scene::Scene& scene) {
  scene::Material material;
  material.name = place.material.name;
  material.colour = {level(source.diffuse[0]), level(source.diffuse[1]), level(source.diffuse[2])};
  material.shading = source.illum >= 1 ? scene::Shading::kDiffuse : scene::Shading::kFlat;
  if (source.diffuse_texname.empty()) return material;
  material.texture = scene.textures.size();
  const bool clamp = source.diffuse_texopt.clamp;
  const auto other = others.find(material.name);
  const bool is_own = other == others.end();
  const std::string asked_by =
      is_own ? place.file + ":" + std::to_string(place.material.texture_line) + ": map_Kd"
             : other->second.asked_by;
  const std::filesystem::path path =
      is_own ? std::filesystem::path(place.file).parent_path() / source.diffuse_texname
             : other->second.path;
  scene.textures.push_back(about(asked_by, [&] { return read_texture(path, clamp, files); }));
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
    const scene::Vector2 texel = (uv[i] - periods).cwiseProduct(size);
    if (!scene::is_texture_place(texel)) {
      throw UserError("the face has texture coordinates beyond 32767 texels");
    }
    face.corners[i].texture_texel = texel;
  }
}

[[nodiscard]] bool is_index(int index, size_t numbers, size_t of) {
  return index >= 0 && static_cast<size_t>(index) < numbers / of;
}

// "there is no vertex 9; the file has 5", for an index as it is written.
[[nodiscard]] UserError no_such(const std::string& what, int index, size_t count) {
  return UserError("there is no " + what + " " + std::to_string(index) + "; " +
                   (index < 0 ? "fewer stand before it" : "the file has " + std::to_string(count)));
}

void expect_corner(const Parsed& parsed, const tinyobj::index_t& read, const ObjCorner& written,
                   bool has_texture) {
  const size_t vertices = parsed.attributes.vertices.size();
  if (!is_index(read.vertex_index, vertices, 3)) {
    throw no_such("vertex", written.vertex, vertices / 3);
  }
  const size_t texcoords = parsed.attributes.texcoords.size();
  if (!has_texture || is_index(read.texcoord_index, texcoords, 2)) return;
  if (written.texture != 0) throw no_such("vt", written.texture, texcoords / 2);
  throw UserError("its material has a texture, and it no texture coordinates");
}

[[nodiscard]] scene::Face face_of(const Parsed& parsed, std::span<const tinyobj::index_t> corners,
                                  const ObjFace& written, const std::optional<size_t>& texture,
                                  const scene::Scene& scene) {
  scene::Face face;
  std::vector<scene::Vector2> uv;
  for (size_t i = 0; i < corners.size(); ++i) {
    const tinyobj::index_t& corner = corners[i];
    about("f: corner " + std::to_string(i + 1),
          [&] { expect_corner(parsed, corner, written.corners[i], texture.has_value()); });
    face.corners.push_back({static_cast<size_t>(corner.vertex_index), {0, 0}});
    if (!texture) continue;
    const double* at = &parsed.attributes.texcoords[static_cast<size_t>(corner.texcoord_index) * 2];
    uv.emplace_back(at[0], 1 - at[1]);
  }
  if (texture) set_texture(face, uv, scene.textures[*texture]);
  return face;
}

// The faces of a shape. The parser may keep their numbers of corners in 8 bits: they are taken from
// the lines.
[[nodiscard]] std::span<const ObjFace> faces_of(const tinyobj::mesh_t& mesh, const ObjLines& lines,
                                                size_t first, const std::string& file) {
  const std::span<const ObjFace> faces =
      std::span(lines.faces).subspan(std::min(first, lines.faces.size()));
  const size_t count = mesh.num_face_vertices.size();
  size_t corners = 0;
  for (const ObjFace& face : faces.first(std::min(count, faces.size())))
    corners += face.corners.size();
  if (count > faces.size() || corners != mesh.indices.size()) {
    throw UserError(file + ": its faces are not read as they stand in it");
  }
  return faces.first(count);
}

void add_vertices(const Parsed& parsed, const std::string& file, const ObjLines& lines,
                  scene::Object& object) {
  const std::vector<double>& v = parsed.attributes.vertices;
  for (size_t i = 0; i < v.size() / 3; ++i) {
    object.vertices.emplace_back(v[3 * i], v[3 * i + 1], v[3 * i + 2]);
    if (scene::is_near(object.vertices.back())) continue;
    throw UserError(file + ":" + std::to_string(lines.vertices.at(i)) +
                    ": v: farther than 1000000000 from the origin");
  }
}

void add_faces(const Parsed& parsed, const std::string& file, const ObjLines& lines,
               const scene::Scene& scene, scene::Object& object) {
  const double rounding = corner_rounding(object);
  for (const tinyobj::shape_t& shape : parsed.shapes) {
    std::span<const tinyobj::index_t> corners = shape.mesh.indices;
    const int* material = shape.mesh.material_ids.data();
    for (const ObjFace& at : faces_of(shape.mesh, lines, object.faces.size(), file)) {
      about(file + ":" + std::to_string(at.line), [&] {
        const size_t used =
            *material < 0 ? object.materials.size() - 1 : static_cast<size_t>(*material);
        scene::Face face = face_of(parsed, corners.first(at.corners.size()), at,
                                   object.materials[used].texture, scene);
        face.material = used;
        const std::string fault = shape_problem(object, face, rounding);
        if (!fault.empty()) throw UserError("f: the face " + fault);
        object.faces.push_back(std::move(face));
      });
      corners = corners.subspan(at.corners.size());
      ++material;
    }
  }
  if (object.faces.empty()) throw UserError(file + ": there is no face in it");
}

}  // namespace

std::vector<uint8_t> SceneFiles::bytes(const std::filesystem::path& path) const {
  return read ? read(path) : read_file(path);
}

std::string SceneFiles::text(const std::filesystem::path& path) const {
  const std::vector<uint8_t> all = bytes(path);
  return {all.begin(), all.end()};
}

bool SceneFiles::has(const std::filesystem::path& path) const {
  std::error_code ignored;
  return read || std::filesystem::exists(path, ignored);
}

scene::Object read_obj(const std::filesystem::path& path, const std::string& text,
                       const SceneFiles& files, const OtherPictures& others, scene::Scene& scene) {
  const std::string file = path.string();
  const ObjLines lines = check_obj_lines(file, text);
  const MtlLibraries libraries = read_libraries(path, lines.libraries, files);
  const Parsed parsed = parse(file, lines, libraries);
  expect_materials(libraries, file, lines);
  scene::Object object;
  object.name = path.stem().string();
  add_vertices(parsed, file, lines, object);
  for (size_t i = 0; i < parsed.materials.size(); ++i) {
    object.materials.push_back(
        material_of(parsed.materials[i], libraries.materials.at(i), files, others, scene));
  }
  object.materials.emplace_back();  // of faces before any usemtl
  object.materials.back().colour = {204, 204, 204};
  add_faces(parsed, file, lines, scene, object);
  return object;
}

}  // namespace selvage::cli
