#pragma once
// Two volumes as sets of (world position, value): equal whatever the order and direction of their voxel axes.

#include <gtest/gtest.h>

#include <cstdlib>
#include <optional>
#include <string>

#include "facenav/volume/nifti.h"
#include "facenav/volume/regrid.h"
#include "support/test_data.h"

namespace facenav::testing {

/// Expects each voxel of one within 1e-3 mm of a voxel of the other with exactly the same value.
inline void expectSameInWorld(const volume::Volume& actual, const volume::Volume& expected) {
  const volume::Volume a = volume::toRasOrder(actual), b = volume::toRasOrder(expected);
  ASSERT_EQ(a.grid.size, b.grid.size);
  double worst_mm = 0;
  for (int c = 0; c < 8; ++c) {  // affine maps differ most at a corner
    const Eigen::Vector3d ijk((c & 1) * (a.grid.size[0] - 1), (c >> 1 & 1) * (a.grid.size[1] - 1),
                              (c >> 2) * (a.grid.size[2] - 1));
    worst_mm = std::max(worst_mm, (a.grid.toMri(ijk).mm - b.grid.toMri(ijk).mm).norm());
  }
  EXPECT_LE(worst_mm, 1e-3);
  std::size_t different = 0, first = 0;
  for (std::size_t i = 0; i < a.voxels.size(); ++i)
    if (a.voxels[i] != b.voxels[i] && different++ == 0) first = i;
  EXPECT_EQ(different, 0u) << "first at " << first << ": " << a.voxels[first] << " against "
                           << b.voxels[first];
}

inline bool hasProgram(const std::string& name) {
  return std::system(("command -v " + name + " >/dev/null 2>&1").c_str()) == 0;
}

/// Volume that dcm2niix makes of a folder; empty if it makes none or several.
inline std::optional<volume::Volume> dcm2niixVolume(const std::filesystem::path& folder) {
  const TemporaryFolder out;
  const std::string command =
      "dcm2niix -b n -z n -f v -o '" + out.path().string() + "' '" + folder.string() + "' >/dev/null 2>&1";
  if (std::system(command.c_str()) != 0) return std::nullopt;
  std::optional<std::filesystem::path> found;
  for (const auto& entry : std::filesystem::directory_iterator(out.path())) {
    if (found) return std::nullopt;
    found = entry.path();
  }
  if (!found) return std::nullopt;
  return volume::readNifti(*found).volume;
}

}  // namespace facenav::testing

#define FACENAV_NEEDS_PROGRAM(name) \
  if (!facenav::testing::hasProgram(name)) GTEST_SKIP() << "program not installed: " << (name)
