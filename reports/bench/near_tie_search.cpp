#include "reports/bench/near_tie_search.h"

#include <algorithm>
#include <chrono>

#include "reports/bench/image.h"
#include "reports/bench/measurement.h"
#include "reports/bench/near_tie_maps.h"

namespace selvage::reports {

namespace {

// Drawings of polygons by a kernel, on a picture of their own.
class Drawing {
 public:
  explicit Drawing(selvage_kernel kernel)
      : kernel_(kernel),
        texture_(kMapTexture_texel),
        target_(kMapWidth_px, kMapHeight_px),
        scalar_(target_.pixels.size()) {}

  void set_address(selvage_address address) { address_ = address; }

  [[nodiscard]] bool is_right(const Polygon& polygon) {
    draw_anew(SELVAGE_KERNEL_SCALAR, polygon);
    std::ranges::copy(target_.pixels, scalar_.begin());
    draw_anew(kernel_, polygon);
    return target_.pixels == scalar_;
  }

  // Of one drawing, the mean over so many.
  [[nodiscard]] double time_ns(const Polygon& polygon, int64_t drawings) {
    const auto start = std::chrono::steady_clock::now();
    for (int64_t i = 0; i < drawings; ++i) draw(kernel_, polygon);
    const std::chrono::duration<double, std::nano> all = std::chrono::steady_clock::now() - start;
    return all.count() / static_cast<double>(drawings);
  }

 private:
  void draw(selvage_kernel kernel, const Polygon& polygon) {
    const selvage_image image = target_.image();
    const selvage_texture texture = texture_.view();
    selvage_options options{};
    options.kernel = kernel;
    options.address = address_;
    const selvage_status status =
        selvage_draw(&image, nullptr, polygon.data(), polygon.size(), &texture, &options);
    if (status != SELVAGE_OK) throw WrongAnswer(selvage_status_text(status));
  }
  void draw_anew(selvage_kernel kernel, const Polygon& polygon) {
    std::ranges::fill(target_.pixels, kUntouched);
    draw(kernel, polygon);
  }

  selvage_kernel kernel_;
  selvage_address address_ = SELVAGE_ADDRESS_CLAMP;
  Texture texture_;
  Target target_;
  std::vector<uint32_t> scalar_;  // a picture by the scalar kernel
};

// Drawings take microseconds, and there are thousands of them: what other programs take meanwhile
// is left out by the least of some times, in turns.
class MapTimes {
 public:
  MapTimes(Drawing* drawing, const NearTieMap& map) : drawing_(drawing) {
    timed_.push_back(&map.hard);
    for (const Polygon& moved : map.ordinary) timed_.push_back(&moved);
    for (const Polygon* polygon : timed_) {
      constexpr double kOnce_ns = 20000;
      const double once_ns = drawing_->time_ns(*polygon, 2);
      drawings_.push_back(1 + static_cast<int64_t>(kOnce_ns / once_ns));
      least_ns_.push_back(once_ns);
    }
  }

  void time(int32_t turns) {
    for (int32_t turn = 0; turn < turns; ++turn) {
      for (size_t i = 0; i < timed_.size(); ++i) {
        least_ns_[i] = std::min(least_ns_[i], drawing_->time_ns(*timed_[i], drawings_[i]));
      }
    }
  }
  [[nodiscard]] double hard_ns() const { return least_ns_.front(); }
  [[nodiscard]] double ordinary_ns() const {
    return spread_of({least_ns_.begin() + 1, least_ns_.end()}).median;
  }

 private:
  Drawing* drawing_;
  std::vector<const Polygon*> timed_;
  std::vector<int64_t> drawings_;
  std::vector<double> least_ns_;
};

[[nodiscard]] TimedMap timed_map(Drawing* drawing, uint64_t seed) {
  const NearTieMap map = near_tie_map(seed);
  drawing->set_address(map.address);
  if (!drawing->is_right(map.hard) || !std::ranges::all_of(map.ordinary, [&](const Polygon& moved) {
        return drawing->is_right(moved);
      })) {
    throw WrongAnswer("a kernel draws something else than the scalar one: map " +
                      std::to_string(seed) + ", " + map.description);
  }
  constexpr double kDoubtful = kMostTimesOrdinary * 0.8;
  MapTimes times(drawing, map);
  times.time(7);
  // What seems to be much is timed for longer, not to report what others took.
  if (times.hard_ns() > kDoubtful * times.ordinary_ns()) times.time(50);
  return {seed, map.description, times.hard_ns(), times.ordinary_ns()};
}

}  // namespace

size_t NearTieSearch::above(double ratio) const {
  return static_cast<size_t>(ratios.end() - std::ranges::upper_bound(ratios, ratio));
}

NearTieSearch search_near_ties(const MapSeeds& seeds, selvage_kernel kernel,
                               const std::function<void()>& tick) {
  NearTieSearch search;
  search.first_seed = seeds.first;
  search.kernel = kernel;
  Drawing drawing(kernel);
  for (int32_t i = 0; i < seeds.count; ++i) {
    tick();
    const TimedMap map = timed_map(&drawing, seeds.first + static_cast<uint64_t>(i));
    search.ratios.push_back(map.ratio());
    const auto place = std::ranges::upper_bound(search.worst, map.ratio(), std::ranges::greater(),
                                                &TimedMap::ratio);
    search.worst.insert(place, map);
    if (search.worst.size() > NearTieSearch::kWorst) search.worst.pop_back();
  }
  std::ranges::sort(search.ratios);
  return search;
}

}  // namespace selvage::reports
