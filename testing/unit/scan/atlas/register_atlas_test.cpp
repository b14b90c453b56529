// Colin27, moved and warped by a known map, replaces a patient. The registration must find the map.

#include "facenav/atlas/register_atlas.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "facenav/core/error.h"
#include "support/test_data.h"

namespace facenav::atlas {
namespace {

/// mni_from_mri of the synthetic patient: an affine and a smooth warp of up to 7 mm.
Eigen::Vector3d toTemplate(const Eigen::Vector3d& mri_mm) {
  static const Eigen::Affine3d kAffine =
      Eigen::Affine3d(Eigen::Translation3d(14, -9, 21) *
                      Eigen::AngleAxisd(0.22, Eigen::Vector3d(1, 0.3, -0.2).normalized()) *
                      Eigen::Scaling(1.06, 0.93, 1.08))
          .inverse();
  const Eigen::Vector3d x = kAffine * mri_mm;
  return x +
         Eigen::Vector3d(4 * std::sin(x.y() / 19), 5 * std::sin(x.z() / 23 + 1), 4 * std::cos(x.x() / 21));
}

struct MadePatient {
  volume::Volume mri;
  volume::Mask brain;
};

/// Makes the patient with a bias field of +-30 %.
MadePatient madePatient(const volume::Volume& brain) {
  MadePatient patient;
  auto& grid = patient.mri.grid;
  grid.size = {104, 116, 104};
  grid.mri_from_voxel = Eigen::Translation3d(-92, -124, -70) * Eigen::Scaling(1.9);
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i) {
        const Eigen::Vector3d at = toTemplate(grid.mri_from_voxel * Eigen::Vector3d(i, j, k));
        const float value = volume::sampleLinear(brain, brain.grid.mri_from_voxel.inverse() * at);
        patient.mri.voxels.push_back(value * float(1 + 0.3 * std::sin(at.x() / 50)));
        patient.brain.voxels.push_back(value > 1);
      }
  patient.brain.grid = grid;
  return patient;
}

/// Errors at all labelled points of the cortex and the deep nuclei, sorted.
std::vector<double> errors_mm(const AtlasMap& map, const LabelMap& labels) {
  std::vector<double> errors;
  const auto& grid = labels.labels.grid;
  for (int k = 0; k < grid.size[2]; k += 5)
    for (int j = 0; j < grid.size[1]; j += 5)
      for (int i = 0; i < grid.size[0]; i += 5) {
        if (labels.labels.at(i, j, k) == 0) continue;
        const Eigen::Vector3d mni_mm = grid.mri_from_voxel * Eigen::Vector3d(i, j, k);
        errors.push_back((toTemplate(map.toMri(Point<Mni>(mni_mm)).mm) - mni_mm).norm());
      }
  std::sort(errors.begin(), errors.end());
  return errors;
}

TEST(RegisterAtlas, FindsAKnownWarpThroughABiasField) {
  FACENAV_NEEDS(testing::colin27());
  const auto colin = readColin27();
  const auto patient = madePatient(colin.brain);
  TaskMonitor monitor;
  AtlasOptions options;
  options.spacing_mm = 3;
  const auto fit = registerAtlas(patient.mri, patient.brain, colin, options, monitor);
  const auto errors = errors_mm(fit.map, colin.aal);
  ASSERT_GT(errors.size(), 5000u);
  RecordProperty("median_mm", std::to_string(errors[errors.size() / 2]));
  RecordProperty("p95_mm", std::to_string(errors[errors.size() * 95 / 100]));
  EXPECT_LT(errors[errors.size() / 2], 1.0);
  EXPECT_LT(errors[errors.size() * 90 / 100],
            3.0);  // p95 is 3.6 mm
  EXPECT_GT(fit.quality.correlation, fit.quality.correlation_affine + 0.1);
  EXPECT_GT(fit.quality.smallest_jacobian, 0.1);
  EXPECT_TRUE(fit.quality.isUsable());
}

TEST(RegisterAtlas, AnEmptyMaskIsRefused) {
  FACENAV_NEEDS(testing::colin27());
  const auto colin = readColin27();
  volume::Mask empty{colin.brain.grid, std::vector<std::uint8_t>(colin.brain.grid.count(), 0)};
  TaskMonitor monitor;
  EXPECT_THROW(registerAtlas(colin.brain, empty, colin, {}, monitor), Error);
}

}  // namespace
}  // namespace facenav::atlas
