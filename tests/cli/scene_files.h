// A small scene in files, for tests that change a word of them.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "cli/png.h"
#include "cli/scene_file.h"
#include "sample_pictures.h"
#include "support.h"

namespace selvage::cli::test {

inline constexpr const char* kObj =
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
inline constexpr const char* kMtl =
    "newmtl stone\nKd 0.5 0.25 1\nillum 1\nnewmtl front\nKd 1 1 1\nmap_Kd -clamp on paint.png\n";
inline constexpr const char* kPyramidScene =
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

[[nodiscard]] inline std::string replaced(std::string text, const std::string& from,
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
    put("scene.json", std::string(kPyramidScene));
  }

  // The message for a scene, or an OBJ file, in which a text is replaced.
  std::string error_with(const std::string& from, const std::string& to) {
    put("scene.json", replaced(kPyramidScene, from, to));
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

}  // namespace selvage::cli::test
