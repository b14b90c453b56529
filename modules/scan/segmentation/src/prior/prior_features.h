#pragma once
// Features of the prior's network on one grid: a row of channels for each voxel, with a rim of one voxel all
// around that counts as zero, so that a convolution's taps are rows at fixed distances.

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace facenav::segmentation {

struct Features {
  std::array<int, 3> size{};
  int channels = 0;
  std::vector<float> values;  // values row by row, z fastest

  /// Creates features that are all zero.
  Features(std::array<int, 3> size_, int channels_)
      : size(size_),
        channels(channels_),
        values(std::size_t(size_[0] + 2) * std::size_t(size_[1] + 2) * std::size_t(size_[2] + 2) *
               std::size_t(channels_)) {}
  /// Index of the voxel's row; -1 and size are the rim.
  std::ptrdiff_t row(int x, int y, int z) const {
    return (std::ptrdiff_t(x + 1) * (size[1] + 2) + y + 1) * (size[2] + 2) + z + 1;
  }
  float* at(int x, int y, int z) { return values.data() + row(x, y, z) * channels; }
  const float* at(int x, int y, int z) const { return values.data() + row(x, y, z) * channels; }
  /// Visits the rows of slice x.
  template <class Visit>
  void forSlice(int x, Visit&& visit) const {
    for (int y = 0; y < size[1]; ++y)
      for (int z = 0; z < size[2]; ++z) visit(x, y, z);
  }
};

}  // namespace facenav::segmentation
