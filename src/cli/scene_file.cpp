#include "cli/scene_file.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <string>

#include "cli/error.h"
#include "cli/job.h"
#include "cli/located_json.h"
#include "cli/obj_file.h"
#include "cli/raster.h"
#include "scene/problem.h"

namespace selvage::cli {
namespace {

[[nodiscard]] scene::Vector3 to_vector(const JsonNode& node) {
  const std::array<double, 3> parts = node.vector();
  return {parts[0], parts[1], parts[2]};
}

void set(const JsonNode& node, const char* key, double& value) {
  if (node.has(key)) value = node.at(key).number();
}
void set(const JsonNode& node, const char* key, scene::Vector3& value) {
  if (node.has(key)) value = to_vector(node.at(key));
}

// What would keep a part of the scene from being drawn is the fault of the key that names it, or of
// the node where it is left out.
template <typename Part>
void expect_no_fault(const JsonNode& node, const Part& part) {
  const std::optional<scene::Fault> fault = scene::fault(part);
  if (!fault) return;
  if (node.has(fault->key)) node.at(fault->key).fail(fault->what);
  node.fail(fault->key + " " + fault->what);
}

[[nodiscard]] scene::Camera camera_of(const JsonNode& node) {
  node.expect_keys({"position", "target", "up", "view_deg", "nearest", "farthest"});
  scene::Camera camera;
  set(node, "position", camera.position);
  set(node, "target", camera.target);
  set(node, "up", camera.up);
  set(node, "view_deg", camera.view_deg);
  set(node, "nearest", camera.nearest_w);
  set(node, "farthest", camera.farthest_w);
  expect_no_fault(node, camera);
  return camera;
}

[[nodiscard]] scene::Lamp lamp_of(const JsonNode& node) {
  node.expect_keys({"towards", "level"});
  scene::Lamp lamp;
  lamp.towards = to_vector(node.at("towards"));
  set(node, "level", lamp.level);
  expect_no_fault(node, lamp);
  return lamp;
}

[[nodiscard]] scene::Motion motion_of(const JsonNode& node) {
  scene::Motion motion;
  set(node, "position", motion.position);
  set(node, "velocity", motion.velocity);
  set(node, "axis", motion.axis);
  set(node, "angle_deg", motion.angle_deg);
  set(node, "spin_deg", motion.spin_deg);
  set(node, "scale", motion.scale);
  expect_no_fault(node, motion);
  return motion;
}

void expect_near(const JsonNode& scale, const scene::Object& object) {
  for (const scene::Vector3& vertex : object.vertices) {
    if (scene::is_near(vertex * object.motion.scale)) continue;
    scale.fail("puts a vertex farther than 1000000000 from the object's origin");
  }
}

[[nodiscard]] scene::Shading shading_of(const JsonNode& node) {
  if (node.text() == "flat") return scene::Shading::kFlat;
  if (node.text() == "ambient") return scene::Shading::kAmbient;
  if (node.text() == "diffuse") return scene::Shading::kDiffuse;
  node.fail("'" + node.text() + "' is no shading; these are: flat, ambient, diffuse");
}

// {"material": "flat", ...}: other shadings than the materials' own.
void set_shadings(const JsonNode& node, scene::Object& object) {
  for (const auto& [name, value] : node.members()) {
    const auto material =
        std::find_if(object.materials.begin(), object.materials.end(),
                     [&, &wanted = name](const auto& known) { return known.name == wanted; });
    if (material == object.materials.end()) value.fail("there is no such material");
    material->shading = shading_of(value);
  }
}

// {"material": "picture", ...}: each is taken where it is there. Those that the caller names win.
[[nodiscard]] OtherPictures pictures_of(const JsonNode& node, const std::filesystem::path& folder,
                                        const SceneFiles& files) {
  OtherPictures pictures;
  for (const auto& [name, path] : files.textures) pictures[name] = {path, "--texture " + name};
  if (!node.has("textures")) return pictures;
  for (const auto& [name, value] : node.at("textures").members()) {
    const std::filesystem::path path = folder / value.text();
    if (files.has(path)) pictures.try_emplace(name, OtherPicture{path, value.place()});
  }
  return pictures;
}

[[nodiscard]] const scene::Material* material_named(const scene::Object& object,
                                                    const std::string& name) {
  const auto found = std::find_if(object.materials.begin(), object.materials.end(),
                                  [&](const auto& known) { return known.name == name; });
  return found == object.materials.end() ? nullptr : &*found;
}

void expect_textured(const JsonNode& textures, const scene::Object& object) {
  for (const auto& [name, value] : textures.members()) {
    const scene::Material* material = material_named(object, name);
    if (material == nullptr || !material->texture) {
      value.fail("there is no such material with a texture");
    }
  }
}

// Each of these is some material's that has a texture.
void expect_used(const SceneFiles& files, const scene::Scene& scene) {
  std::set<std::string> known;
  for (const scene::Object& object : scene.objects) {
    for (const scene::Material& material : object.materials) {
      if (material.texture) known.insert(material.name);
    }
  }
  for (const auto& [name, path] : files.textures) {
    if (known.contains(name)) continue;
    std::string these;
    for (const std::string& material : known) these += (these.empty() ? "" : ", ") + material;
    throw UserError(
        "--texture " + name + "=" + path.string() + ": '" + name +
        "' is no material with a texture; these are: " + (these.empty() ? "none" : these));
  }
}

void add_object(const JsonNode& node, const std::filesystem::path& folder, const SceneFiles& files,
                scene::Scene& scene) {
  node.expect_keys({"file", "position", "velocity", "axis", "angle_deg", "spin_deg", "scale",
                    "two_sided", "shading", "textures"});
  const JsonNode file = node.at("file");
  const std::filesystem::path path = folder / file.text();
  const scene::Motion motion = motion_of(node);
  const std::string text = file.about([&] { return files.text(path); });
  scene::Object object = read_obj(path, text, files, pictures_of(node, folder, files), scene);
  if (node.has("textures")) expect_textured(node.at("textures"), object);
  object.motion = motion;
  if (node.has("scale")) expect_near(node.at("scale"), object);
  if (node.has("two_sided")) object.two_sided = node.at("two_sided").boolean();
  if (node.has("shading")) set_shadings(node.at("shading"), object);
  scene.objects.push_back(std::move(object));
}

[[nodiscard]] scene::Colour background_of(const JsonNode& node) {
  const std::string& text = node.text();
  const Colour colour = node.about([&] { return parse_colour(text); });
  return {colour.red, colour.green, colour.blue, colour.alpha};
}

[[nodiscard]] double tolerance_of(const JsonNode& node) {
  const double texels = node.number();
  return node.about([&] { return checked_tolerance(texels); });
}

}  // namespace

scene::Scene read_scene(const std::filesystem::path& path, const SceneFiles& files) {
  const LocatedJson located = parse_located(path.string(), files.text(path));
  const JsonNode root(located);
  root.expect_keys({"camera", "ambient", "lamps", "background", "tolerance", "objects"});
  scene::Scene scene;
  if (root.has("camera")) scene.camera = camera_of(root.at("camera"));
  set(root, "ambient", scene.lighting.ambient);
  expect_no_fault(root, scene.lighting);
  if (root.has("lamps")) {
    for (const JsonNode& lamp : root.at("lamps").elements("lamp")) {
      scene.lighting.lamps.push_back(lamp_of(lamp));
    }
  }
  if (root.has("background")) scene.background = background_of(root.at("background"));
  if (root.has("tolerance")) scene.tolerance_texel = tolerance_of(root.at("tolerance"));
  const std::vector<JsonNode> objects = root.at("objects").elements("object");
  if (objects.empty()) root.at("objects").fail("at least one object is needed");
  for (const JsonNode& object : objects) add_object(object, path.parent_path(), files, scene);
  expect_used(files, scene);
  if (const std::string problem = scene::problem(scene); !problem.empty()) root.fail(problem);
  return scene;
}

}  // namespace selvage::cli
