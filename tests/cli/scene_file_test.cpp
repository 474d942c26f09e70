// What scene files hold.
#include "cli/scene_file.h"

#include <algorithm>

#include "cli/png.h"
#include "sample_pictures.h"
#include "scene_files.h"

namespace selvage::cli::test {
namespace {

TEST_F(SceneFile, ReadsAllThatItHolds) {
  const scene::Scene scene = read_scene("scene.json");
  EXPECT_EQ(scene.camera.position, scene::Vector3(0, 1, 5));
  EXPECT_EQ(scene.camera.view_deg, 40);
  EXPECT_EQ(scene.lighting.ambient, scene::Vector3(0.5, 0.5, 0.5));
  ASSERT_EQ(scene.lighting.lamps.size(), 1U);
  EXPECT_EQ(scene.background, (scene::Colour{0x10, 0x20, 0x30}));
  EXPECT_EQ(scene.tolerance_texel, 0.25);
  ASSERT_EQ(scene.objects.size(), 1U);
  EXPECT_EQ(scene.objects[0].motion.spin_deg, 9);
}

TEST_F(SceneFile, ReadsAnObject) {
  const scene::Scene scene = read_scene("scene.json");
  const scene::Object& object = scene.objects.at(0);
  ASSERT_EQ(object.vertices.size(), 5U);
  EXPECT_EQ(object.vertices[4], scene::Vector3(-1, 0, -1));
  ASSERT_EQ(object.faces.size(), 5U);
  EXPECT_EQ(object.faces[4].corners.size(), 4U);  // n-gons are kept
  const scene::Material& stone = object.materials.at(object.faces[0].material);
  EXPECT_EQ(stone.colour, (scene::Colour{128, 64, 255}));
  EXPECT_EQ(stone.shading, scene::Shading::kAmbient);  // the scene's word
}

TEST_F(SceneFile, TurnsTexturesOver) {
  const scene::Scene scene = read_scene("scene.json");
  const scene::Object& object = scene.objects.at(0);
  const scene::Face& face = object.faces.at(2);
  const scene::Material& front = object.materials.at(face.material);
  EXPECT_EQ(front.shading, scene::Shading::kFlat);  // no illum
  ASSERT_TRUE(front.texture);
  const scene::TextureImage& image = scene.textures.at(*front.texture);
  EXPECT_EQ(image.width_texel, 24);
  EXPECT_EQ(image.height_texel, 18);
  EXPECT_EQ(image.address, SELVAGE_ADDRESS_CLAMP);
  EXPECT_EQ(image.rgba, sample_raster(24, 18).rgba);
  EXPECT_EQ(face.corners[0].texture_texel, scene::Vector2(12, 0));
  EXPECT_EQ(face.corners[1].texture_texel, scene::Vector2(0, 18));
}

TEST_F(SceneFile, TakesWholePeriodsOff) {
  put("pyramid.mtl", replaced(kMtl, "-clamp on ", ""));
  put("pyramid.obj",
      replaced(kObj, "vt 0 0\nvt 1 0\nvt 0.5 1", "vt 5000 7000\nvt 5001 7000\nvt 5000.5 7001"));
  const scene::Scene scene = read_scene("scene.json");
  const scene::Face& face = scene.objects.at(0).faces.at(2);
  EXPECT_EQ(scene.textures.at(0).address, SELVAGE_ADDRESS_WRAP);
  EXPECT_EQ(face.corners[0].texture_texel, scene::Vector2(12, 0));
  EXPECT_EQ(face.corners[1].texture_texel, scene::Vector2(0, 18));
}

// Another picture is taken where it is there, and one that the caller names before it.
TEST_F(SceneFile, TakesOtherPicturesThatAreThere) {
  const auto with = [](const std::string& textures) {
    put("scene.json",
        replaced(kPyramidScene, "\"spin_deg\": 9,", "\"textures\":\n" + textures + ","));
  };
  const auto width = [](const SceneFiles& files) {
    return read_scene("scene.json", files).textures.at(0).width_texel;
  };
  with(R"({"front": "other.png"})");
  EXPECT_EQ(width({}), 24);
  put("other.png", encode_png(filled(5, 3, {})));
  put("asked.png", encode_png(filled(7, 3, {})));
  EXPECT_EQ(width({}), 5);
  EXPECT_EQ(width({{{"front", "asked.png"}}, {}}), 7);
  put("other.png", std::string("no picture"));
  EXPECT_EQ(error_of([&] { (void)width({}); }),
            "scene.json:9: objects: object 1: textures: front: 'other.png': neither a PNG nor a "
            "JPEG picture");
  with(R"({"stone": "other.png"})");
  EXPECT_EQ(error_of([&] { (void)width({}); }),
            "scene.json:9: objects: object 1: textures: stone: there is no such material with a "
            "texture");
}

// What editors of Windows put in front of a text.
TEST_F(SceneFile, TakesByteOrderMarks) {
  const std::string mark = "\xef\xbb\xbf";
  put("pyramid.mtl", mark + kMtl);
  put("pyramid.obj", mark + kObj);
  put("scene.json", mark + kPyramidScene);
  EXPECT_EQ(read_scene("scene.json").objects.at(0).faces.size(), 5U);
}

// As exporters write them. A library's is the whole rest of the line only if that file is there.
TEST_F(SceneFile, TakesNamesWithBlanks) {
  put("pyramid.mtl", replaced(kMtl, "newmtl front", "newmtl  the\tfront 100% "));
  const std::string obj = replaced(kObj, "usemtl front", "usemtl the front   100% # it");
  put("pyramid.obj", obj);
  put("scene.json", replaced(kPyramidScene, "\"stone\"", "\"the front 100%\""));
  const scene::Object plain = read_scene("scene.json").objects.at(0);
  EXPECT_EQ(plain.materials.at(1).name, "the front 100%");
  EXPECT_EQ(plain.faces.at(2).material, 1U);
  std::filesystem::rename("pyramid.mtl", "my  pyramid.mtl");
  put("pyramid.obj", replaced(obj, "mtllib pyramid.mtl", "mtllib my  pyramid.mtl "));
  EXPECT_EQ(read_scene("scene.json").objects.at(0).faces.at(2).material, 1U);
}

// The names of two materials that differ by what stands for a blank elsewhere.
TEST_F(SceneFile, KeepsNamesApart) {
  put("pyramid.mtl",
      replaced(replaced(kMtl, "newmtl stone", "newmtl a%20b"), "newmtl front", "newmtl a b"));
  std::string obj = replaced(kObj, "usemtl front", "usemtl a b");
  for (int i = 0; i < 2; ++i) obj = replaced(obj, "usemtl stone", "usemtl a%20b");
  put("pyramid.obj", obj);
  put("scene.json", replaced(kPyramidScene, "\"stone\"", "\"a%20b\""));
  const scene::Object object = read_scene("scene.json").objects.at(0);
  EXPECT_EQ(object.faces.at(0).material, 0U);
  EXPECT_EQ(object.faces.at(2).material, 1U);
}

// Two names of one file, and a file in two lines: it is read once.
TEST_F(SceneFile, ReadsALibraryOnce) {
  put("pyramid.obj",
      replaced(kObj, "mtllib pyramid.mtl", "mtllib ./pyramid.mtl\nmtllib pyramid.mtl"));
  EXPECT_EQ(read_scene("scene.json").objects.at(0).materials.size(), 3U);
}

// CR alone ends a line as well.
TEST_F(SceneFile, TakesOldLineEnds) {
  const auto old = [](std::string text) {
    std::ranges::replace(text, '\n', '\r');
    return text;
  };
  put("pyramid.mtl", old(kMtl));
  put("pyramid.obj", old(kObj));
  EXPECT_EQ(read_scene("scene.json").objects.at(0).faces.size(), 5U);
  put("pyramid.obj", old(replaced(kObj, "f 1 5 2", "f 1 5")));
  expect_contains(error_of([] { (void)read_scene("scene.json"); }), "pyramid.obj:17: f: ");
}

// Statements that have no say here, of the format and of extensions.
TEST_F(SceneFile, LeavesOutWhatElseMaterialsHave) {
  put("pyramid.mtl", std::string(kMtl) +
                         "Ns 250\nKa 1 1 1\nKs 0.5 0.5 0.5\nNi 1.45\nd 1\n"
                         "map_Bump -bm 1 none.png\nPr 0.5\n");
  EXPECT_EQ(read_scene("scene.json").objects.at(0).materials.at(1).texture, 0U);
}

TEST_F(SceneFile, TakesAJpeg) {
  put("paint.png",
      encode_jpeg(sample_raster(24, 18), JpegKind::kColour));  // by what it is, not its name
  EXPECT_EQ(read_scene("scene.json").textures.at(0).width_texel, 24);
}

// Comments, continued lines, carriage returns, normals, groups, indices from the end, a library
// that stands behind its use or in another folder: the same object.
TEST_F(SceneFile, TakesAllFormsOfWavefrontFiles) {
  const scene::Scene plain = read_scene("scene.json");
  std::string other = replaced(kObj, "mtllib pyramid.mtl\n", "g a b\ns off\nvn 0 0 1\n");
  other = replaced(other, "f 1/3 4/1 5/2", "f -5/-1/1 4/-3/-1 \\\n  5/2/1 # the front");
  other = replaced(other, "f 1 5 2", "f 1//1 5//1 2//1 #");
  other = replaced(other, "v 0 1 0", "  v\t0e2147483648 +1.0e0   -0 1 0 0");
  other += "mtllib materials/pyramid.mtl materials/pyramid.mtl";
  std::string with_returns;
  for (const char letter : other) with_returns += letter == '\n' ? "\r\n" : std::string(1, letter);
  put("pyramid.obj", with_returns);
  std::filesystem::create_directory("materials");
  std::filesystem::rename("pyramid.mtl", "materials/pyramid.mtl");
  std::filesystem::rename("paint.png", "materials/paint.png");
  const scene::Scene scene = read_scene("scene.json");
  const scene::Object &a = plain.objects.at(0), &b = scene.objects.at(0);
  EXPECT_EQ(a.vertices, b.vertices);
  ASSERT_EQ(a.faces.size(), b.faces.size());
  for (size_t face = 0; face < a.faces.size(); ++face) {
    EXPECT_EQ(a.faces[face].material, b.faces[face].material);
    ASSERT_EQ(a.faces[face].corners.size(), b.faces[face].corners.size());
    for (size_t i = 0; i < a.faces[face].corners.size(); ++i) {
      EXPECT_EQ(a.faces[face].corners[i].vertex, b.faces[face].corners[i].vertex);
      EXPECT_EQ(a.faces[face].corners[i].texture_texel, b.faces[face].corners[i].texture_texel);
    }
  }
  EXPECT_EQ(plain.textures.at(0).rgba, scene.textures.at(0).rgba);
}

}  // namespace
}  // namespace selvage::cli::test
