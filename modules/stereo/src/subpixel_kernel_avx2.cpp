#include "subpixel_kernel.h"

#include <cmath>

namespace facenav::stereo::subpixel {
namespace {
#include "subpixel_kernel.inl"
}  // namespace

void fitRowAvx2(const Images& images, const Limits& limits, int y, const Row& row) {
  fitRow(images, limits, y, row);
}

}  // namespace facenav::stereo::subpixel
