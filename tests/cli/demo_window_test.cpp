// The demo in a window: the program as a user runs it, on a screen without a monitor. After every
// key comes a P, whose answer tells that the window shows what the keys before it asked for.
#include <gtest/gtest.h>

#include <sys/wait.h>

#include <cstdlib>
#include <initializer_list>

#include "cli/demo_picture.h"
#include "cli/shipped_scene.h"
#include "demo_support.h"
#include "support.h"
#include "virtual_screen.h"

namespace selvage::cli::test {
namespace {

class DemoOnScreen : public InDirectory {
 protected:
  void SetUp() override {
    if (!is_installed("Xvfb") || !is_installed("xdotool")) {
      GTEST_SKIP() << "the demo's window was not tried: Xvfb or xdotool is not installed (Debian: "
                      "xvfb, xdotool)";
    }
  }

  struct Shown {
    std::string line;
    Raster picture;
  };
  static Shown after(const VirtualScreen& screen, Child& demo, const std::string& keys) {
    screen.press(keys + " p");
    Shown shown{demo.read_line(), {}};
    shown.picture = screen.picture();
    return shown;
  }
};

struct NamedKey {
  const char* name;
  DemoKey key;
};

// Each key on its own and all upon one another, pixel by pixel what the state's picture is.
TEST_F(DemoOnScreen, ShowsThePictureOfTheStateAfterEachKey) {
  put("still.json", still_scene_text());
  const scene::Scene scene = read_scene("still.json");
  const VirtualScreen screen(480, 360);
  Child demo({SELVAGE_PROGRAM, "demo", "still.json", "--size", "480x360"}, screen.display());
  screen.await_window("Selvage");
  DemoState state = demo_start(scene);
  for (const NamedKey& named : std::initializer_list<NamedKey>{
           {"h", DemoKey::kHelp},         {"s", DemoKey::kFaster},    {"shift+s", DemoKey::kSlower},
           {"x", DemoKey::kAxisX},        {"y", DemoKey::kAxisY},     {"z", DemoKey::kAxisZ},
           {"space", DemoKey::kFlipAxis}, {"Left", DemoKey::kLeft},   {"Left", DemoKey::kLeft},
           {"Right", DemoKey::kRight},    {"Up", DemoKey::kUp},       {"Up", DemoKey::kUp},
           {"Down", DemoKey::kDown},      {"plus", DemoKey::kNearer}, {"KP_Add", DemoKey::kNearer},
           {"minus", DemoKey::kFarther},  {"f", DemoKey::kFilter},    {"m", DemoKey::kMapper},
           {"d", DemoKey::kDifference},   {"m", DemoKey::kMapper},    {"d", DemoKey::kDifference},
           {"m", DemoKey::kMapper},       {"f", DemoKey::kFilter},    {"h", DemoKey::kHelp}}) {
    const Raster before = screen.picture();
    const Shown shown = after(screen, demo, named.name);
    press(state, named.key);
    const DemoPicture expected = demo_picture(scene, state, {480, 360});
    EXPECT_EQ(shown.picture, expected.raster) << "after " << named.name << ": " << shown.line;
    expect_contains(shown.line, " frames/s, ");
    expect_contains(shown.line, demo_settings(state) + "; " + demo_counts(state, expected));
    EXPECT_NE(shown.picture, before) << named.name << " shows nothing";
  }
  screen.press("q");
  EXPECT_EQ(demo.exit_code(), 0);
}

// The shipped station: it turns while it is asked to, stops when it is, and comes back to the bit.
TEST_F(DemoOnScreen, TurnsTheStationAndStopsIt) {
  const VirtualScreen screen(320, 240);
  Child demo({SELVAGE_PROGRAM, "demo", "--size", "320x240"}, screen.display());
  screen.await_window("Selvage");
  const Shown still = after(screen, demo, "h shift+s shift+s shift+s shift+s");
  expect_contains(still.line, "mapper exact, filter auto, axis own, speed 0.00");
  EXPECT_EQ(after(screen, demo, "").picture, still.picture);
  const Shown historic = after(screen, demo, "m");
  EXPECT_NE(above_text(historic.picture), above_text(still.picture));
  EXPECT_EQ(after(screen, demo, "m m").picture, still.picture);
  EXPECT_EQ(after(screen, demo, "Left Up plus minus Down Right").picture, still.picture);

  Shown turning = after(screen, demo, "s s s s");
  const Raster first = turning.picture;
  for (int tries = 0; above_text(turning.picture) == above_text(first); ++tries) {
    ASSERT_LT(tries, 1000) << "it does not turn";
    turning = after(screen, demo, "");
  }
  const Shown stopped = after(screen, demo, "shift+s shift+s shift+s shift+s");
  EXPECT_NE(above_text(stopped.picture), above_text(still.picture));
  EXPECT_EQ(after(screen, demo, "").picture, stopped.picture);
  screen.press("Escape");
  EXPECT_EQ(demo.exit_code(), 0);
}

TEST_F(DemoOnScreen, EndsAfterSoManyFrames) {
  const VirtualScreen screen(160, 120);
  Child demo({SELVAGE_PROGRAM, "demo", "--size", "160x120", "--frames", "3"}, screen.display());
  EXPECT_EQ(demo.exit_code(), 0);
}

class DemoErrors : public InDirectory {
 protected:
  static int run(const std::string& arguments) {
    const std::string command =
        "env -u DISPLAY -u WAYLAND_DISPLAY -u SDL_VIDEODRIVER '" SELVAGE_PROGRAM "' demo " +
        arguments + " > out 2> err";
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
};

TEST_F(DemoErrors, NameWhatIsWrong) {
  EXPECT_EQ(run("--frames 2"), 2);
  expect_contains(get("err"), "selvage: no window can be opened: ");
  expect_contains(get("err"), "DISPLAY");
  EXPECT_EQ(run("none.json"), 2);
  expect_contains(get("err"), "none.json");
  EXPECT_EQ(run("--frames -1"), 2);
  expect_contains(get("err"), "--frames");
  EXPECT_EQ(run("--size 20000x10"), 2);
  expect_contains(get("err"), "--size: ");
  EXPECT_EQ(run("--help"), 0);
  expect_contains(get("out"), "selvage demo src/scene/shipped/station/station.json");
}

TEST(ShippedScene, IsFoundOrNamedWithAllPlaces) {
  EXPECT_EQ(first_scene(shipped_scene_places("station")),
            SELVAGE_SOURCE_TREE "/src/scene/shipped/station/station.json");
  const std::string error = error_of([] { (void)first_scene({"/none/a.json", "/none/b.json"}); });
  expect_contains(error, "/none/a.json");
  expect_contains(error, "/none/b.json");
  expect_contains(error, "selvage demo SCENE.json");
}

}  // namespace
}  // namespace selvage::cli::test
