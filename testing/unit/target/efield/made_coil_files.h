#pragma once
// Files of a coil, made from its dipoles.

#include <gtest/gtest.h>

#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

#include "facenav/efield/coil_file.h"
#include "facenav/efield/coil_source.h"
#include "support/refusal.h"
#include "support/test_data.h"

namespace facenav::efield {

inline std::string ccdNumber(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.9e", value);
  return text;
}

/// A .ccd of the dipoles; `scale`: 1 for metres as the format wants.
inline std::string ccdOf(const CoilDipoles& coil, double scale = 1) {
  std::string text =
      "# D70.ccd version 1.0;dIdtmax=114.73;dIdtstim=7.6;stimulator=Rapid;brand=Magstim;coilname=D70\n";
  text += std::to_string(coil.positions_mm.cols()) + "\n# centers and weighted directions of the elements\n";
  for (Eigen::Index i = 0; i < coil.positions_mm.cols(); ++i) {
    for (int c = 0; c < 3; ++c) text += ccdNumber(scale * coil.positions_mm(c, i) / 1000) + " ";
    for (int c = 0; c < 3; ++c) text += ccdNumber(coil.moments_Am2(c, i)) + (c < 2 ? " " : "\n");
  }
  return text;
}

/// NIfTI-1 of single precision, three values a voxel, spacing along the axes.
inline std::string niftiOf(const PotentialGrid& grid, const std::string& description = "dIdtmax=114.73") {
  std::string file(352, '\0');
  const auto put = [&](std::size_t at, auto value) { std::memcpy(&file[at], &value, sizeof value); };
  put(0, int(348));
  const short dim[8] = {4, short(grid.size[0]), short(grid.size[1]), short(grid.size[2]), 3, 1, 1, 1};
  for (std::size_t d = 0; d < 8; ++d) put(40 + 2 * d, dim[d]);
  put(70, short(16));
  put(72, short(32));
  put(76, 1.f);
  for (std::size_t d = 0; d < 3; ++d)
    put(80 + 4 * d, float(grid.coil_from_voxel.linear().col(int(d)).norm()));
  put(108, 352.f);
  file[123] = 2;  // mm
  std::memcpy(&file[148], description.data(), description.size());
  put(254, short(2));
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 4; ++c)
      put(280 + 16 * r + 4 * c, float(grid.coil_from_voxel(int(r), int(c))));
  std::memcpy(&file[344], "n+1", 4);
  for (int c = 0; c < 3; ++c)
    for (Eigen::Index i = 0; i < grid.potential_Tm.cols(); ++i) {
      const auto value = float(grid.potential_Tm(c, i));
      file.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
  return file;
}

/// The potential of a coil on a grid of `spacing_mm` that reaches from behind the coil to 100 mm below it.
inline PotentialGrid sampled(const CoilDipoles& coil, double spacing_mm) {
  PotentialGrid grid;
  grid.size = {int(280 / spacing_mm), int(200 / spacing_mm), int(60 / spacing_mm)};
  grid.coil_from_voxel.linear() *= spacing_mm;
  grid.coil_from_voxel.translation() = Eigen::Vector3d(-140, -100, -10);
  Eigen::Matrix3Xd points(3, Eigen::Index(grid.size[0]) * grid.size[1] * grid.size[2]);
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i)
        points.col(grid.index(i, j, k)) = grid.coil_from_voxel * Eigen::Vector3d(i, j, k);
  grid.potential_Tm = potentialOf(coil, points);
  return grid;
}

/// Test that writes a coil's file into a folder of its own, and reads it.
class CoilFiles : public ::testing::Test {
 protected:
  std::filesystem::path write(const std::string& name, const std::string& content) const {
    const auto path = folder_.path() / name;
    std::ofstream(path, std::ios::binary) << content;
    return path;
  }
  std::string refusal(const std::string& name, const std::string& content) const {
    const auto path = write(name, content);
    return facenav::testing::refusalOf([&] { readCoilSource(path); });
  }
  facenav::testing::TemporaryFolder folder_;
};

}  // namespace facenav::efield
