// The stages from objects to faces on the mapper's grid.
#include <gtest/gtest.h>

#include <numbers>

#include "bodies.h"
#include "plane_face.h"
#include "scene/frustum.h"
#include "scene/look.h"
#include "scene/problem.h"

namespace selvage::scene {
namespace {

inline constexpr Size kViewSize{320, 200};

[[nodiscard]] Scene scene_with(Object object) {
  Scene scene;
  scene.objects.push_back(std::move(object));
  return scene;
}

TEST(Motion, TurnsScalesAndMoves) {
  Motion motion;
  motion.position = {1, 2, 3};
  motion.velocity = {0, 0, 1};
  motion.axis = {0, 0, 5};
  motion.angle_deg = 30;
  motion.spin_deg = 30;
  motion.scale = 2;
  const Vector3 moved = placed(motion, 2) * Vector3(1, 0, 0);
  EXPECT_TRUE(moved.isApprox(Vector3(1, 4, 5))) << moved.transpose();
}

// Directions count, however long they are: the squares of these are beyond a double.
TEST(Motion, TakesAxesOfAnyLength) {
  for (const double length : {1e-200, 1.0, 1e200}) {
    Motion motion;
    motion.axis = {0, 0, length};
    motion.angle_deg = 90;
    Scene scene = scene_with(cube());
    scene.objects[0].motion = motion;
    scene.lighting = {Vector3::Zero(), {{Vector3(0, 0, length), Vector3::Ones()}}};
    EXPECT_EQ(problem(scene), "");
    EXPECT_TRUE((placed(motion, 0) * Vector3(1, 0, 0)).isApprox(Vector3(0, 1, 0))) << length;
    EXPECT_EQ(reflected(scene.lighting, Shading::kDiffuse, {0, 0, 1}), (Light{255, 255, 255}));
  }
}

TEST(Camera, LooksAtItsTargetWithUpUp) {
  Camera camera;
  camera.position = {3, -2, 7};
  camera.target = {1, 1, 1};
  const Placement to_eye = world_to_eye(camera);
  const Vector3 target = to_eye * camera.target;
  EXPECT_NEAR(target.x(), 0, 1e-12);
  EXPECT_NEAR(target.y(), 0, 1e-12);
  EXPECT_NEAR(target.z(), 7, 1e-12);
  EXPECT_LT((to_eye.linear() * Vector3::UnitY()).y(), 0);  // y of the eye is down
  EXPECT_NEAR(to_eye.linear().determinant(), 1, 1e-12);
}

TEST(Camera, ShowsTheViewAngleFromTopToBottom) {
  Camera camera;
  camera.view_deg = 90;
  const Vector3 top = eye_to_place(camera, kViewSize) * Vector3(0, -2, 2);
  EXPECT_NEAR(top.y() / top.z(), 0, 1e-12);
  EXPECT_NEAR(top.x() / top.z(), kViewSize.width_px / 2, 1e-12);
}

TEST(Look, ShowsTheFaceOfACubeThatIsTowardsTheEye) {
  const View view = look(scene_with(cube()), 0, kViewSize);
  EXPECT_EQ(view.counts.faces, 6U);
  EXPECT_EQ(view.counts.backs, 5U);
  ASSERT_EQ(view.faces.size(), 1U);
  EXPECT_EQ(view.faces[0].face, 1U);  // z = +1, the camera's side
}

// Neither side of a face is seen that passes through the eye: this is no back.
TEST(Look, CountsWhatIsSeenEdgeOn) {
  Scene scene = scene_with(cube());
  scene.objects[0].faces.resize(1);  // z = -1
  scene.objects[0].motion.axis = {1, 0, 0};
  scene.objects[0].motion.angle_deg = 90;
  scene.objects[0].motion.position = {0, -1, 0};
  for (const bool two_sided : {false, true}) {
    scene.objects[0].two_sided = two_sided;
    const View view = look(scene, 0, kViewSize);
    EXPECT_EQ(view.counts.edge_on, 1U);
    EXPECT_EQ(view.counts.backs, 0U);
  }
}

// Painter's order goes by it: the mean of what is left of a face, along the view.
TEST(Look, TellsHowFarAFaceIs) {
  Scene scene = scene_with(cube());
  EXPECT_NEAR(look(scene, 0, kViewSize).faces.at(0).mean_w, 4, 1e-12);
  scene.objects[0].motion.position = {0, 0, -3};
  EXPECT_NEAR(look(scene, 0, kViewSize).faces.at(0).mean_w, 7, 1e-12);
  scene.objects[0].faces = {scene.objects[0].faces[1]};
  scene.objects[0].motion.angle_deg = 60;  // the middle of its face is cos 60 in front of its own
  EXPECT_NEAR(look(scene, 0, kViewSize).faces.at(0).mean_w, 7.5, 1e-12);
}

TEST(Look, ShowsBothSidesWhereAsked) {
  Scene scene = scene_with(cube());
  scene.objects[0].two_sided = true;
  scene.objects[0].motion.angle_deg = 30;
  scene.objects[0].motion.axis = {1, 1, 0};
  EXPECT_EQ(look(scene, 0, kViewSize).counts.seen, 6U);
  scene.objects[0].two_sided = false;
  EXPECT_EQ(look(scene, 0, kViewSize).counts.seen, 3U);
}

TEST(Look, SharesVerticesAcrossFacesAndObjectsDepths) {
  Scene scene = scene_with(cube());
  scene.objects[0].motion.angle_deg = 35;
  scene.objects[0].motion.axis = {1, 2, 3};
  const View view = look(scene, 0, kViewSize);
  ASSERT_EQ(view.faces.size(), 3U);
  int shared = 0;
  for (const selvage_vertex& a : view.faces[0].vertices) {
    for (const selvage_vertex& b : view.faces[1].vertices) {
      shared += a.x == b.x && a.y == b.y && a.q == b.q;
    }
  }
  EXPECT_EQ(shared, 2);
}

TEST(Look, CutsAtTheNearPlaneWhatReachesBehindTheEye) {
  Scene scene = scene_with(cube());
  scene.objects[0].motion.scale = 10;  // the camera is inside
  scene.objects[0].two_sided = true;
  const View view = look(scene, 0, kViewSize);
  EXPECT_EQ(view.counts.clipped_away, 1U);  // the one behind
  EXPECT_EQ(view.counts.seen + view.counts.off_screen, 5U);
  EXPECT_GE(view.counts.seen, 1U);
}

TEST(Look, RejectsObjectsOutsideOfThePicture) {
  Scene scene = scene_with(cube());
  for (const Vector3& away : {Vector3(50, 0, 0), Vector3(-50, 0, 0), Vector3(0, 40, 0),
                              Vector3(0, -40, 0), Vector3(0, 0, 20)}) {
    scene.objects[0].motion.position = away;
    const View view = look(scene, 0, kViewSize);
    EXPECT_EQ(view.counts.objects_rejected, 1U) << away.transpose();
    EXPECT_TRUE(view.faces.empty());
  }
}

// By its size in the world: a large one reaches into the picture from outside, a small one does
// not.
TEST(Look, RejectsByTheSizeInTheWorld) {
  Scene scene = scene_with(cube());
  scene.objects[0].motion.position = {12, 0, 0};
  scene.objects[0].motion.scale = 10;
  EXPECT_EQ(look(scene, 0, kViewSize).counts.objects_rejected, 0U);
  EXPECT_GT(look(scene, 0, kViewSize).counts.seen, 0U);
  scene.objects[0].motion.position = {4, 0, 0};
  scene.objects[0].motion.scale = 0.01;
  EXPECT_EQ(look(scene, 0, kViewSize).counts.objects_rejected, 1U);
  EXPECT_EQ(look(scene, 0, kViewSize).counts.faces_rejected, 6U);
}

// A rejected sphere has no point in the picture.
TEST(Frustum, RejectsNothingThatIsSeen) {
  const Camera camera;
  const Matrix3 to_place = eye_to_place(camera, kViewSize);
  int rejected = 0;
  for (uint64_t seed = 1; seed <= 2000; ++seed) {
    spec::Random random(seed);
    const Sphere sphere{{real(random, -8, 8), real(random, -8, 8), real(random, -3, 10)},
                        real(random, 0, 3)};
    if (may_be_seen(sphere, camera, kViewSize)) continue;
    ++rejected;
    for (int i = 0; i < 50; ++i) {
      const Vector3 place =
          to_place * (sphere.centre + sphere.radius * real(random, 0, 1) * direction(random));
      const bool inside = place.z() >= camera.nearest_w && place.x() >= 0 && place.y() >= 0 &&
                          place.x() <= kViewSize.width_px * place.z() &&
                          place.y() <= kViewSize.height_px * place.z();
      EXPECT_FALSE(inside) << "seed " << seed;
    }
  }
  EXPECT_GT(rejected, 200);
}

TEST(Problem, NamesWhatIsWrong) {
  EXPECT_EQ(problem(scene_with(cube())), "");
  const auto expect = [](const char* words, auto&& spoil) {
    Scene scene = scene_with(cube());
    spoil(scene);
    EXPECT_NE(problem(scene).find(words), std::string::npos) << words << ": " << problem(scene);
  };
  expect("target", [](Scene& s) { s.camera.target = s.camera.position; });
  expect("view_deg", [](Scene& s) { s.camera.view_deg = 180; });
  expect("view_deg must be at least", [](Scene& s) { s.camera.view_deg = 5e-324; });
  expect("nearest", [](Scene& s) { s.camera.nearest_w = 0; });
  expect("axis", [](Scene& s) { s.objects[0].motion.axis = {0, 0, 0}; });
  expect("scale", [](Scene& s) { s.objects[0].motion.scale = -1; });
  expect("face 3 has fewer than 3", [](Scene& s) { s.objects[0].faces[2].corners.resize(2); });
  expect("no vertex", [](Scene& s) { s.objects[0].faces[0].corners[0].vertex = 8; });
  expect("not convex", [](Scene& s) {
    std::swap(s.objects[0].faces[0].corners[0], s.objects[0].faces[0].corners[1]);
  });
  expect("face 1 is not plane", [](Scene& s) {
    s.objects[0].vertices.push_back(1.01 *
                                    s.objects[0].vertices[s.objects[0].faces[0].corners[0].vertex]);
    s.objects[0].faces[0].corners[0].vertex = s.objects[0].vertices.size() - 1;
  });
  expect("a vertex is farther", [](Scene& s) { s.objects[0].vertices[0].x() = 1e300; });
  expect("its scale puts a vertex farther", [](Scene& s) { s.objects[0].motion.scale = 1e9; });
  expect("a lamp's towards needs a direction", [](Scene& s) {
    s.lighting.lamps = {{Vector3::Zero(), Vector3::Ones()}};
  });
  expect("a lamp's level must be within", [](Scene& s) {
    s.lighting.lamps = {{Vector3::UnitZ(), {1, -1e300, 1}}};
  });
  expect("ambient must be within", [](Scene& s) { s.lighting.ambient.z() = 1e300; });
  expect("no material", [](Scene& s) { s.objects[0].faces[0].material = 1; });
  expect("no texture", [](Scene& s) { s.objects[0].materials[0].texture = 0; });
  expect("32767", [](Scene& s) { s.objects[0].faces[0].corners[0].texture_texel = {0, 40000}; });
}

// Five corners on a line that lies half way between two rows of the grid: what is left of them
// after rounding is a zigzag, which no mapper takes; triangles of it are drawn.
TEST(Look, CutsAFaceThatRoundingBends) {
  Object object;
  object.materials.emplace_back();
  const double half_way = 1 - 100.5 / 256 / 100;  // y of the picture: 100.5 / 256 px
  for (int i = 0; i < 5; ++i) {
    object.vertices.emplace_back(1 - i * 0.5, half_way + (i % 2 ? 1e-11 : -1e-11), 0);
  }
  object.vertices.emplace_back(-1, -0.5, 0);
  object.vertices.emplace_back(1, -0.5, 0);
  object.faces.emplace_back();
  for (size_t i = 0; i < 7; ++i) object.faces[0].corners.push_back({i, {0, 0}});
  Scene scene = scene_with(object);
  scene.camera.position = {0, 0, 1};
  scene.camera.view_deg = 90;
  ASSERT_EQ(problem(scene), "");
  const View view = look(scene, 0, kViewSize);
  EXPECT_EQ(view.counts.seen, 1U);
  EXPECT_EQ(view.faces.size(), 5U);
  int64_t area = 0;
  for (const ScreenFace& face : view.faces) {
    EXPECT_TRUE(is_y_monotone(face.vertices));
    area += doubled_area_seen(face.vertices);
  }
  EXPECT_NEAR(static_cast<double>(area), 2 * 200 * 256 * (150 * 256 - 100.5), 200 * 256 * 2);
}

TEST(Look, RefusesNoFaceOfASoundScene) {
  size_t seen = 0, clipped_away = 0;
  for (uint64_t seed = 1; seed <= 500; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    spec::Random random(seed);
    Scene scene = scene_with(random.percent(50) ? cube() : ball(random.in(3, 9), random.in(2, 7)));
    Object& object = scene.objects[0];
    object.motion.scale = std::exp(real(random, -10, 10));
    object.motion.axis = direction(random);
    object.motion.angle_deg = real(random, 0, 360);
    object.motion.position = direction(random) * std::exp(real(random, -5, 5));
    object.two_sided = random.percent(50);
    scene.camera.view_deg = real(random, 1, 179);
    ASSERT_EQ(problem(scene), "");
    const View view = look(scene, 0, kViewSize);
    EXPECT_EQ(view.counts.refused, 0U);
    seen += view.counts.seen;
    clipped_away += view.counts.clipped_away;
    EXPECT_EQ(view.counts.faces, view.counts.clipped_away + view.counts.backs +
                                     view.counts.edge_on + view.counts.off_screen +
                                     view.counts.seen);
    for (const ScreenFace& face : view.faces) EXPECT_TRUE(is_y_monotone(face.vertices));
  }
  EXPECT_GT(seen, 1000U);
  EXPECT_GT(clipped_away, 100U);
}

TEST(ScreenFace, KnowsWhatIsMonotone) {
  const auto outline = [](std::initializer_list<int> ys) {
    std::vector<selvage_vertex> vertices;
    for (const int y : ys) vertices.push_back({0, y, 0, 0, 1});
    return vertices;
  };
  EXPECT_TRUE(is_y_monotone(outline({0, 1, 2})));
  EXPECT_TRUE(is_y_monotone(outline({0, 0, 0})));
  EXPECT_TRUE(is_y_monotone(outline({1, 2, 2, 3, 0, 0})));
  EXPECT_TRUE(is_y_monotone(outline({3, 2, 0, 0, 5})));
  EXPECT_FALSE(is_y_monotone(outline({0, 2, 1, 2})));
  EXPECT_FALSE(is_y_monotone(outline({2, 1, 2, 0})));
}

}  // namespace
}  // namespace selvage::scene
