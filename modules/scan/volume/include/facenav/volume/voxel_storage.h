#pragma once
// Memory for a whole volume. With pages of 4 KB, a volume of a hundred megabytes costs 32 000 page faults,
// which take longer than reading it from a cached file. With huge pages, where the system offers them (Linux,
// madvise), it costs 64.

#include <cstddef>
#include <vector>

namespace facenav::volume {

/// `count` zeros.
std::vector<float> voxelStorage(std::size_t count);

}  // namespace facenav::volume
