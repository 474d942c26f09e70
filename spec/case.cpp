#include "spec/case.h"

#include <algorithm>

namespace selvage::spec {
namespace {

// Layout of the header. Sizes are stored less one, so that 16 bits hold 1 .. 65536.
//
//   bytes  0   target width, target height, texture width, texture height: 2 bytes each
//          8   flags
//          9   padding: the low 4 bits; filter: the next 2; layout: the next 2, modulo 3 when read
//         10   clip: left, top, right, bottom: 2 bytes each, signed
//         18   choice: 4 bytes
constexpr size_t kVertexBytes = 17;

// Flags: the format in the low bits, modulo 3 when read; the profile in the high ones.
constexpr uint64_t kFormatMask = 3;
constexpr uint64_t kFormatCount = 3;
constexpr uint64_t kWrap = 4, kFlipTarget = 8, kFlipTexture = 16, kHasClip = 32;
constexpr int kProfileShift = 6;
static_assert(SELVAGE_PROFILE_DKIT < 1 << (8 - kProfileShift));

constexpr int kFilterShift = 4;
constexpr int kLayoutShift = 6;
constexpr uint64_t kPaddingMask = 15, kFilterMask = 3;
static_assert(SELVAGE_FILTER_AREA <= kFilterMask);

class Writer {
 public:
  // The low bytes of the two's complement.
  void put(int64_t value, int byte_count) {
    const auto bits = static_cast<uint64_t>(value);
    for (int i = 0; i < byte_count; ++i) bytes_.push_back(static_cast<uint8_t>(bits >> (8 * i)));
  }

  [[nodiscard]] std::vector<uint8_t> take() { return std::move(bytes_); }

 private:
  std::vector<uint8_t> bytes_;
};

class Reader {
 public:
  explicit Reader(std::span<const uint8_t> bytes) : rest_(bytes) {}

  [[nodiscard]] size_t left() const { return rest_.size(); }

  [[nodiscard]] uint64_t take_unsigned(int byte_count) {
    const size_t count = std::min(rest_.size(), static_cast<size_t>(byte_count));
    uint64_t value = 0;
    for (size_t i = 0; i < count; ++i) value |= uint64_t{rest_[i]} << (8 * i);
    rest_ = rest_.subspan(count);
    return value;
  }

  [[nodiscard]] int32_t take_signed(int byte_count) {
    const int unused_bits = 64 - 8 * byte_count;
    return static_cast<int32_t>(static_cast<int64_t>(take_unsigned(byte_count) << unused_bits) >>
                                unused_bits);
  }

  [[nodiscard]] int32_t take_size() { return static_cast<int32_t>(take_unsigned(2)) + 1; }

 private:
  std::span<const uint8_t> rest_;
};

[[nodiscard]] bool same_vertex(const selvage_vertex& a, const selvage_vertex& b) {
  return a.x == b.x && a.y == b.y && a.u == b.u && a.v == b.v && a.q == b.q;
}

[[nodiscard]] bool same_rect(const selvage_rect& a, const selvage_rect& b) {
  return a.left == b.left && a.top == b.top && a.right == b.right && a.bottom == b.bottom;
}

[[nodiscard]] uint64_t flags(const Case& c) {
  return (static_cast<uint64_t>(c.format) & kFormatMask) |
         (c.address == SELVAGE_ADDRESS_WRAP ? kWrap : 0) | (c.flip_target ? kFlipTarget : 0) |
         (c.flip_texture ? kFlipTexture : 0) | (c.has_clip ? kHasClip : 0) |
         static_cast<uint64_t>(c.profile) << kProfileShift;
}

void set_flags(uint64_t flags, Case* c) {
  c->format = static_cast<selvage_format>((flags & kFormatMask) % kFormatCount);
  c->address = (flags & kWrap) != 0 ? SELVAGE_ADDRESS_WRAP : SELVAGE_ADDRESS_CLAMP;
  c->flip_target = (flags & kFlipTarget) != 0;
  c->flip_texture = (flags & kFlipTexture) != 0;
  c->has_clip = (flags & kHasClip) != 0;
  c->profile = static_cast<selvage_profile>(flags >> kProfileShift);
}

[[nodiscard]] std::optional<int> hex_digit(char digit) {
  if ('0' <= digit && digit <= '9') return digit - '0';
  if ('a' <= digit && digit <= 'f') return digit - 'a' + 10;
  if ('A' <= digit && digit <= 'F') return digit - 'A' + 10;
  return std::nullopt;
}

}  // namespace

bool operator==(const Case& a, const Case& b) {
  return a.profile == b.profile && a.format == b.format && a.filter == b.filter &&
         a.address == b.address && a.target_width_px == b.target_width_px &&
         a.target_height_px == b.target_height_px &&
         a.texture_width_texel == b.texture_width_texel &&
         a.texture_height_texel == b.texture_height_texel && a.padding_px == b.padding_px &&
         a.layout == b.layout && a.flip_target == b.flip_target &&
         a.flip_texture == b.flip_texture && a.has_clip == b.has_clip &&
         same_rect(a.clip, b.clip) && a.choice == b.choice &&
         std::equal(a.vertices.begin(), a.vertices.end(), b.vertices.begin(), b.vertices.end(),
                    same_vertex);
}

std::vector<uint8_t> encode(const Case& c) {
  Writer writer;
  writer.put(c.target_width_px - 1, 2);
  writer.put(c.target_height_px - 1, 2);
  writer.put(c.texture_width_texel - 1, 2);
  writer.put(c.texture_height_texel - 1, 2);
  writer.put(static_cast<int64_t>(flags(c)), 1);
  writer.put(
      c.padding_px | c.filter << kFilterShift | static_cast<int32_t>(c.layout) << kLayoutShift, 1);
  for (const int32_t side : {c.clip.left, c.clip.top, c.clip.right, c.clip.bottom}) {
    writer.put(side, 2);
  }
  writer.put(c.choice, 4);
  for (const selvage_vertex& vertex : c.vertices) {
    writer.put(vertex.x, 3);
    writer.put(vertex.y, 3);
    writer.put(vertex.u, 4);
    writer.put(vertex.v, 4);
    writer.put(vertex.q - 1, 3);
  }
  return writer.take();
}

Case decode(std::span<const uint8_t> bytes) {
  Reader reader(bytes);
  Case c;
  c.target_width_px = reader.take_size();
  c.target_height_px = std::min(reader.take_size(), kMaxTargetPx / c.target_width_px);
  c.texture_width_texel = reader.take_size();
  c.texture_height_texel = std::min(reader.take_size(), kMaxTextureTexels / c.texture_width_texel);
  set_flags(reader.take_unsigned(1), &c);
  const uint64_t texture = reader.take_unsigned(1);
  c.padding_px = static_cast<int32_t>(texture & kPaddingMask);
  c.filter = static_cast<selvage_filter>(texture >> kFilterShift & kFilterMask);
  c.layout = static_cast<Layout>((texture >> kLayoutShift) % kLayoutCount);
  for (int32_t* side : {&c.clip.left, &c.clip.top, &c.clip.right, &c.clip.bottom}) {
    *side = reader.take_signed(2);
  }
  c.choice = static_cast<uint32_t>(reader.take_unsigned(4));
  while (reader.left() >= kVertexBytes && c.vertices.size() < kMaxVertices) {
    selvage_vertex vertex{};
    vertex.x = reader.take_signed(3);
    vertex.y = reader.take_signed(3);
    vertex.u = reader.take_signed(4);
    vertex.v = reader.take_signed(4);
    vertex.q = static_cast<int32_t>(reader.take_unsigned(3)) + 1;
    c.vertices.push_back(vertex);
  }
  return c;
}

std::string to_hex(const Case& c) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string hex;
  for (const uint8_t byte : encode(c)) {
    hex += kDigits[byte >> 4];
    hex += kDigits[byte & 15];
  }
  return hex;
}

std::optional<Case> from_hex(std::string_view hex) {
  if (hex.size() % 2 != 0) return std::nullopt;
  std::vector<uint8_t> bytes;
  for (size_t i = 0; i < hex.size(); i += 2) {
    const std::optional<int> high = hex_digit(hex[i]), low = hex_digit(hex[i + 1]);
    if (!high || !low) return std::nullopt;
    bytes.push_back(static_cast<uint8_t>(*high * 16 + *low));
  }
  return decode(bytes);
}

}  // namespace selvage::spec
