// What is told of scene files that are wrong, and where.
#include "cli/png.h"
#include "sample_pictures.h"
#include "scene_files.h"

namespace selvage::cli::test {
namespace {

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
  expect("40", "180", 2, "view_deg: must be between 0 and 180");
  expect("40", "1e-300", 2, "view_deg: must be at least 0.000000001");
  expect("[0.5, 0.5, 0.5]", "[0.5, 0.5, 1e300]", 3, "ambient: must be within 1000000000");
  expect("[0, 1, 1]}", "[0, 1, 1], \"level\": [-1e300, 1, 1]}", 4,
         "lamp 1: level: must be within 1000000000");
  expect("\"towards\": [0, 1, 1]", "", 4, "'towards' is missing");
  expect("[0, 1, 1]", "[0, 0, 0]", 4, "lamp 1: towards: needs a direction");
  expect("#102030", "blue", 5, "background: 'blue' is no colour");
  expect("\"#102030\"", "7", 5, "background: a text is needed, not 7");
  expect("0.25", "-1", 6, "tolerance: '-1' is no tolerance; 0 to 32767 texels are");
  expect("0.25", "1e9", 6, "tolerance: '1000000000' is no tolerance; 0 to 32767 texels are");
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
  expect("usemtl front", "usemtl", 14, "usemtl: the name of a material is needed");
  expect("v 1 0 1", "v 1 0.25 1", 18,
         "f: the face is not plane: its corners are 0.0623 off any plane (root mean square), where "
         "rounding to six digits explains 8.66e-06; cut it into triangles");
  expect("f 1 3 4", "f 1 3 0", 13, "'0' is no corner");
  expect("f 1 3 4", "f 1 3 4x", 13, "'4x' is no corner; 1, 1/2, 1//3 and 1/2/3 are");
  expect("f 1 3 4", "f 1 3 4/", 13, "'4/' is no corner");
  expect("f 1 3 4", "f 1 3 4/1/", 13, "'4/1/' is no corner");
  expect("f 1 3 4", "f 1 3 4/1/1/1", 13, "'4/1/1/1' is no corner");
  expect("f 1 3 4", "f 1 3 -6", 13, "f: corner 3: there is no vertex -6; fewer stand before it");
  expect("f 1/3 4/1", "f 1/3 4/9", 15, "f: corner 2: there is no vt 9; the file has 3");
  expect("f 1/3 4/1", "f 1/-4 4/1", 15, "f: corner 1: there is no vt -4; fewer stand before it");
  expect("vt 1 0", "vt 1 30000", 15, "texture coordinates beyond 32767 texels");
  expect("f 1 3 4", "f 1 3", 13, "at least 3 corners, not 2");
  expect("f 1 3 4", "f 1 9 4", 13, "f: corner 2: there is no vertex 9; the file has 5");
  expect("f 1/3 4/1 5/2", "f 1/3 4 5/2", 15,
         "f: corner 2: its material has a texture, and it no texture coordinates");
  expect("usemtl front", "usemtl back", 14, "usemtl: 'back': there is no such material");
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
  expect("newmtl front", "newmtl", 4, "newmtl: the name of a material is needed");
  expect("newmtl stone", "# stone", 2, "Kd: a newmtl is needed before");
  expect("-clamp on", "-s 2 2 1", 6, "map_Kd: '-s': of options only -clamp on and -clamp off");
  expect("-clamp on", "-clamp maybe", 6, "map_Kd: '-clamp': of options only");
  expect("map_Kd", "map_kd", 6, "'map_kd' begins no statement of materials; newmtl, Kd, illum and");
  expect("Kd 1 1 1", "kd 1 1 1", 5, "'kd' begins no statement of materials");
  expect(" paint.png", "", 6, "map_Kd: the name of a picture is needed");
  expect("paint.png", "none.png", 6, "map_Kd: cannot read 'none.png'");
  put("empty.mtl", std::string("# nothing\n"));
  put("pyramid.obj", replaced(kObj, "pyramid.mtl", "empty.mtl"));
  EXPECT_EQ(error_of([] { (void)read_scene("scene.json"); }),
            "empty.mtl: there is no newmtl in it");
}

TEST_F(SceneFile, NamesBothPlacesOfAMaterial) {
  put("other.mtl", std::string("# one more\nnewmtl front\nKd 0 0 0\n"));
  for (const char* both :
       {"mtllib pyramid.mtl other.mtl", "mtllib pyramid.mtl\nmtllib other.mtl"}) {
    EXPECT_EQ(obj_error_with("mtllib pyramid.mtl", both),
              "other.mtl:2: newmtl: 'front' stands in pyramid.mtl:4 too; give one of them another "
              "name");
  }
}

TEST_F(SceneFile, NamesALibraryWithBlanksThatIsNotThere) {
  EXPECT_EQ(obj_error_with("mtllib pyramid.mtl", "mtllib my  stones.mtl # mine"),
            "pyramid.obj:2: mtllib: cannot read 'my': No such file or directory; nor is there a "
            "file 'my  stones.mtl'");
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

TEST_F(SceneFile, NamesAFileThatIsNotThere) {
  expect_contains(error_of([] { (void)read_scene("none.json"); }), "none.json");
  std::filesystem::create_directory("folder.obj");
  for (const std::string name : {"none.obj", "folder.obj"}) {
    expect_contains(error_with("pyramid.obj", name),
                    "scene.json:8: objects: object 1: file: cannot read '" + name + "': ");
  }
  put("scene.json", std::string(kPyramidScene));
  expect_contains(obj_error_with("pyramid.mtl", "none.mtl"),
                  "pyramid.obj:2: mtllib: cannot read 'none.mtl': ");
  put("pyramid.obj", std::string(kObj));
  expect_contains(mtl_error_with("paint.png", "none.png"),
                  "pyramid.mtl:6: map_Kd: cannot read 'none.png': ");
}

// Of what stands in several lines, the one that is at fault; and no name twice.
TEST_F(SceneFile, NamesTheLineOfThePlacement) {
  const auto expect = [&](const std::string& key, const std::string& value,
                          const std::string& words) {
    EXPECT_EQ(error_with("\"spin_deg\": 9,", "\"spin_deg\": 9,\n\"" + key + "\": " + value + ","),
              "scene.json:9: objects: object 1: " + key + ": " + words);
  };
  expect("scale", "0", "must be above 0");
  expect("position", "[1e300, 0, 0]", "must be within 1000000000 of the world's origin");
  expect("velocity", "[0, 0, -2e9]", "must be at most 1000000000 a second");
  expect("angle_deg", "1e300", "must be within 1000000000 degrees");
  expect("scale", "1e9", "puts a vertex farther than 1000000000 from the object's origin");
  EXPECT_EQ(error_with("\"axis\": [0, 1, 0],", "\"position\": [1, 1, 1],\n\"axis\": [0, 0, 0],"),
            "scene.json:9: objects: object 1: axis: needs a direction");
  put("scene.json", replaced(kPyramidScene, "\"spin_deg\": 9", "\"scale\": 1e-3"));
  EXPECT_EQ(obj_error_with("v 0 1 0\nv -1 0 1", "v 0 1 0\nv -1 1e300 1"),
            "pyramid.obj:4: v: farther than 1000000000 from the origin");
}

TEST_F(SceneFile, NamesWhatIsWrongWithTheCamera) {
  const auto expect = [&](const std::string& from, const std::string& to,
                          const std::string& words) {
    EXPECT_EQ(error_with(from, to), "scene.json:2: camera: " + words);
  };
  const std::string within = "must be within 1000000000 of the world's origin";
  expect("[0, 1, 5]", "[0, 1, 1e300]", "position: " + within);
  expect("[0, 1, 5]", "[0, 1, 5], \"target\": [1e300, 0, 0]", "target: " + within);
  expect("[0, 1, 5]", "[0, 1, 5], \"target\": [0, 1, 5]",
         "target: must not be where the camera is");
  expect("[0, 1, 5]", "[0, 0, 0]", "target must not be where the camera is");  // is left out
  expect("[0, 1, 5]", "[0, 1, 5], \"up\": [0, 0, 0]", "up: needs a direction");
  expect("[0, 1, 5]", "[0, 1, 5], \"up\": [0, 1e-200, 5e-200]", "up: must not be along the view");
  expect("40", "40, \"nearest\": 0", "nearest: must be above 0");
  expect("40", "40, \"nearest\": 0.001",
         "farthest must be above nearest, and at most 1048576 times it");
}

// The squares of these are beyond a double.
TEST_F(SceneFile, TakesAnUpOfAnyLength) {
  for (const char* up : {"[0, 1e-200, 0]", "[0, 1e300, 0]"}) {
    put("scene.json",
        replaced(kPyramidScene, "[0, 1, 5]", "[0, 1, 5], \"up\": " + std::string(up)));
    const scene::Placement to_eye = world_to_eye(read_scene("scene.json").camera);
    EXPECT_NEAR(to_eye.linear().determinant(), 1, 1e-12) << up;
    EXPECT_LT((to_eye.linear() * scene::Vector3::UnitY()).y(), -0.9) << up;
  }
}

}  // namespace
}  // namespace selvage::cli::test
