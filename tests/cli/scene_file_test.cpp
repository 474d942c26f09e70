#include "cli/scene_file.h"

#include <cmath>
#include <numbers>

#include "cli/png.h"
#include "sample_pictures.h"
#include "support.h"

namespace selvage::cli::test {
namespace {

constexpr const char* kObj =
    "# a pyramid\n"                                      // 1
    "mtllib pyramid.mtl\n"                               // 2
    "v 0 1 0\nv -1 0 1\nv 1 0 1\nv 1 0 -1\nv -1 0 -1\n"  // 3 to 7
    "vt 0 0\nvt 1 0\nvt 0.5 1\n"                         // 8 to 10
    "usemtl stone\n"                                     // 11
    "f 1 2 3\nf 1 3 4\n"                                 // 12, 13
    "usemtl front\n"                                     // 14
    "f 1/3 4/1 5/2\n"                                    // 15
    "usemtl stone\n"                                     // 16
    "f 1 5 2\n"                                          // 17
    "f 2 5 4 3\n";                                       // 18
constexpr const char* kMtl =
    "newmtl stone\nKd 0.5 0.25 1\nillum 1\nnewmtl front\nKd 1 1 1\nmap_Kd -clamp on paint.png\n";
constexpr const char* kScene =
    "{\n"                                                                    // 1
    " \"camera\": {\"position\": [0, 1, 5], \"view_deg\": 40},\n"            // 2
    " \"ambient\": [0.5, 0.5, 0.5],\n"                                       // 3
    " \"lamps\": [{\"towards\": [0, 1, 1]}],\n"                              // 4
    " \"background\": \"#102030\",\n"                                        // 5
    " \"tolerance\": 0.25,\n"                                                // 6
    " \"objects\": [\n"                                                      // 7
    "  {\"file\": \"pyramid.obj\", \"axis\": [0, 1, 0], \"spin_deg\": 9,\n"  // 8
    "   \"shading\": {\"stone\": \"ambient\"}}\n"                            // 9
    " ]\n}\n";

[[nodiscard]] std::string replaced(std::string text, const std::string& from,
                                   const std::string& to) {
  const size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

class SceneFile : public InDirectory {
 protected:
  SceneFile() {
    put("paint.png", encode_png(sample_raster(24, 18)));
    put("pyramid.mtl", std::string(kMtl));
    put("pyramid.obj", std::string(kObj));
    put("scene.json", std::string(kScene));
  }

  // The message for a scene, or an OBJ file, in which a text is replaced.
  std::string error_with(const std::string& from, const std::string& to) {
    put("scene.json", replaced(kScene, from, to));
    return error_of([] { (void)read_scene("scene.json"); });
  }
  std::string mtl_error_with(const std::string& from, const std::string& to) {
    put("pyramid.mtl", replaced(kMtl, from, to));
    return error_of([] { (void)read_scene("scene.json"); });
  }
  std::string obj_error_with(const std::string& from, const std::string& to) {
    put("pyramid.obj", replaced(kObj, from, to));
    return error_of([] { (void)read_scene("scene.json"); });
  }
};

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

// The parser of OBJ files keeps numbers of corners in 8 bits.
TEST_F(SceneFile, KeepsFacesOfManyCorners) {
  std::string vertices;
  constexpr int kCorners = 600;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2 * std::numbers::pi * i / kCorners;
    vertices += "v " + std::to_string(std::cos(angle)) + " " + std::to_string(std::sin(angle)) +
                " 0\nvt 0 " + std::to_string(i / 1024.0) + "\n";
  }
  const std::vector<int> counts = {255, 256, 257, 3, 512, 600};
  std::string faces;
  for (const int count : counts) {
    faces += count == 257 ? "usemtl front\nf" : "f";
    for (int i = 1; i <= count; ++i) faces += " " + std::to_string(i) + "/" + std::to_string(i);
    faces += "\n";
  }
  put("pyramid.obj", "mtllib pyramid.mtl\nusemtl stone\n" + vertices + faces);
  const scene::Scene scene = read_scene("scene.json");
  const std::vector<scene::Face>& read = scene.objects.at(0).faces;
  ASSERT_EQ(read.size(), counts.size());
  for (size_t face = 0; face < read.size(); ++face) {
    EXPECT_EQ(read[face].material, face < 2 ? 0U : 1U);
    ASSERT_EQ(read[face].corners.size(), static_cast<size_t>(counts[face]));
    for (size_t i = 0; i < read[face].corners.size(); ++i) {
      ASSERT_EQ(read[face].corners[i].vertex, i);
    }
  }
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

TEST_F(SceneFile, NamesFileAndLineOfWhatIsWrongInIt) {
  const auto expect = [&](const std::string& from, const std::string& to, int line,
                          const std::string& words) {
    const std::string error = error_with(from, to);
    EXPECT_EQ(error.rfind("scene.json:" + std::to_string(line) + ": ", 0), 0U) << error;
    EXPECT_EQ(error.find("scene.json", 1), std::string::npos) << error;  // said once
    expect_contains(error, words);
  };
  expect("[0, 1, 5]", "[0, 1, 5", 2, "not JSON");
  expect("\"view_deg\"", "\"angle\"", 2, "camera: unknown key \"angle\"; known here: position,");
  expect("\"ambient\"", "\"camera\"", 3, "the key \"camera\" stands twice");
  expect("[0, 1, 5]", "[0, 1]", 2, "camera: position: [x, y, z] is needed, not [0,1]");
  expect("40", "\"wide\"", 2, "camera: view_deg: a number is needed");
  expect("40", "180", 2, "view_deg must be between");
  expect("\"towards\": [0, 1, 1]", "", 4, "'towards' is missing");
  expect("[0, 1, 1]", "[0, 0, 0]", 4, "a lamp needs a direction");
  expect("#102030", "blue", 5, "background: 'blue' is no colour");
  expect("\"#102030\"", "7", 5, "background: a text is needed, not 7");
  expect("0.25", "-1", 6, "tolerance: texels, 0 or more");
  expect("\"file\"", "\"flie\"", 8, "unknown key");
  expect("[0, 1, 0], \"spin", "[0, 0, 0], \"spin", 8, "axis");
  expect("\"stone\"", "\"wood\"", 9, "there is no such material");
  expect("\"ambient\"}", "\"shiny\"}", 9, "is no shading; these are: flat, ambient, diffuse");
}

TEST_F(SceneFile, NamesFileAndLineOfWhatIsWrongInAnObject) {
  const auto expect = [&](const std::string& from, const std::string& to, int line,
                          const std::string& words) {
    const std::string error = obj_error_with(from, to);
    EXPECT_EQ(error.rfind("pyramid.obj:" + std::to_string(line) + ": ", 0), 0U) << error;
    expect_contains(error, words);
  };
  expect("v 0 1 0", "v 0 one 0", 3, "'one' is no finite number");
  expect("v 0 1 0", "v 0 1", 3, "v: 3 to 7 numbers are needed, not 2");
  expect("vt 1 0", "vt nan 0", 9, "'nan' is no finite number");
  expect("v 0 1 0", "v 0 0x1p3 0", 3, "'0x1p3' is no finite number");
  expect("v 0 1 0", "v 0 1e999 0", 3, "'1e999' is no finite number");
  expect("vt 1 0", "vt 1 0 0 0", 9, "vt: 2 to 3 numbers are needed, not 4");
  expect("vt 1 0", "tv 1 0", 9, "'tv' begins no statement that is read here; v, vt, f");
  expect("vt 1 0", "\x1b[31m\xff" + std::string(99, 'a'), 9,
         "'?[31m?" + std::string(54, 'a') + "...' begins no statement");
  expect("pyramid.mtl", "gone.mtl", 2, "gone.mtl");
  expect("mtllib pyramid.mtl", "mtllib", 2, "the name of a file is needed");
  expect("usemtl front", "usemtl", 14, "one word is needed, not 0");
  expect("f 1 3 4", "f 1 3 0", 13, "'0' is no corner");
  expect("f 1 3 4", "f 1 3 4x", 13, "'4x' is no corner; 1, 1/2, 1//3 and 1/2/3 are");
  expect("f 1 3 4", "f 1 3 4/", 13, "'4/' is no corner");
  expect("f 1 3 4", "f 1 3 4/1/", 13, "'4/1/' is no corner");
  expect("f 1 3 4", "f 1 3 4/1/1/1", 13, "'4/1/1/1' is no corner");
  expect("f 1 3 4", "f 1 3 -6", 13, "no such vertex");
  expect("f 1/3 4/1", "f 1/3 4/9", 15, "no texture coordinates");
  expect("vt 1 0", "vt 1 30000", 15, "texture coordinates beyond 32767 texels");
  expect("f 1 3 4", "f 1 3", 13, "at least 3 corners, not 2");
  expect("f 1 3 4", "f 1 3 9", 13, "no such vertex");
  expect("f 1/3 4/1 5/2", "f 1/3 4 5/2", 15, "no texture coordinates");
  expect("usemtl front", "usemtl back", 14, "there is no such material");
  expect("f 2 5 4 3", "f 2 4 5 3", 18, "not convex");
}

TEST_F(SceneFile, NamesFileAndLineOfWhatIsWrongInAMaterialLibrary) {
  const auto expect = [&](const std::string& from, const std::string& to, int line,
                          const std::string& words) {
    const std::string error = mtl_error_with(from, to);
    EXPECT_EQ(error.rfind("pyramid.mtl:" + std::to_string(line) + ": ", 0), 0U) << error;
    expect_contains(error, words);
  };
  expect("0.25 1", "0.25", 2, "Kd: 3 numbers are needed, not 2");
  expect("0.25 1", "red 1", 2, "Kd: 'red' is no finite number");
  expect("illum 1", "illum bright", 3,
         "illum: a whole number from 0 to 10 is needed, not 'bright'");
  expect("newmtl front", "newmtl stone", 4, "newmtl: 'stone' stands twice");
  expect("newmtl front", "newmtl the front", 4, "newmtl: one word is needed, not 2");
  expect("newmtl stone", "# stone", 2, "Kd: a newmtl is needed before");
  expect("-clamp on", "-s 2 2 1", 6, "map_Kd: '-s': of options only -clamp on and -clamp off");
  expect("-clamp on", "-clamp maybe", 6, "map_Kd: '-clamp': of options only");
  expect(" paint.png", "", 6, "map_Kd: the name of a picture is needed");
  expect("paint.png", "none.png", 6, "map_Kd: cannot read 'none.png'");
  put("empty.mtl", std::string("# nothing\n"));
  put("pyramid.obj", replaced(kObj, "pyramid.mtl", "empty.mtl"));
  EXPECT_EQ(error_of([] { (void)read_scene("scene.json"); }),
            "empty.mtl: there is no newmtl in it");
}

TEST_F(SceneFile, NamesWhereAPictureIsWrong) {
  const std::string png = get("paint.png");
  const std::vector<uint8_t> jpeg = encode_jpeg(sample_raster(24, 18), JpegKind::kColour);
  const auto expect = [&](const std::string& bytes, const std::string& words) {
    put("paint.png", bytes);
    EXPECT_EQ(error_of([] {
                (void)read_scene("scene.json");
              }).rfind("pyramid.mtl:6: map_Kd: 'paint.png': " + words, 0),
              0U);
  };
  expect("", "the file is empty");
  expect("a text", "neither a PNG nor a JPEG");
  expect(png.substr(0, png.size() / 2), "the PNG is cut short");
  expect(png.substr(0, 60) + '\0' + png.substr(61), "the PNG is damaged");
  expect({jpeg.begin(), jpeg.begin() + static_cast<std::ptrdiff_t>(jpeg.size() / 2)},
         "the JPEG is cut short or damaged");
}

// Another picture is taken where it is there, and one that the caller names before it.
TEST_F(SceneFile, TakesOtherPicturesThatAreThere) {
  const auto with = [](const std::string& textures) {
    put("scene.json", replaced(kScene, "\"spin_deg\": 9,", "\"textures\":\n" + textures + ","));
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

TEST_F(SceneFile, NamesAFileThatIsNotThere) {
  expect_contains(error_of([] { (void)read_scene("none.json"); }), "none.json");
  expect_contains(error_with("pyramid.obj", "none.obj"), "none.obj");
  put("scene.json", std::string(kScene));
  put("pyramid.mtl", replaced(kMtl, "paint.png", "none.png"));
  expect_contains(error_of([] { (void)read_scene("scene.json"); }), "none.png");
}

}  // namespace
}  // namespace selvage::cli::test
