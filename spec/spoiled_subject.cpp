#include "spec/spoiled_subject.h"

#include <array>
#include <cstring>
#include <utility>
#include <vector>

#include "spec/canvas.h"

namespace selvage::spec {
namespace {

using PixelBytes = std::array<unsigned char, 4>;

constexpr unsigned char kPaint = 0x3C;  // in no background of the laws' pictures

// Pixels of a target that may be none: hostile calls have such.
class Pixels {
 public:
  explicit Pixels(const selvage_image* target) : target_(target) {}

  [[nodiscard]] bool has(int32_t x_px, int32_t y_px) const {
    return target_ != nullptr && target_->pixels != nullptr && x_px < target_->width &&
           y_px < target_->height;
  }
  [[nodiscard]] size_t size() const {
    return static_cast<size_t>(bytes_per_pixel(target_->format));
  }
  [[nodiscard]] unsigned char* at(int32_t x_px, int32_t y_px) const {
    return static_cast<unsigned char*>(target_->pixels) + y_px * target_->pitch +
           x_px * static_cast<ptrdiff_t>(size());
  }
  [[nodiscard]] PixelBytes value(int32_t x_px, int32_t y_px) const {
    PixelBytes bytes{};
    if (has(x_px, y_px)) std::memcpy(bytes.data(), at(x_px, y_px), size());
    return bytes;
  }

 private:
  const selvage_image* target_;
};

[[nodiscard]] unsigned char spoiled(Spoiling how, unsigned char before, unsigned char after,
                                    bool was_drawn) {
  switch (how) {
    case Spoiling::kToggled:
      return was_drawn ? before : kPaint;
    case Spoiling::kOtherBits:
      return static_cast<unsigned char>(~after);
    case Spoiling::kPainted:
      return kPaint;
    default:
      return static_cast<unsigned char>(before + 1);
  }
}

// Draws, then spoils the pixel.
template <class Draw>
[[nodiscard]] selvage_status spoil_after(const Spot& spot, const selvage_image* target, Draw draw) {
  const Pixels pixels(target);
  const PixelBytes before = pixels.value(spot.x_px, spot.y_px);
  const selvage_status status = draw();
  if (!pixels.has(spot.x_px, spot.y_px)) return status;
  const PixelBytes after = pixels.value(spot.x_px, spot.y_px);
  unsigned char* const pixel = pixels.at(spot.x_px, spot.y_px);
  for (size_t i = 0; i < pixels.size(); ++i) {
    pixel[i] = spoiled(spot.how, before[i], after[i], before != after);
  }
  return status;
}

[[nodiscard]] bool is_now(const Moment& when, size_t call, const selvage_rect* clip,
                          const selvage_options* options) {
  switch (when.kind) {
    case Moment::Kind::kAny:
      return true;
    case Moment::Kind::kDrawing:
      return call / 2 == static_cast<size_t>(when.number);
    case Moment::Kind::kTile:
      return clip != nullptr;
    case Moment::Kind::kKernel:
      return options != nullptr && options->kernel == when.number;
    default:
      return false;
  }
}

[[nodiscard]] std::vector<PixelBytes> all_of(const selvage_image* target) {
  const Pixels pixels(target);
  std::vector<PixelBytes> all;
  for (int32_t y = 0; pixels.has(0, y); ++y) {
    for (int32_t x = 0; pixels.has(x, y); ++x) all.push_back(pixels.value(x, y));
  }
  return all;
}

}  // namespace

Subject wrong_in(const Spot& spot, selvage_profile profile) {
  Subject subject = built_in(profile);
  const auto calls = std::make_shared<size_t>(0);
  subject.draw = [spot, calls, draw = std::move(subject.draw)](
                     const selvage_image* target, const selvage_rect* clip,
                     const selvage_vertex* vertices, size_t count, const selvage_texture* texture,
                     const selvage_options* options) {
    const auto right = [&] { return draw(target, clip, vertices, count, texture, options); };
    return is_now(spot.when, (*calls)++, clip, options) ? spoil_after(spot, target, right)
                                                        : right();
  };
  subject.draw_many = [spot, many = std::move(subject.draw_many)](
                          const selvage_image* target, const selvage_rect* clip,
                          const selvage_polygon* polygons, size_t count,
                          const selvage_options* options, int32_t threads, size_t* failed) {
    const auto right = [&] {
      return many(target, clip, polygons, count, options, threads, failed);
    };
    const bool is_this = spot.when.kind == Moment::Kind::kAny ||
                         (spot.when.kind == Moment::Kind::kThreads && threads == spot.when.number);
    return is_this ? spoil_after(spot, target, right) : right();
  };
  return subject;
}

Subject counting(std::shared_ptr<uint64_t> drawn_px, selvage_profile profile) {
  Subject subject = built_in(profile);
  subject.draw = [drawn_px, draw = std::move(subject.draw)](
                     const selvage_image* target, const selvage_rect* clip,
                     const selvage_vertex* vertices, size_t count, const selvage_texture* texture,
                     const selvage_options* options) {
    // A call with a bad target is not looked at.
    const selvage_rect nothing{0, 0, 0, 0};
    if (draw(target, &nothing, vertices, count, texture, options) != SELVAGE_OK) {
      return draw(target, clip, vertices, count, texture, options);
    }
    const std::vector<PixelBytes> before = all_of(target);
    const selvage_status status = draw(target, clip, vertices, count, texture, options);
    const std::vector<PixelBytes> after = all_of(target);
    for (size_t i = 0; i < after.size(); ++i) *drawn_px += before[i] != after[i] ? 1 : 0;
    return status;
  };
  return subject;
}

}  // namespace selvage::spec
