// Faces of OBJ files: which are taken, and which are not.
#include <cmath>
#include <numbers>
#include <sstream>

#include "scene_files.h"

namespace selvage::cli::test {
namespace {

// A regular polygon in a plane across, its corners in decimals of so many digits; and one corner
// pushed in the middle of each side.
[[nodiscard]] std::string across(int corners, int digits, bool with_middles) {
  const scene::Vector3 along = scene::Vector3(1, 2, 3).normalized();
  const scene::Vector3 aside = along.cross(scene::Vector3(3, -1, 2)).normalized();
  const auto corner = [&](int i) -> scene::Vector3 {
    const double angle = 2 * std::numbers::pi * i / corners;
    return scene::Vector3(0.3, -0.2, 0.1) + std::cos(angle) * along + std::sin(angle) * aside;
  };
  std::ostringstream text;
  text.precision(digits);
  std::string face = "f";
  int count = 0;
  const auto add = [&](const scene::Vector3& at) {
    text << "v " << at.x() << ' ' << at.y() << ' ' << at.z() << '\n';
    face += " " + std::to_string(++count);
  };
  for (int i = 0; i < corners; ++i) {
    add(corner(i));
    if (with_middles) add((corner(i) + corner(i + 1)) / 2);
  }
  return text.str() + face + "\n";
}

// Six digits are what most programs write; of plane faces they leave these, of straight sides too.
TEST_F(SceneFile, TakesPlaneFacesAsTheyAreRounded) {
  for (int corners = 3; corners <= 24; ++corners) {
    for (const bool with_middles : {false, true}) {
      for (const int digits : {6, 7, 17}) {
        put("pyramid.obj", across(corners, digits, with_middles));
        put("scene.json", std::string(R"({"objects": [{"file": "pyramid.obj"}]})"));
        EXPECT_EQ(read_scene("scene.json").objects.at(0).faces.size(), 1U)
            << corners << " corners, " << digits << " digits";
      }
    }
  }
}

TEST_F(SceneFile, RefusesFacesThatAreNoPlanes) {
  put("scene.json", std::string(R"({"objects": [{"file": "pyramid.obj"}]})"));
  for (const char* height : {"0.0001", "0.01", "1"}) {
    put("pyramid.obj", "v 0 0 0\nv 1 0 0\nv 1 1 " + std::string(height) + "\nv 0 1 0\nf 1 2 3 4\n");
    expect_contains(error_of([] { (void)read_scene("scene.json"); }),
                    "pyramid.obj:5: f: the face is not plane: ");
    put("pyramid.obj",
        "v 0 0 0\nv 1 0 0\nv 1 1 " + std::string(height) + "\nv 0 1 0\nf 1 2 3\nf 1 3 4\n");
    EXPECT_EQ(read_scene("scene.json").objects.at(0).faces.size(), 2U);  // what would be right
  }
}

TEST_F(SceneFile, RefusesFacesThatAreNotConvex) {
  put("scene.json", std::string(R"({"objects": [{"file": "pyramid.obj"}]})"));
  for (const char* inward : {"0.0001", "0.25", "0.6"}) {
    put("pyramid.obj",
        "v 0 0 0\nv 0.5 " + std::string(inward) + " 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4 5\n");
    expect_contains(error_of([] { (void)read_scene("scene.json"); }),
                    "pyramid.obj:6: f: the face is not convex; cut it into convex faces");
  }
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

}  // namespace
}  // namespace selvage::cli::test
