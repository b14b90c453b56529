#include "facenav/volume/voxel_storage.h"

#include <sys/mman.h>

#include <cstdint>

namespace facenav::volume {

std::vector<float> voxelStorage(std::size_t count) {
  constexpr std::uintptr_t kHugePage = std::uintptr_t(2) << 20;
  std::vector<float> voxels;
  voxels.reserve(count);
  const auto begin = (reinterpret_cast<std::uintptr_t>(voxels.data()) + kHugePage - 1) & ~(kHugePage - 1);
  const auto end = reinterpret_cast<std::uintptr_t>(voxels.data() + count) & ~(kHugePage - 1);
#ifdef MADV_HUGEPAGE
  if (end > begin) ::madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);  // advice: may fail
#endif
  voxels.resize(count);
  return voxels;
}

}  // namespace facenav::volume
