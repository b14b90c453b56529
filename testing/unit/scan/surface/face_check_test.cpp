#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "facenav/segmentation/segmenter.h"
#include "facenav/surface/scalp_surface.h"
#include "facenav/volume/nifti.h"
#include "facenav/volume/regrid.h"
#include "support/test_data.h"

namespace facenav::surface {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using volume::Volume;

ScalpSurface scalpOf(const Volume& volume) {
  TaskMonitor monitor;
  return extractScalp(volume, segmentation::makeHeadSegmenter()->segment(volume, monitor).mask, monitor);
}

const Volume& virtualPatient() {
  static const Volume coarse = [] {
    const Volume full = volume::readNifti(facenav::testing::virtualPatientMri()).volume;
    return volume::resample(full, volume::isotropicGrid(full.grid, 1.5));
  }();
  return coarse;
}
const ScalpSurface& virtualPatientsScalp() {
  static const ScalpSurface scalp = scalpOf(virtualPatient());
  return scalp;
}

/// Sets voxels to 0 where `is_removed` is true for their position in Mri.
Volume without(Volume volume, const std::function<bool(const Eigen::Vector3d&)>& is_removed) {
  for (int k = 0; k < volume.grid.size[2]; ++k)
    for (int j = 0; j < volume.grid.size[1]; ++j)
      for (int i = 0; i < volume.grid.size[0]; ++i)
        if (is_removed(volume.grid.toMri({double(i), double(j), double(k)}).mm))
          volume.voxels[volume.grid.index(i, j, k)] = 0;
  return volume;
}

TEST(FaceCheck, FindsTheFaceOfAWholeHeadAndItsCutNoseTip) {
  FACENAV_NEEDS(facenav::testing::virtualPatientMri());
  const auto scalp = scalpOf(volume::readNifti(facenav::testing::virtualPatientMri()).volume);
  EXPECT_TRUE(scalp.has_face);
  EXPECT_THAT(scalp.findings, Contains(HasSubstr("nose tip is cut")));
  EXPECT_THAT(scalp.findings, Not(Contains(HasSubstr("scan ends"))));
}

TEST(FaceCheck, AcceptsAScanThatEndsAtMidNoseWithCaution) {
  FACENAV_NEEDS(facenav::testing::colin27());
  const auto scalp = scalpOf(volume::readNifti(facenav::testing::colin27()).volume);
  EXPECT_TRUE(scalp.has_face);
  EXPECT_THAT(scalp.findings, Contains(HasSubstr("scan ends at mid-nose")));
}

/// Removes everything below `z_mm` from the scan.
Volume endingAt(const Volume& scan, double z_mm) {
  const Volume whole = volume::toRasOrder(scan);
  Volume cut = whole;
  const int first = int(std::lround(
      whole.grid.toVoxel(Point<Mri>(whole.grid.centre().mm.x(), whole.grid.centre().mm.y(), z_mm)).z()));
  cut.grid.size[2] -= first;
  cut.grid.mri_from_voxel.translation() = whole.grid.toMri({0.0, 0.0, double(first)}).mm;
  cut.voxels.assign(whole.voxels.begin() + std::ptrdiff_t(whole.grid.index(0, 0, first)), whole.voxels.end());
  return cut;
}

TEST(FaceCheck, AcceptsScansThatEndBelowTheNose) {
  FACENAV_NEEDS(facenav::testing::virtualPatientMri());
  const Volume& whole = virtualPatient();
  double top = -1e9;
  for (const auto& v : virtualPatientsScalp().mesh.vertices_mm) top = std::max(top, v.z());
  const auto lip = scalpOf(endingAt(whole, top - 170));
  EXPECT_TRUE(lip.has_face);
  EXPECT_THAT(lip.findings, Contains(HasSubstr("scan ends at the upper lip")));
  const auto nose = scalpOf(endingAt(whole, top - 134));
  EXPECT_TRUE(nose.has_face);
  EXPECT_THAT(nose.findings, Contains(HasSubstr("scan ends at mid-nose")));
}

TEST(FaceCheck, SeesThatTheFaceWasCutAway) {
  FACENAV_NEEDS(facenav::testing::virtualPatientMri());
  const Volume& whole = virtualPatient();
  double top = -1e9, front = -1e9;
  for (const auto& v : virtualPatientsScalp().mesh.vertices_mm)
    top = std::max(top, v.z()), front = std::max(front, v.y());
  const double brow_z = top - 95;
  const auto box =
      scalpOf(without(whole, [&](const Eigen::Vector3d& p) { return p.z() < brow_z && p.y() > front - 65; }));
  EXPECT_FALSE(box.has_face) << "a box set to zero";
  EXPECT_FALSE(box.findings.empty());
  const auto shear = scalpOf(without(whole, [&](const Eigen::Vector3d& p) {
    return (p.y() - (front - 22)) + 0.55 * (brow_z - p.z()) > 0 && p.z() < brow_z + 30;
  }));
  EXPECT_FALSE(shear.has_face) << "sheared off by an oblique plane";
  const auto above = scalpOf(without(whole, [&](const Eigen::Vector3d& p) { return p.z() < brow_z + 5; }));
  EXPECT_FALSE(above.has_face) << "the scan ends at the brow";
}

}  // namespace
}  // namespace facenav::surface
