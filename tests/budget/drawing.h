// A stated workload with its texture and its target, to be drawn more than once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "selvage.h"
#include "work.h"

namespace selvage::budget {

// So many pixels or texels in memory of its own pages: how many instructions draw them depends on
// where they lie in a vector's bytes.
class Pixels {
 public:
  Pixels(size_t count, uint32_t value);
  [[nodiscard]] std::span<uint32_t> get() const { return {first_.get(), count_}; }

 private:
  struct Free {
    void operator()(uint32_t* memory) const;
  };

  std::unique_ptr<uint32_t, Free> first_;
  size_t count_;
};

// Padded, as the benchmark's textures are; with sums if the work wants them.
class Texture {
 public:
  explicit Texture(const Work& work);
  Texture(const Texture&) = delete;
  Texture& operator=(const Texture&) = delete;

  [[nodiscard]] selvage_status status() const { return status_; }
  [[nodiscard]] const selvage_texture& get() const { return texture_; }

 private:
  [[nodiscard]] selvage_status prepare();

  Pixels texels_;
  std::optional<Pixels> prepared_;
  selvage_texture texture_{};
  selvage_status status_ = SELVAGE_OK;
};

class Drawing {
 public:
  Drawing(const Work& work, selvage_kernel kernel);
  Drawing(const Drawing&) = delete;
  Drawing& operator=(const Drawing&) = delete;

  // The first status that is not SELVAGE_OK, of the texture or of a polygon.
  [[nodiscard]] selvage_status draw();
  // How many of the work's units that was.
  [[nodiscard]] size_t units() const;

 private:
  const Work& work_;
  Texture texture_;
  Pixels pixels_;
  selvage_image target_;
  selvage_options options_{};
  std::vector<selvage_polygon> list_;
  std::vector<std::max_align_t> scratch_;
};

}  // namespace selvage::budget
