// A screen without a monitor: Xvfb, whose pixels are a file, and keys pressed on it by xdotool.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

#include "cli/raster.h"

namespace selvage::cli::test {

// How long anything may take that is waited for. None of it takes a second on an idle machine.
inline constexpr int kPatience_s = 120;

[[nodiscard]] bool is_installed(const std::string& program);

// A program that runs while this lives; what it prints is read line by line.
class Child {
 public:
  Child(std::vector<std::string> arguments, const std::string& display);
  ~Child();  // ends it
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  // Without its end. Throws where none comes in time.
  [[nodiscard]] std::string read_line();
  [[nodiscard]] int exit_code();  // waits for the end

 private:
  [[nodiscard]] bool await_end() const;

  pid_t pid_ = -1;
  int output_ = -1;
  std::string read_;
};

class VirtualScreen {
 public:
  // In the current directory.
  VirtualScreen(int width_px, int height_px);

  [[nodiscard]] const std::string& display() const { return display_; }
  [[nodiscard]] Raster picture() const;

  // Returns when a window of that name is on the screen and has the keyboard.
  void await_window(const std::string& name) const;
  void press(const std::string& keys) const;  // "m shift+s": as xdotool names them

 private:
  void xdotool(const std::string& arguments) const;

  Child server_;
  std::string display_;
};

}  // namespace selvage::cli::test
