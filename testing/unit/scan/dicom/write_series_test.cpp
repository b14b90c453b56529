#include "compare_volumes.h"
#include "facenav/core/error.h"
#include "facenav/dicom/import_volume.h"

namespace facenav::testing {
namespace {

volume::Volume oddVolume(const Eigen::Matrix3d& steps_mm, float lowest = 0) {
  volume::Volume volume;
  volume.grid.size = {17, 12, 9};
  volume.grid.mri_from_voxel.linear() = steps_mm;
  volume.grid.mri_from_voxel.translation() = Eigen::Vector3d(12.5, -31.25, 7.125);
  for (std::size_t i = 0; i < volume.grid.count(); ++i)
    volume.voxels.push_back(lowest + float(i * 37 % 30011));
  return volume;
}

volume::Volume roundTrip(const volume::Volume& volume, const std::filesystem::path& folder) {
  dicom::writeSeries(volume, folder, {});
  TaskMonitor monitor;
  return dicom::importVolume(folder, std::nullopt, monitor).volume;
}

TEST(WriteSeries, EveryAxisOrderAndFlipComesBack) {
  const bool has_other = hasProgram("dcm2niix");
  constexpr int kOrders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
  for (int o = 0; o < 6; ++o)
    for (int signs = 0; signs < 8; ++signs) {
      SCOPED_TRACE(std::to_string(o) + " signs " + std::to_string(signs));
      Eigen::Matrix3d steps = Eigen::Matrix3d::Zero();
      const double spacing[3] = {0.9, 1.1, 1.3};
      for (int a = 0; a < 3; ++a) steps(kOrders[o][a], a) = (signs >> a & 1 ? -1 : 1) * spacing[a];
      const TemporaryFolder folder;
      const auto volume = oddVolume(steps);
      expectSameInWorld(roundTrip(volume, folder.path() / "s"), volume);
      if (has_other &&
          o == signs % 6) {  // the independent reader on a third of them, since each takes a process
        const auto other = dcm2niixVolume(folder.path() / "s");
        ASSERT_TRUE(other);
        expectSameInWorld(*other, volume);
      }
    }
}

TEST(WriteSeries, ObliqueMirroredAndNegativeComesBack) {
  const Eigen::Matrix3d r = (Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()) *
                             Eigen::AngleAxisd(-0.2, Eigen::Vector3d::UnitY()))
                                .toRotationMatrix();
  for (const double mirror : {1.0, -1.0}) {
    const TemporaryFolder folder;
    const auto volume = oddVolume(r * Eigen::Vector3d(mirror * 0.7, 0.68, 1.37).asDiagonal(), -900);
    expectSameInWorld(roundTrip(volume, folder.path() / "s"), volume);
    if (!hasProgram("dcm2niix")) continue;
    const auto other = dcm2niixVolume(folder.path() / "s");
    ASSERT_TRUE(other);
    expectSameInWorld(*other, volume);
  }
}

TEST(WriteSeries, SameVolumeGivesTheSameFiles) {
  const TemporaryFolder folder;
  const auto volume = oddVolume(Eigen::Matrix3d::Identity());
  dicom::writeSeries(volume, folder.path() / "a", {});
  dicom::writeSeries(volume, folder.path() / "b", {});
  EXPECT_EQ(
      std::system(("diff -r '" + folder.path().string() + "/a' '" + folder.path().string() + "/b'").c_str()),
      0);
}

TEST(WriteSeries, LeavesNothingWhereItCannotWriteAll) {
  const TemporaryFolder folder;
  auto volume = oddVolume(Eigen::Matrix3d::Identity());
  volume.voxels[5] = 70000;
  EXPECT_THROW(dicom::writeSeries(volume, folder.path() / "a", {}), Error);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  volume = oddVolume((Eigen::Matrix3d() << 1, 0.2, 0, 0, 1, 0, 0, 0, 1).finished());
  EXPECT_THROW(dicom::writeSeries(volume, folder.path() / "a", {}), Error);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(WriteSeries, DoesNotWriteIntoAFolderThatHoldsSomething) {
  const TemporaryFolder folder;
  const auto volume = oddVolume(Eigen::Matrix3d::Identity());
  dicom::writeSeries(volume, folder.path() / "a", {});
  EXPECT_THROW(dicom::writeSeries(volume, folder.path() / "a", {}), Error);
}

}  // namespace
}  // namespace facenav::testing
