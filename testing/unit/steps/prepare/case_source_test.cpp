#include "facenav/prepare/case_source.h"

#include <gmock/gmock.h>

#include "facenav/casefile/sha256.h"
#include "facenav/core/error.h"
#include "support/ball_case.h"
#include "support/test_data.h"

namespace facenav::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class CaseSource : public ::testing::Test {
 protected:
  /// A case of the ball whose source has the series UID `uid`; empty: an older case.
  casefile::CaseStore caseFrom(const std::string& uid) {
    casefile::Provenance step{"prepare", "1", {}, {{"input", "0"}}};
    if (!uid.empty()) step.input_sha256[steps::kSeriesUidHash] = casefile::sha256OfText(uid);
    return casefile::CaseStore::create(folder_.path() / "case", ballCase(), {step}, true);
  }
  /// Writes the ball as DICOM, one voxel changed if wanted; returns its UID.
  std::string writeSource(const std::string& name, bool is_changed) {
    auto mri = ballCase().mri;
    if (is_changed) mri.voxels[4711] += 1;
    dicom::writeSeries(mri, folder_.path() / "dicom" / name, {});
    TaskMonitor monitor;
    return dicom::listSeries(folder_.path() / "dicom" / name, monitor).at(0).series_uid;
  }
  std::string refusal(const casefile::CaseStore& store) {
    try {
      steps::sourceOf(store, folder_.path() / "dicom", monitor_);
    } catch (const Error& error) {
      return error.what();
    }
    return "nothing";
  }
  TemporaryFolder folder_;
  TaskMonitor monitor_;
};

TEST_F(CaseSource, IsFoundAmongOthers) {
  writeSource("a", true);
  const auto uid = writeSource("b", false);
  for (const auto& known : {uid, std::string()}) {
    const auto found = steps::sourceOf(caseFrom(known), folder_.path() / "dicom", monitor_);
    EXPECT_EQ(found.series.series_uid, uid);
    EXPECT_EQ(found.volume.voxels, ballCase().mri.voxels);
  }
}

TEST_F(CaseSource, IsKnownInAnotherOrderOfItsVoxels) {
  auto turned = ballCase().mri;  // as a NIfTI whose rows another program turned round
  auto& grid = turned.grid;
  grid.mri_from_voxel.translation() += grid.mri_from_voxel.linear() * Eigen::Vector3d(0, grid.size[1] - 1, 0);
  grid.mri_from_voxel.linear().col(1) *= -1;
  turned.voxels[grid.index(10, 20, 30)] = 77;  // the ball alone is the same in both orders
  dicom::writeSeries(turned, folder_.path() / "dicom" / "a", {});
  auto prepared = ballCase();
  prepared.mri.voxels[grid.index(10, grid.size[1] - 1 - 20, 30)] = 77;
  const auto store = casefile::CaseStore::create(folder_.path() / "case", prepared, {}, false);
  const auto found = steps::sourceOf(store, folder_.path() / "dicom", monitor_).volume;
  EXPECT_EQ(*volume::valueAt(found, grid.toMri(Eigen::Vector3d(10, 20, 30))), 77);
  prepared.mri.voxels[grid.index(10, 20, 30)] = 78;
  const auto other = casefile::CaseStore::create(folder_.path() / "other", prepared, {}, false);
  EXPECT_THAT(refusal(other), HasSubstr("no series with the voxels of the case's MRI"));
}

TEST_F(CaseSource, AnotherUidOrOneOtherVoxelIsRefused) {
  const auto changed = writeSource("a", true);
  EXPECT_THAT(refusal(caseFrom("")), HasSubstr("no series with the voxels of the case's MRI"));
  EXPECT_THAT(refusal(caseFrom(changed)), HasSubstr("no series with the voxels of the case's MRI"));
  writeSource("b", false);
  EXPECT_THAT(refusal(caseFrom("1.2.3")), HasSubstr("no series with the Series Instance UID"));
}

}  // namespace
}  // namespace facenav::testing
