// A window that shows pictures and tells keys. The one file of the program that knows SDL.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "cli/demo_state.h"
#include "cli/raster.h"

namespace selvage::cli {

class DemoWindow {
 public:
  // Throws a UserError where there is no window system.
  DemoWindow(const std::string& title, scene::Size size);
  ~DemoWindow();
  DemoWindow(const DemoWindow&) = delete;
  DemoWindow& operator=(const DemoWindow&) = delete;

  [[nodiscard]] scene::Size size() const;

  // The keys pressed since the last call, in order. A closed window is kQuit.
  [[nodiscard]] std::vector<DemoKey> keys();

  // When it returns, the window system has the picture.
  void show(Raster& picture);

  void rest_ms(int64_t time_ms);

 private:
  struct Handles;
  std::unique_ptr<Handles> handles_;
};

}  // namespace selvage::cli
