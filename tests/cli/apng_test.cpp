#include "cli/apng.h"

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "cli/png.h"
#include "sample_pictures.h"
#include "support.h"

namespace selvage::cli::test {
namespace {

using Bytes = std::vector<uint8_t>;

struct Chunk {
  std::string type;
  Bytes data;
};

[[nodiscard]] uint32_t number(std::span<const uint8_t> bytes, size_t at, size_t count) {
  uint32_t value = 0;
  for (size_t i = 0; i < count; ++i) value = value << 8 | bytes[at + i];
  return value;
}

// Every chunk, its CRC checked.
[[nodiscard]] std::vector<Chunk> chunks_of(const Bytes& file) {
  EXPECT_TRUE(is_png(file));
  std::vector<Chunk> chunks;
  size_t at = 8;
  while (at + 12 <= file.size()) {
    const size_t length = number(file, at, 4);
    if (at + 12 + length > file.size()) break;
    const std::span whole = std::span(file).subspan(at, length + 12);
    EXPECT_EQ(crc32(0, whole.data() + 4, static_cast<uInt>(length + 4)),
              number(whole, length + 8, 4));
    chunks.push_back({std::string(whole.begin() + 4, whole.begin() + 8),
                      Bytes(whole.begin() + 8, whole.end() - 4)});
    at += length + 12;
  }
  EXPECT_EQ(at, file.size());
  return chunks;
}

void append(Bytes& png, const Chunk& chunk) {
  const auto put = [&](uint32_t value) {
    for (const int shift : {24, 16, 8, 0}) png.push_back(static_cast<uint8_t>(value >> shift));
  };
  put(static_cast<uint32_t>(chunk.data.size()));
  const size_t start = png.size();
  png.insert(png.end(), chunk.type.begin(), chunk.type.end());
  png.insert(png.end(), chunk.data.begin(), chunk.data.end());
  put(static_cast<uint32_t>(crc32(0, png.data() + start, static_cast<uInt>(png.size() - start))));
}

// Each frame as a PNG of its own, made of the file's header and the frame's data.
[[nodiscard]] std::vector<Raster> frames_of(const std::vector<Chunk>& chunks) {
  std::vector<Bytes> pngs;
  for (const Chunk& chunk : chunks) {
    if (chunk.type == "fcTL") {
      pngs.emplace_back(
          std::initializer_list<uint8_t>{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'});
      append(pngs.back(), chunks.front());
    } else if (chunk.type == "IDAT") {
      append(pngs.back(), chunk);
    } else if (chunk.type == "fdAT") {
      append(pngs.back(), {"IDAT", Bytes(chunk.data.begin() + 4, chunk.data.end())});
    }
  }
  std::vector<Raster> frames;
  for (Bytes& png : pngs) {
    append(png, {"IEND", {}});
    frames.push_back(decode_png(png));
  }
  return frames;
}

// Noise does not compress: libpng cuts its data into several chunks.
[[nodiscard]] Raster noise(int32_t width_px, int32_t height_px, uint32_t seed) {
  Raster raster = filled(width_px, height_px, {});
  for (uint8_t& byte : raster.rgba) {
    seed = seed * 1664525 + 1013904223;
    byte = static_cast<uint8_t>(seed >> 24);
  }
  return raster;
}

[[nodiscard]] Bytes animated(const std::vector<Raster>& frames, const FrameDelay& delay) {
  Apng animation(static_cast<uint32_t>(frames.size()), delay);
  for (const Raster& frame : frames) animation.add(frame);
  return animation.finish();
}

TEST(Apng, HoldsEveryFrameToThePixel) {
  const std::vector<Raster> frames{sample_raster(24, 18), noise(24, 18, 1), noise(24, 18, 2)};
  const Bytes file = animated(frames, {});
  EXPECT_EQ(frames_of(chunks_of(file)), frames);
  EXPECT_EQ(decode_png(file), frames[0]);  // by a reader that knows nothing of animations
}

TEST(Apng, HoldsFramesOfManyChunks) {
  const std::vector<Raster> frames{noise(300, 200, 3), noise(300, 200, 4)};
  const std::vector<Chunk> chunks = chunks_of(animated(frames, {}));
  int of_first = 0, of_second = 0;
  for (const Chunk& chunk : chunks) {
    of_first += chunk.type == "IDAT";
    of_second += chunk.type == "fdAT";
  }
  EXPECT_GT(of_first, 1);
  EXPECT_GT(of_second, 1);
  EXPECT_EQ(frames_of(chunks), frames);
}

// IHDR, then acTL before any data; a control chunk a frame, before its data; numbers without gaps.
TEST(Apng, OrdersAndNumbersItsChunks) {
  const std::vector<Raster> frames{noise(300, 20, 5), noise(300, 20, 6), noise(300, 20, 7)};
  const std::vector<Chunk> chunks = chunks_of(animated(frames, {3, 50}));
  ASSERT_GE(chunks.size(), 2U);
  EXPECT_EQ(chunks.front().type, "IHDR");
  EXPECT_EQ(chunks[1].type, "acTL");
  EXPECT_EQ(chunks[1].data, (Bytes{0, 0, 0, 3, 0, 0, 0, 0}));
  EXPECT_EQ(chunks.back().type, "IEND");
  uint32_t sequence = 0;
  int controls = 0;
  for (const Chunk& chunk : chunks) {
    if (chunk.type == "IDAT") {
      EXPECT_EQ(controls, 1);
    }
    if (chunk.type != "fcTL" && chunk.type != "fdAT") continue;
    EXPECT_EQ(number(chunk.data, 0, 4), sequence++);
    if (chunk.type == "fdAT") {
      EXPECT_GT(controls, 1);
      continue;
    }
    ++controls;
    ASSERT_EQ(chunk.data.size(), 26U);
    EXPECT_EQ(number(chunk.data, 4, 4), 300U);
    EXPECT_EQ(number(chunk.data, 8, 4), 20U);
    EXPECT_EQ(number(chunk.data, 12, 4), 0U);
    EXPECT_EQ(number(chunk.data, 16, 4), 0U);
    EXPECT_EQ(number(chunk.data, 20, 2), 3U);
    EXPECT_EQ(number(chunk.data, 22, 2), 50U);
    EXPECT_EQ(number(chunk.data, 24, 2), 0U);
  }
  EXPECT_EQ(controls, 3);
}

TEST(Apng, OneFrameIsAnAnimationToo) {
  const std::vector<Chunk> chunks = chunks_of(animated({sample_raster(24, 18)}, {}));
  EXPECT_EQ(chunks[1].data, (Bytes{0, 0, 0, 1, 0, 0, 0, 0}));
  EXPECT_EQ(frames_of(chunks), std::vector<Raster>{sample_raster(24, 18)});
}

TEST(Apng, TakesTheFramesThatWereAnnounced) {
  Apng few(2, {});
  few.add(sample_raster(24, 18));
  EXPECT_THROW((void)few.finish(), std::logic_error);
  EXPECT_THROW(few.add(sample_raster(18, 24)), std::logic_error);
  Apng many(1, {});
  many.add(sample_raster(24, 18));
  EXPECT_THROW(many.add(sample_raster(24, 18)), std::logic_error);
}

TEST(FrameDelay, IsTheRatesReciprocal) {
  EXPECT_EQ(frame_delay(25), (FrameDelay{1, 25}));
  EXPECT_EQ(frame_delay(60), (FrameDelay{1, 60}));
  EXPECT_EQ(frame_delay(0.5), (FrameDelay{2, 1}));
  EXPECT_EQ(frame_delay(12.5), (FrameDelay{2, 25}));
  EXPECT_EQ(frame_delay(30000.0 / 1001), (FrameDelay{1001, 30000}));
  EXPECT_EQ(frame_delay(65535), (FrameDelay{1, 65535}));
  EXPECT_EQ(frame_delay(1.0 / 65535), (FrameDelay{65535, 1}));
}

// Of whole rates exactly. A convergent p / q of the delay is within 1 / (q q') of it, p' / q' the
// next one. That was left out, so q' > 65535, or p' > 65535; and p' < delay q' + 1.
TEST(FrameDelay, IsAsNearAsTheFormatAllows) {
  for (int rate = 1; rate <= 65535; rate += 7) {
    EXPECT_EQ(frame_delay(rate), (FrameDelay{1, static_cast<uint16_t>(rate)}));
  }
  for (int i = 1; i <= 500; ++i) {
    const double rate = std::sqrt(i) * std::numbers::pi / 30;
    const FrameDelay delay = frame_delay(rate);
    const double value = static_cast<double>(delay.numerator) / delay.denominator;
    const double next = std::min(65536.0, 65535 * rate);
    EXPECT_LE(std::abs(value - 1 / rate), 1 / (delay.denominator * next)) << rate;
  }
}

TEST(FrameDelay, RefusesWhatTheFormatCannotSay) {
  for (const double rate : {1e-6, 1e6, 70000.0}) {
    expect_contains(error_of([&] { (void)frame_delay(rate); }), "1/65535 to 65535 frames a second");
  }
}

}  // namespace
}  // namespace selvage::cli::test
