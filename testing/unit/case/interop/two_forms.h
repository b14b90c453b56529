#pragma once
// A T1 whose voxels are stored left, posterior, inferior on an oblique grid, and whose qform differs from its
// sform by some centimetres, as after a program has aligned it to another scan.

#include "facenav/geometry/rotation.h"
#include "facenav/volume/nifti.h"
#include "interop_fixtures.h"

namespace facenav::interop::testing {

inline void patchFloats(const std::filesystem::path& nii, std::streamoff offset,
                        const std::vector<float>& values) {
  std::fstream stream(nii, std::ios::in | std::ios::out | std::ios::binary);
  stream.seekp(offset);
  stream.write(reinterpret_cast<const char*>(values.data()), std::streamsize(values.size() * sizeof(float)));
}

/// Writes the file, with the qform at the made T1's place and the sform turned and moved.
inline T1 writeTwoForms(const std::filesystem::path& nii) {
  volume::Volume image;
  image.grid = readT1(made("t1_lpi.nii.gz")).grid;
  image.voxels.assign(image.grid.count(), 1.f);
  volume::writeNifti(image, nii);
  Eigen::Affine3d moved = image.grid.mri_from_voxel;
  moved.linear() = expRotation({0.05, -0.08, 0.12}) * moved.linear();
  moved.translation() += Eigen::Vector3d(4, -7, 11);
  constexpr std::streamoff kRowsOfSform = 280;  // srow_x of nifti1.h
  std::vector<float> rows;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column) rows.push_back(float(moved(row, column)));
  patchFloats(nii, kRowsOfSform, rows);
  return readT1(nii);
}

inline CaseHead headOf(const T1& t1) {
  CaseHead head;
  head.t1 = t1;
  head.centre_mm = t1.grid.centre().mm;
  return head;
}

}  // namespace facenav::interop::testing
