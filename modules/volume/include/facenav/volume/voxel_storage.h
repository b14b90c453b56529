#pragma once
// Memory for a whole volume. A volume of a hundred megabytes costs 32 000 page faults in pages of 4 KB, which
// take longer than reading it from a warm disc; huge pages where the system offers them (Linux, madvise)
// cost 64.

#include <cstddef>
#include <vector>

namespace facenav::volume {

/// `count` zeros.
std::vector<float> voxelStorage(std::size_t count);

}  // namespace facenav::volume
