// A program outside the tree, in C++20: draws nothing, legally, through the C++ face.
#include <cstdint>
#include <selvage.hpp>

int main() {
  uint8_t pixel = 0;
  const uint8_t texel = 7;
  const selvage::Image target{&pixel, 1, 1, 1, SELVAGE_INDEX8};
  const selvage::Texture texture{&texel, 1, 1, 1, SELVAGE_INDEX8, SELVAGE_LAYOUT_ROWS, nullptr};
  const selvage::Vertex corners[3] = {{0, 0, 0, 0, 1}, {9, 9, 0, 0, 1}, {18, 18, 0, 0, 1}};
  const selvage_status status = selvage::draw(target, corners, texture);
  return status == SELVAGE_OK && pixel == 0 ? 0 : 1;
}
