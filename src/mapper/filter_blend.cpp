#include "mapper/filter_blend.h"

#include <cstddef>

#include "mapper/address.h"
#include "mapper/channels.h"
#include "mapper/layout.h"

namespace selvage::mapper {
namespace {

// The texels around a point: in columns s and s + 1, rows t and t + 1, each addressed by itself.
struct Around {
  Channels upper_left, upper_right, lower_left, lower_right;
};

template <class Address, class Layout>
[[nodiscard]] inline Around texels_around(FilterPoint point, const selvage_texture& texture) {
  const auto column = [&](int32_t s) {
    return Layout::column(Address::index(s, texture.width)) * kPixelBytes;
  };
  const auto row = [&](int32_t t) {
    return static_cast<const char*>(texture.texels) +
           Layout::row(Address::index(t, texture.height), texture.pitch / kPixelBytes) *
               kPixelBytes;
  };
  const int32_t s = point.u_fx8 >> kGridBits, t = point.v_fx8 >> kGridBits;
  const ptrdiff_t left = column(s), right = column(s + 1);
  const char *const upper = row(t), *const lower = row(t + 1);
  return {Channels::of(load_texel(upper + left)), Channels::of(load_texel(upper + right)),
          Channels::of(load_texel(lower + left)), Channels::of(load_texel(lower + right))};
}

struct Four {
  [[nodiscard]] static uint32_t mix(const Around& a, FilterPoint /*point*/) {
    const Channels sum = a.upper_left + a.upper_right + a.lower_left + a.lower_right;
    return ((sum + Channels::all(2)) >> 2).texel();
  }
};

struct Bilinear {
  // A sum is at most 255 * 65536 + 32768: 24 bits.
  [[nodiscard]] static uint32_t mix(const Around& a, FilterPoint point) {
    constexpr uint32_t kOne = kTexel_fx8;
    const uint32_t right = static_cast<uint32_t>(point.u_fx8) & (kOne - 1);
    const uint32_t lower = static_cast<uint32_t>(point.v_fx8) & (kOne - 1);
    const uint32_t left = kOne - right, upper = kOne - lower;
    const Channels sum = a.upper_left * (left * upper) + a.upper_right * (right * upper) +
                         a.lower_left * (left * lower) + a.lower_right * (right * lower);
    return ((sum + Channels::all(kOne * kOne / 2)) >> (2 * kGridBits)).texel();
  }
};

template <class Mix, class Address, class Layout>
void blend_laid_out(std::span<const FilterPoint> points, const selvage_texture texture,
                    char* pixel) {
  for (const FilterPoint point : points) {
    store_pixel(pixel, Mix::mix(texels_around<Address, Layout>(point, texture), point));
    pixel += kPixelBytes;
  }
}

template <class Mix, class Address>
void blend(std::span<const FilterPoint> points, const selvage_texture& texture, char* pixels) {
  with_layout(texture.layout, [&](auto layout) {
    blend_laid_out<Mix, Address, decltype(layout)>(points, texture, pixels);
  });
}

[[nodiscard]] bool is_inside(FilterPoint point, const selvage_texture& texture) {
  const int32_t s = point.u_fx8 >> kGridBits, t = point.v_fx8 >> kGridBits;
  return 0 <= s && s < texture.width - 1 && 0 <= t && t < texture.height - 1;
}

// u and v are monotone along a span, so the ends tell whether all of it is inside the texture.
template <class Mix>
void blend_addressed(std::span<const FilterPoint> points, const selvage_texture& texture,
                     selvage_address address, char* pixels) {
  if (is_inside(points.front(), texture) && is_inside(points.back(), texture)) {
    blend<Mix, Inside>(points, texture, pixels);
  } else if (address == SELVAGE_ADDRESS_CLAMP) {
    blend<Mix, Clamp>(points, texture, pixels);
  } else if (WrapMasked::fits(texture.width) && WrapMasked::fits(texture.height)) {
    blend<Mix, WrapMasked>(points, texture, pixels);
  } else {
    blend<Mix, Wrap>(points, texture, pixels);
  }
}

}  // namespace

void blend_four(std::span<const FilterPoint> points, const selvage_texture& texture,
                selvage_address address, char* pixels) {
  blend_addressed<Four>(points, texture, address, pixels);
}

void blend_bilinear(std::span<const FilterPoint> points, const selvage_texture& texture,
                    selvage_address address, char* pixels) {
  blend_addressed<Bilinear>(points, texture, address, pixels);
}

}  // namespace selvage::mapper
