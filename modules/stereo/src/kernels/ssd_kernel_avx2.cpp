#include "ssd_kernel.h"

namespace facenav::stereo::ssd {
namespace {
#include "ssd_kernel.inl"
}  // namespace

void searchRowsAvx2(const Images& images, const Scratch& scratch, int first, int last, int uniqueness,
                    std::int16_t* disparity, int disparity_stride) {
  searchRows(images, scratch, first, last, uniqueness, disparity, disparity_stride);
}

}  // namespace facenav::stereo::ssd
